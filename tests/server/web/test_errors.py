"""Whatever goes wrong is answered in one shape, in the reader's language, and never with a traceback."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import anyio
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from starlette.testclient import TestClient

from server.app import create_app
from server.settings import Settings
from server.storage import StorageUnavailable
from server.web import envelope
from server.web.errors import Refused
from tests.depth import amount

JSON = {"content-type": "application/json"}
KEYS = {"code", "message", "field", "position", "opens", "request_id"}


def failure(reply: Any) -> dict[str, Any]:
    body: dict[str, Any] = reply.json()
    assert set(body) == {"error"} and set(body["error"]) == KEYS
    assert body["error"]["request_id"] == reply.headers["x-request-id"]
    assert "Traceback" not in reply.text
    return {"status": reply.status_code, **body["error"]}


VALUES = ("3", "true", "NaN", "null", "{}", "[1]")
BODIES: list[tuple[str | bytes, str, str | None]] = [
    ("{", "malformed_json", None),
    ("[" * 60_000, "malformed_json", None),
    (b"\xff\xfe{}", "malformed_json", None),
    ("[]", "no_object", None),
    ("", "no_object", None),
    ('"answers"', "no_object", None),
    ("{}", "missing_field", "answers"),
    ('{"answers": []}', "wrong_type", "answers"),
    *((f'{{"answers": {{"l3": {value}}}}}', "wrong_type", "answers.l3") for value in VALUES),
    ('{"answers": {"l3": "\\ud800"}}', "bad_text", "answers.l3"),
    ('{"answers": {"\\ud800": ""}}', "bad_text", "answers.\ufffd\ufffd\ufffd"),
    ('{"answers": {}, "score": 1}', "extra_field", "score"),
    ('{"answers": {"zz": "1"}}', "unknown_answer", "answers.zz"),
    ('{"answers": {"": "1"}}', "unknown_answer", "answers."),
    ('{"answers": {"l3\\u0000": "1"}}', "unknown_answer", "answers.l3\ufffd"),
]


@pytest.mark.parametrize(("body", "code", "field"), BODIES)
def test_a_body_that_does_not_fit_is_refused_by_name(
    client: TestClient, deal: Callable[..., str], body: str | bytes, code: str, field: str | None
) -> None:
    reply = client.post(f"/api/v1/variants/{deal()}/submissions", content=body, headers=JSON)
    found = failure(reply)
    assert (found["status"], found["code"], found["field"]) == (422, code, field)


def test_broken_json_is_refused_with_its_place(client: TestClient, deal: Callable[..., str]) -> None:
    reply = client.post(f"/api/v1/variants/{deal()}/submissions", content='{"answers": x}', headers=JSON)
    assert failure(reply)["position"] == 12


@pytest.mark.parametrize("seed", ["-1", "9007199254740992", "1.0", "true", '"7"', "NaN", "null,", "1e3"])
def test_a_seed_that_is_none_is_refused(client: TestClient, seed: str) -> None:
    reply = client.post("/api/v1/exercises/slider_crank/variants", content=f'{{"seed": {seed}}}', headers=JSON)
    assert failure(reply)["status"] == 422


@pytest.mark.parametrize(
    ("path", "code"),
    [
        ("/api/v1/exercises/none", "unknown_exercise"), ("/api/v1/exercises/..%2f..", "not_found"),
        ("/api/v1/variants/x", "unknown_variant"), ("/api/v1/variants/AAAA-AAAA-AAAA", "unknown_variant"),
        ("/api/v1/variants/%00", "unknown_variant"), ("/api/v1/submissions/AAAA-AAAA-AAAA", "unknown_submission"),
        ("/api/v1/submissions/%ff", "unknown_submission"), ("/api/v1/", "not_found"), ("/nowhere", "not_found"),
    ],
)  # fmt: skip
def test_what_is_not_there_is_not_found(client: TestClient, path: str, code: str) -> None:
    found = failure(client.get(path))
    assert (found["status"], found["code"]) == (404, code)


@pytest.mark.parametrize(("path", "status"), [("/health", 200), ("/", 200), ("/static/mark.svg", 200), ("/no", 404)])
def test_a_look_at_the_headers_is_answered_like_the_page_without_its_body(
    client: TestClient, path: str, status: int
) -> None:
    whole, bare = client.get(path), client.head(path)
    assert (whole.status_code, bare.status_code, bare.content) == (status, status, b"")
    assert bare.headers["content-type"] == whole.headers["content-type"]


def test_another_method_is_refused(client: TestClient) -> None:
    found = failure(client.delete("/api/v1/exercises", headers={"x-http-method-override": "GET"}))
    assert (found["status"], found["code"]) == (405, "method_not_allowed")


@pytest.mark.parametrize(("language", "word"), [("pl", "zadania"), ("en", "exercise"), ("ru", "задачи")])
def test_an_error_is_worded_in_the_reader_s_language(client: TestClient, language: str, word: str) -> None:
    assert word in failure(client.get("/api/v1/exercises/none", headers={"accept-language": language}))["message"]
    assert word in failure(client.get(f"/api/v1/exercises/none?lang={language}"))["message"]


def test_a_browser_gets_a_page_and_no_reflection(client: TestClient) -> None:
    attack = "/<script>alert(1)</script>?lang=en"
    reply = client.get(attack, headers={"accept": "text/html"})
    assert reply.status_code == 404 and reply.headers["content-type"].startswith("text/html")
    assert "alert(1)" not in reply.text and reply.headers["x-request-id"] in reply.text
    assert "Nothing you have a receipt for is lost." in reply.text


def test_a_body_that_is_too_large_is_refused_while_it_is_read(client: TestClient, deal: Callable[..., str]) -> None:
    path = f"/api/v1/variants/{deal()}/submissions"
    declared = client.post(path, content=b" " * 70_000, headers=JSON)

    def endless() -> Any:
        while True:
            yield b" " * 1024

    for reply in (declared, client.post(path, content=_bounded(endless()), headers=JSON)):
        assert (failure(reply)["status"], failure(reply)["code"]) == (413, "too_large")


def _bounded(parts: Any) -> Any:
    for _ in range(100):
        yield next(parts)


def test_a_body_that_never_ends_is_refused_in_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(envelope, "SLOWEST_BODY", 0.05)

    async def never() -> Any:
        await anyio.sleep(10)

    async def read() -> str:
        with pytest.raises(Refused) as refused:
            await envelope.bounded({"path": "/", "headers": []}, never)()
        return refused.value.code

    assert anyio.run(read) == "too_slow"


class Broken:
    """A store that has gone away."""

    def __getattr__(self, name: str) -> Callable[..., Any]:
        async def fail(*args: Any) -> Any:
            raise StorageUnavailable("gone")

        return fail


def break_store(client: TestClient, storage: Any) -> None:
    state = client.app.state  # type: ignore[attr-defined]
    state.bench = replace(state.bench, storage=storage)


def test_without_the_store_nothing_is_acknowledged_and_a_time_is_given(client: TestClient) -> None:
    break_store(client, Broken())
    for reply in (
        client.get("/ready"),
        client.post("/api/v1/exercises/slider_crank/variants"),
        client.get("/api/v1/variants/AAAA-AAAA-AAAA"),
    ):
        assert (failure(reply)["status"], failure(reply)["code"]) == (503, "unavailable")
        assert int(reply.headers["retry-after"]) > 0
    assert client.get("/health").status_code == 200


def test_a_fault_of_ours_shows_its_number_and_nothing_else(
    client: TestClient, caplog: pytest.LogCaptureFixture
) -> None:
    class Faulty:
        """A store with a bug."""

        async def variant(self, number: str) -> None:
            raise RuntimeError("a secret detail")

    break_store(client, Faulty())
    reply = client.get("/api/v1/variants/AAAA-AAAA-AAAA")
    found = failure(reply)
    assert (found["status"], found["code"]) == (500, "our_fault")
    assert "secret detail" not in reply.text
    assert found["request_id"] in caplog.text and "secret detail" in caplog.text
    page = client.get("/variants/AAAA-AAAA-AAAA", headers={"accept": "text/html"})
    assert page.status_code == 500 and "secret detail" not in page.text


HEADERS = ("content-security-policy", "x-content-type-options", "referrer-policy", "x-frame-options", "x-request-id")


@pytest.mark.parametrize("path", ["/", "/api/v1/exercises", "/static/mark.svg", "/nowhere", "/api/v1/openapi.json"])
def test_every_response_carries_the_security_headers(client: TestClient, path: str) -> None:
    headers = client.get(path).headers
    assert all(name in headers for name in HEADERS)
    policy = headers["content-security-policy"]
    assert "unsafe" not in policy and "default-src 'none'" in policy and "frame-ancestors 'none'" in policy
    assert "access-control-allow-origin" not in headers


def test_what_is_made_for_one_reader_is_not_kept_on_its_way(client: TestClient) -> None:
    assert client.get("/api/v1/exercises").headers["cache-control"] == "no-store"


def test_https_is_kept(settings: Settings) -> None:
    with TestClient(create_app(replace(settings, public_url="https://grubler.example"))) as client:
        reply = client.post("/api/v1/exercises/slider_crank/variants", headers={"origin": "https://grubler.example"})
    assert "strict-transport-security" in reply.headers
    cookie = reply.headers["set-cookie"]
    assert cookie.startswith("__Host-") and "Secure" in cookie and "HttpOnly" in cookie and "Path=/" in cookie


TEXTS = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=8), inner, max_size=3),
    max_leaves=6,
)


@settings(max_examples=amount(10, 30), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(answers=TEXTS, extra=st.dictionaries(st.text(max_size=8), TEXTS, max_size=2))
def test_no_body_brings_the_server_down(
    client: TestClient, deal: Callable[..., str], answers: Any, extra: dict[str, Any]
) -> None:
    body = json.dumps({"answers": answers} | extra)
    reply = client.post(f"/api/v1/variants/{deal()}/submissions", content=body, headers=JSON)
    assert reply.status_code in (201, 422), reply.text


@settings(max_examples=amount(10, 30), deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(text=st.text(max_size=200))
def test_no_text_brings_the_judging_down(client: TestClient, deal: Callable[..., str], text: str) -> None:
    number, answers = deal(), {"l3": text, "omega2_formula": text}
    reply = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": answers})
    assert reply.status_code == 201
    assert "fault" not in {verdict["outcome"] for verdict in reply.json()["verdicts"].values()}
    assert reply.json()["answers"] == answers
    assert client.get(f"/variants/{number}").status_code == 200


def test_the_description_names_our_own_shape_for_every_error(client: TestClient) -> None:
    described = client.get("/api/v1/openapi.json").json()
    assert not {"HTTPValidationError", "ValidationError"} & set(described["components"]["schemas"])
    for path, methods in described["paths"].items():
        for method, operation in methods.items():
            for status, response in operation["responses"].items():
                if int(status) >= 400:
                    schema = response["content"]["application/json"]["schema"]
                    assert schema == {"$ref": "#/components/schemas/Failure"}, f"{method} {path} {status}"


def test_every_shape_of_the_description_has_a_name_of_its_own(client: TestClient) -> None:
    shapes = client.get("/api/v1/openapi.json").json()["components"]["schemas"]
    assert [name for name in shapes if "__" in name] == []  # two of one name are told apart by the paths of our modules


def test_a_closed_solution_says_what_opens_it(client: TestClient, deal: Callable[..., str]) -> None:
    refused = client.get(f"/api/v1/variants/{deal()}/solution")
    assert refused.status_code == 403 and refused.json()["error"]["opens"] == "first_counted_submission"
