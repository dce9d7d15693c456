"""Reports over HTTP: the owner's own, as a file of each format, refused where there is none."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from exercises.grading import reference
from exercises.variants import deal
from reports.formats import MEDIA


def dealt(client: TestClient, exercise: str = "tmm2_oop", seed: int = 7) -> str:
    return str(client.post(f"/api/v1/exercises/{exercise}/variants", json={"seed": seed}).json()["id"])


@pytest.mark.parametrize("form", MEDIA)
def test_a_report_comes_as_a_file(client: TestClient, form: str) -> None:
    reply = client.get(f"/api/v1/reports/tmm2/{dealt(client)}.{form}?lang=pl&name=Anna&group=M2")
    assert reply.status_code == 200 and reply.headers["content-type"] == MEDIA[form]
    assert reply.headers["content-disposition"] == f'attachment; filename="tmm-2.{form}"'
    assert len(reply.content) > 1000


def test_a_report_with_a_receipt_holds_the_answers(client: TestClient) -> None:
    number = dealt(client)
    answers = reference(deal("tmm2_oop", 7)) | {"conclusions": "Ruch jest płynny."}
    receipt = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": answers}).json()["receipt"]["id"]
    written = client.get(f"/api/v1/reports/tmm2/{number}.md?lang=pl&receipt={receipt}").text
    assert "Ruch jest płynny" in written and receipt[:8] in written.replace("\\", "")
    other = dealt(client, seed=8)
    assert client.get(f"/api/v1/reports/tmm2/{other}.md?receipt={receipt}").status_code == 404


def test_somebody_elses_report_is_not_there(client: TestClient) -> None:
    number = dealt(client)
    client.cookies.clear()
    assert client.get(f"/api/v1/reports/tmm2/{number}.pdf").status_code == 404


@pytest.mark.parametrize(
    ("exercise", "path", "status", "code"),
    [
        ("simple_beam", "{}.pdf", 404, "no_report"),
        ("tmm2_oop", "{}.exe", 422, "schema"),
        ("tmm2_oop", "{}.pdf?name=" + "x" * 81, 422, "schema"),
        ("tmm2_oop", "{}.pdf?receipt=none", 404, "unknown_submission"),
    ],
)
def test_what_is_no_report_is_refused(client: TestClient, exercise: str, path: str, status: int, code: str) -> None:
    reply = client.get("/api/v1/reports/tmm2/" + path.format(dealt(client, exercise)))
    assert reply.status_code == status
    if code != "schema":
        assert reply.json()["error"]["code"] == code
