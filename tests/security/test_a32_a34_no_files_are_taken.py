"""A32, A34: one route takes a file, a roster, as text alone; no archive is opened, and every response has its type."""

from __future__ import annotations

import io
import re
import zipfile
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from tests.server.school import School

ROOT = Path(__file__).parents[2]
READERS = re.compile(r"\b(?:tarfile|shutil\.unpack_archive|UploadFile|extractall|py7zr|rarfile)\b")
SVG = b'<svg xmlns="http://www.w3.org/2000/svg" onload="alert(1)"><script>1</script></svg>'


def zipped() -> bytes:
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w") as archive:
        archive.writestr("../../etc/passwd", "x")
    return held.getvalue()


@pytest.mark.parametrize("content", [SVG, zipped()], ids=["svg", "zip"])
def test_an_uploaded_file_is_no_form(client: TestClient, content: bytes) -> None:
    path = f"/variants/{client.headers['x-variant']}"
    files = {"answer.l3": ("../../x.svg", content, "image/svg+xml")}
    reply = client.post(path, files=files, headers={"origin": "http://testserver"}, follow_redirects=False)
    assert reply.status_code in (303, 413, 415, 422)
    assert b"onload" not in client.get(path).content


HTML = b"<!doctype html><script>alert(1)</script><iframe src='//evil.example'></iframe>"


def test_a_file_sent_as_a_roster_is_text_that_is_shown_escaped_and_kept_nowhere(school: School) -> None:
    lecturer, before = school.browser("lecturer"), files_of(school)
    for content in (SVG, HTML, zipped()):
        for name in ("../../../etc/passwd", "<script>alert(2)</script>.csv", "a\\b.html"):
            path, sent = f"/courses/{school.course}/roster", {"file": (name, content, "image/svg+xml")}
            reply = lecturer.post(path, files=sent, headers={"accept": "text/html"})
            assert reply.headers["content-type"].startswith("text/html") and reply.status_code in (200, 422)
            assert not re.search(r"<script>alert|<iframe|<svg[^>]*onload|passwd", reply.text)
    assert files_of(school) == before


def files_of(school: School) -> set[str]:
    return {file.name for file in school.bench.settings.data_dir.rglob("*") if "-wal" not in file.name}


def test_no_room_unpacks_an_archive_that_it_did_not_make() -> None:
    for room in ("server", "exercises", "graders", "mechanics", "figures", "cli"):
        for file in (ROOT / room).rglob("*.py"):
            assert not READERS.search(file.read_text("utf-8")), file


def test_what_is_served_is_not_sniffed(client: TestClient) -> None:
    for path in ("/", "/health", "/static/mark.svg", "/no-such-page"):
        assert client.get(path).headers["x-content-type-options"] == "nosniff"
