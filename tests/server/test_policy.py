"""Every route declares who may use it; whose variant it is decides the rest."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from fastapi import APIRouter, Depends
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.testclient import TestClient

from server import policy
from server.app import create_app
from server.people import tokens
from server.policy import POLICIES, Role, UndeclaredRoute
from server.reader import admit
from server.settings import Settings
from tests.server.conftest import SECRET

ROUTE = "/api/v1/marks"


def bearer(role: str, subject: str | None = None) -> dict[str, str]:
    return {"authorization": f"Bearer {tokens.issue(role, SECRET, subject=subject)}"}


@pytest.fixture
def guarded(settings: Settings, monkeypatch: pytest.MonkeyPatch) -> Iterator[TestClient]:
    """A server with one more route, for lecturers."""
    router = APIRouter(dependencies=[Depends(admit)])

    @router.get(ROUTE)
    async def marks() -> str:
        return "marks"

    app = create_app(settings)
    app.router.routes.extend(router.routes)
    monkeypatch.setitem(POLICIES, ("GET", ROUTE), Role.LECTURER)
    with TestClient(app) as client:
        yield client


def test_every_route_declares_its_policy_and_every_policy_has_its_route(settings: Settings) -> None:
    served = {
        (method, getattr(route, "path", ""))
        for route in create_app(settings).routes
        for method in (getattr(route, "methods", None) or ("GET",))
    }
    assert served == set(POLICIES)


@pytest.mark.parametrize(
    "missing", [("GET", "/health"), ("POST", "/api/v1/variants/{variant}/preview"), ("GET", "/static")]
)
def test_a_route_without_a_policy_stops_the_start(
    settings: Settings, monkeypatch: pytest.MonkeyPatch, missing: tuple[str, str]
) -> None:
    monkeypatch.delitem(POLICIES, missing)
    with pytest.raises(UndeclaredRoute, match=missing[1].replace("{", r"\{")):
        create_app(settings)


def test_a_route_that_cannot_be_looked_up_stops_the_start() -> None:
    with pytest.raises(UndeclaredRoute):
        policy.check([WebSocketRoute("/ws", lambda socket: None)])
    with pytest.raises(UndeclaredRoute):
        policy.check([Mount("/files", routes=[])])
    with pytest.raises(UndeclaredRoute):
        policy.check([Route("/health", lambda request: None, methods=["DELETE"])])


def test_a_route_that_lost_its_policy_is_refused_at_run_time(
    client: TestClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delitem(POLICIES, ("GET", "/health"))
    assert client.get("/health").status_code == 403


@pytest.mark.parametrize(
    ("role", "status"), [("student", 403), ("lecturer", 200), ("administrator", 200)]
)  # fmt: skip
def test_a_role_does_what_it_and_the_lower_ones_may(guarded: TestClient, role: str, status: int) -> None:
    assert guarded.get(ROUTE, headers=bearer(role)).status_code == status


def test_without_a_token_one_is_asked_for(guarded: TestClient) -> None:
    reply = guarded.get(ROUTE)
    assert (reply.status_code, reply.json()["error"]["code"]) == (401, "token_needed")


@pytest.mark.parametrize("header", ["Bearer x", "Bearer ", "Basic YTpi", "x", "Bearer " + "a" * 5000])
def test_a_bad_token_is_refused_even_where_none_is_needed(client: TestClient, header: str) -> None:
    reply = client.get("/api/v1/exercises", headers={"authorization": header})
    assert (reply.status_code, reply.json()["error"]["code"]) == (401, "bad_token")
    assert reply.headers["www-authenticate"] == "Bearer"


def test_another_reader_cannot_tell_a_foreign_variant_from_none(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    receipt = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {}}).json()["receipt"]["id"]
    for stranger in (bearer("student", "bob"), {"cookie": "grubler_practice=" + "x" * 43}, {}):
        client.cookies.clear()
        replies = [
            client.get(f"/api/v1/variants/{number}", headers=stranger),
            client.get(f"/api/v1/variants/{number}/solution", headers=stranger),
            client.post(f"/api/v1/variants/{number}/preview", headers=stranger, json={"answer": "l3", "text": "1"}),
            client.post(f"/api/v1/variants/{number}/submissions", headers=stranger, json={"answers": {}}),
            client.get(f"/variants/{number}", headers=stranger),
        ]
        assert [reply.json()["error"]["code"] for reply in replies] == ["unknown_variant"] * 5
        assert client.get(f"/api/v1/submissions/{receipt}", headers=stranger).status_code == 404


def test_a_lecturer_sees_a_student_s_variant_but_cannot_answer_it(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    receipt = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {}}).json()["receipt"]["id"]
    lecturer = bearer("lecturer")
    for path in (f"variants/{number}", f"variants/{number}/solution", f"submissions/{receipt}"):
        assert client.get(f"/api/v1/{path}", headers=lecturer).status_code == 200
    reply = client.post(f"/api/v1/variants/{number}/submissions", headers=lecturer, json={"answers": {}})
    assert reply.status_code == 404


def test_a_token_owns_what_it_deals(client: TestClient) -> None:
    anna = bearer("student", "anna")
    dealt = client.post("/api/v1/exercises/slider_crank/variants", headers=anna)
    assert "set-cookie" not in dealt.headers
    again = bearer("student", "anna")
    assert client.get(f"/api/v1/variants/{dealt.json()['id']}", headers=again).status_code == 200


@pytest.mark.parametrize(
    "foreign",
    [
        {"origin": "https://evil.example"},
        {"origin": "null"},
        {"sec-fetch-site": "cross-site"},
        {"sec-fetch-site": "same-site"},
    ],
)
def test_a_page_of_another_site_cannot_post_with_our_cookie(
    client: TestClient, deal: Callable[..., str], foreign: dict[str, str]
) -> None:
    reply = client.post(f"/api/v1/variants/{deal()}/submissions", json={"answers": {}}, headers=foreign)
    assert (reply.status_code, reply.json()["error"]["code"]) == (403, "foreign_page")


def test_our_own_page_can_post(client: TestClient, deal: Callable[..., str]) -> None:
    ours = {"origin": "http://testserver", "sec-fetch-site": "same-origin"}
    assert client.post(f"/api/v1/variants/{deal()}/submissions", json={"answers": {}}, headers=ours).status_code == 201
    token = bearer("student") | {"origin": "https://elsewhere.example"}
    assert client.post("/api/v1/exercises/slider_crank/variants", headers=token).status_code == 201
