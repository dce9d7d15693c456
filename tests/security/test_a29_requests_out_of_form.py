"""A29: verb override, doubled parameters, foreign hosts and origins, oversize bodies: refused or without effect."""

from __future__ import annotations

import re

import pytest
from fastapi.routing import APIRoute
from starlette.testclient import TestClient

from server.policy import POLICIES, InCourse
from tests.server.school import School


@pytest.mark.parametrize("header", ["x-http-method-override", "x-method-override", "x-http-method"])
def test_a_verb_cannot_be_overridden(client: TestClient, header: str) -> None:
    assert client.get("/api/v1/exercises", headers={header: "DELETE"}).status_code == 200
    assert client.get("/api/v1/exercises?_method=DELETE").status_code == 200


@pytest.mark.parametrize("verb", ["PUT", "PATCH", "DELETE", "TRACE", "CONNECT"])
def test_a_verb_that_a_route_does_not_have_is_refused(client: TestClient, verb: str) -> None:
    reply = client.request(verb, "/api/v1/exercises")
    assert reply.status_code in (403, 404, 405) and set(reply.json()) == {"error"}


def test_doubled_parameters_and_headers_are_read_once(client: TestClient) -> None:
    assert client.get("/api/v1/exercises?limit=1&limit=2").status_code in (200, 422)
    pairs = [("idempotency-key", "a"), ("idempotency-key", "b")]
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    reply = client.post(path, json={"answers": {}}, headers=pairs)
    assert reply.status_code in (201, 422)


def test_a_foreign_host_name_reaches_no_page_of_ours(client: TestClient) -> None:
    page = client.get("/", headers={"host": "evil.example"}).text
    assert "evil.example" not in page


def test_no_other_origin_may_read_or_post(client: TestClient) -> None:
    foreign = {"origin": "https://evil.example"}
    reply = client.get("/api/v1/exercises", headers=foreign)
    assert "access-control-allow-origin" not in reply.headers
    preflight = client.options("/api/v1/exercises", headers=foreign | {"access-control-request-method": "POST"})
    assert "access-control-allow-origin" not in preflight.headers
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    assert client.post(path, json={"answers": {}}, headers=foreign).status_code == 403


def test_a_body_larger_than_the_bound_is_cut_off(client: TestClient) -> None:
    path = f"/api/v1/variants/{client.headers['x-variant']}/submissions"
    reply = client.post(path, content=b'{"answers": {"l3": "' + b"1" * 70_000 + b'"}}')
    assert reply.status_code == 413 and reply.headers["connection"] == "close"


def test_a_name_that_stands_twice_is_refused_by_every_route_that_reads_json(school: School) -> None:
    browser, headers = school.browser("administrator"), {"content-type": "application/json"}
    for (method, route), policy in POLICIES.items():
        if (method, route) not in reads_json(school):
            continue
        path = re.sub(r"\{(\w+)\}", lambda found: school.course if found[1] == "course" else "AAAA-AAAA-AAAA", route)
        reply = browser.request(method, path, content='{"a": {"b": 1, "b": 2}}', headers=headers)
        reached = not isinstance(policy, InCourse) or policy.by == "course"
        code = "repeated_name" if reached else "unknown_course"
        assert (reply.json()["error"]["code"], reply.json()["error"]["field"]) == (code, "b" if reached else None), path


def reads_json(school: School) -> set[tuple[str, str]]:
    """Every method and path whose body is read as JSON into a shape."""
    routes = [route for route in school.app.routes if isinstance(route, APIRoute) and route.body_field is not None]
    return {(method, route.path) for route in routes for method in route.methods or ()}
