"""Pages find what the asset build has made, and live without it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from server.app import create_app
from server.settings import Settings
from server.web import static_files
from server.web.static_files import Assets, Static, find

MANIFEST = {"main.ts": {"file": "main-1.js", "css": ["main-2.css"], "isEntry": True}}


@pytest.mark.parametrize("name", ["manifest.json", ".vite/manifest.json"])
def test_the_manifest_tells_style_and_script(tmp_path: Path, name: str) -> None:
    place = tmp_path / "build" / name
    place.parent.mkdir(parents=True)
    place.write_text(json.dumps(MANIFEST))
    assert find(tmp_path) == Assets(("/static/build/main-2.css",), "/static/build/main-1.js")


def test_without_a_build_pages_say_so_and_work(
    settings: Settings, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(static_files, "find", lambda: find(tmp_path / "nothing"))
    with TestClient(create_app(settings)) as client:
        page = client.get("/", headers={"accept-language": "en"})
    assert page.status_code == 200
    assert "are not built" in page.text
    assert "<script" not in page.text and "stylesheet" not in page.text


def test_built_files_are_kept_for_good_and_others_for_an_hour(tmp_path: Path) -> None:
    (tmp_path / "build").mkdir()
    (tmp_path / "build" / "main-1.js").write_text("1")
    (tmp_path / "mark.svg").write_text("<svg/>")
    client = TestClient(Static(tmp_path))
    assert "immutable" in client.get("/build/main-1.js").headers["cache-control"]
    assert client.get("/mark.svg").headers["cache-control"] == "public, max-age=3600"


def test_nothing_outside_the_folder_is_served(client: TestClient) -> None:
    for path in ("/static/../app.py", "/static/%2e%2e/app.py", "/static/..%2fapp.py", "/static/", "/static/none.css"):
        assert client.get(path).status_code == 404, path


def test_text_travels_packed_to_those_who_can_unpack_it(client: TestClient) -> None:
    assets = static_files.find()
    for address in (*assets.styles, assets.script):
        packed = client.get(str(address))
        plain = client.get(str(address), headers={"accept-encoding": "identity"})
        assert packed.headers["content-encoding"] == "gzip" and "content-encoding" not in plain.headers
        assert packed.content == plain.content and packed.headers["content-type"] == plain.headers["content-type"]
        assert int(packed.headers["content-length"]) * 2 < int(plain.headers["content-length"])
    font = client.get(assets.fonts[0])
    assert "content-encoding" not in font.headers


def test_a_part_of_a_file_is_given_as_it_lies(client: TestClient) -> None:
    part = client.get(str(static_files.find().script), headers={"range": "bytes=0-9"})
    assert part.status_code == 206 and len(part.content) == 10
