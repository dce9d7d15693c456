"""`grubler export` and `grubler erase` on the store of a server."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.cli.calling import run


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> str:
    """A store in which anna teaches and root administers."""
    monkeypatch.delenv("DATABASE_URL", raising=False)
    for login, role in (("anna", "lecturer"), ("root", "administrator")):
        code, _, err = run(
            capsys, "user", "add", login, "--name", "Anna Nowak", "--role", role, "--data-dir", str(tmp_path)
        )
        assert code == 0, err
    return str(tmp_path)


def test_a_person_is_exported_and_erased(store: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, _ = run(capsys, "export", "--person", "ANNA", "--data-dir", store)
    told = json.loads(out)
    assert (code, told["person"]["name"], told["person"]["login"]) == (0, "Anna Nowak", "anna")
    code, _, err = run(capsys, "erase", "--person", "anna", "--data-dir", store)
    assert code == 2 and "--yes" in err
    code, number, _ = run(capsys, "erase", "--person", "anna", "--yes", "--data-dir", store)
    assert (code, number.strip()) == (0, told["person"]["id"])
    code, out, _ = run(capsys, "export", "--person", number.strip(), "--data-dir", store)
    left = json.loads(out)
    assert (left["person"]["name"], left["person"]["login"]) == (number.strip(), None)
    assert [act["action"] for act in left["acts"]] == ["link_made", "person_exported", "person_erased"]
    assert run(capsys, "export", "--person", "anna", "--data-dir", store)[0] == 2


def test_what_is_kept_of_a_person_has_no_pseudonym(store: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, out, err = run(capsys, "export", "--person", "anna", "--pseudonyms", "--data-dir", store)
    assert (code, out) == (2, "") and "--pseudonyms" in err


@pytest.mark.parametrize(("command", "who"), [("export", "nobody"), ("erase", "nobody"), ("erase", "root")])
def test_who_is_not_there_or_administers_is_unusable(
    store: str, capsys: pytest.CaptureFixture[str], command: str, who: str
) -> None:
    yes = ["--yes"] if command == "erase" else []
    code, out, err = run(capsys, command, "--person", who, *yes, "--data-dir", store)
    assert (code, out) == (2, "") and (who in err or "administrator" in err)


def test_the_audit_log_is_checked_and_its_end_kept_elsewhere(store: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, end, _ = run(capsys, "audit", "--data-dir", store)
    assert code == 0 and end.split()[0] == "2"
    run(capsys, "export", "--person", "anna", "--data-dir", store)
    assert run(capsys, "audit", "--end", end, "--data-dir", store)[0] == 0
    forged = f"1 {end.split()[1]}"
    assert run(capsys, "audit", "--end", forged, "--data-dir", store)[:2] == (
        1, "line 1 of the audit log does not fit: a line was changed or removed\n",
    )  # fmt: skip
    assert run(capsys, "audit", "--end", "none", "--data-dir", store)[0] == 2
