"""A22: every route, for everybody: who is let in is what its policy says, and nobody reaches what is another's."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from starlette.testclient import TestClient

from server.policy import POLICIES, CourseRole, InCourse, Role
from tests.conftest import Laid
from tests.server.school import MEMBERS, NAMES, ROLES, School, opened

EVERYBODY = (None, *(name for name in NAMES if name != "leaver"))
DENIALS = {"token_needed", "forbidden", "unknown_course"}
HIDDEN = {"unknown_variant", "unknown_submission"}
SEE_THE_STUDENT = {"student", "assistant", "lecturer", "administrator"}
UNKNOWN = "AAAA-AAAA-AAAA"


@pytest.fixture(scope="module")
def school(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[School]:
    with opened(laid_for_all(tmp_path_factory.mktemp("school"), secret=b"matrix", limited=False)) as found:
        yield found


@pytest.fixture(scope="module")
def values(school: School) -> dict[str, str]:
    """What stands in the paths: all of it belongs to `student` or to the course of the school."""
    student = school.browser("student")
    variant = student.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()["id"]
    graded = student.post(f"/api/v1/variants/{variant}/submissions", json={"answers": {"l3": "1 mm"}}).json()
    token = student.post("/api/v1/tokens", json={"name": "ci"}).json()["id"]
    session = school.browser("student").get("/api/v1/sessions").json()[0]["id"]
    return {
        "exercise": "slider_crank", "variant": variant, "receipt": graded["receipt"]["id"], "solver": "beam",
        "course": school.course, "person": school.people["leaver"], "code": "NONE-0000", "link": "x" * 43,
        "session": session, "token": token, "form": "md",
    }  # fmt: skip


def role_of(who: str | None) -> Role:
    return Role.ANONYMOUS if who is None else Role[ROLES.get(who, "student").upper()]


def denial(who: str | None, policy: Role | InCourse) -> str | None:
    """What the declared policy says: the code with which somebody is refused, or none."""
    role = role_of(who)
    if who is None:
        return None if policy is Role.ANONYMOUS else "token_needed"
    if isinstance(policy, Role):
        return None if role >= policy else "forbidden"
    if role is Role.ADMINISTRATOR:
        return None
    if who not in MEMBERS:
        return "unknown_course"
    return None if CourseRole[MEMBERS[who].upper()] >= policy.role else "forbidden"


def least(schema: dict[str, Any], shapes: dict[str, Any]) -> Any:
    """The least body that the description of the interface allows."""
    if "$ref" in schema:
        return least(shapes[schema["$ref"].rsplit("/", 1)[-1]], shapes)
    if schema.get("type") == "object":
        return {name: least(schema["properties"][name], shapes) for name in schema.get("required", ())}
    return {"string": "x", "integer": 1, "number": 1, "boolean": False, "array": []}.get(schema.get("type", ""))


def body_of(browser: TestClient, method: str, route: str) -> Any:
    """A body for what is asked of a variant: only then is it looked up; elsewhere one that changes nothing."""
    described: Any = browser.app.openapi()  # type: ignore[attr-defined]
    asked = described["paths"].get(route, {}).get(method.lower(), {}).get("requestBody")
    if asked is None or not {"variant", "receipt"} & set(re.findall(r"\{(\w+)\}", route)):
        return {}
    return least(asked["content"]["application/json"]["schema"], described["components"]["schemas"])


def ask(browser: TestClient, method: str, route: str, path: str) -> str | None:
    """Ask for something; gives the code of a refusal."""
    body = {"json": body_of(browser, method, route)} if path.startswith("/api/") else {"data": {"problem": "x"}}
    reply = browser.request(method, path, **({} if method == "GET" else body))
    assert reply.status_code < 500, (method, path, reply.text)
    if reply.status_code < 400 or not reply.headers["content-type"].startswith("application/json"):
        return None
    code: str = reply.json()["error"]["code"]
    return code


def routes() -> list[tuple[str, str]]:
    """All routes, those that end something last."""
    return sorted(POLICIES, key=lambda route: (route[0] == "DELETE", "sign" in route[1], route[1]))


@pytest.mark.parametrize("who", EVERYBODY)
def test_a_route_lets_in_whom_its_policy_names(school: School, values: dict[str, str], who: str | None) -> None:
    browser = school.browser(who)
    for method, route in routes():
        policy, wanted = POLICIES[method, route], re.findall(r"\{(\w+)\}", route)
        if method == "DELETE" or "sign" in route:
            browser = school.browser(who)
        code = ask(browser, method, route, re.sub(r"\{(\w+)\}", lambda found: values.get(found[1], UNKNOWN), route))
        by = policy.by if isinstance(policy, InCourse) else None
        expected = denial(who, policy)
        if by is not None and by not in values and expected != "token_needed":
            assert code == "unknown_course", (method, route)
        elif expected is not None:
            assert code == expected, (method, route)
        elif {"variant", "receipt"} & set(wanted) and who not in SEE_THE_STUDENT:
            assert code in HIDDEN, (method, route)
        else:
            assert code not in DENIALS, (method, route)


def test_the_owner_and_the_teachers_see_a_variant(school: School, values: dict[str, str]) -> None:
    paths = [f"/variants/{values['variant']}", f"/api/v1/submissions/{values['receipt']}"]
    for who in SEE_THE_STUDENT:
        assert [school.browser(who).get(path).status_code for path in paths] == [200, 200], who


@pytest.mark.parametrize("kind", ["session", "token"])
def test_nobody_else_ends_what_is_the_student_s(school: School, values: dict[str, str], kind: str) -> None:
    made = school.browser("student").post("/api/v1/tokens", json={"name": "ci"}).json()["id"]
    mine = made if kind == "token" else school.browser("student").get("/api/v1/sessions").json()[0]["id"]
    for who in NAMES:
        if who not in ("student", "leaver"):  # the administrator has erased the leaver by now
            assert school.browser(who).delete(f"/api/v1/{kind}s/{mine}").json()["error"]["code"] == f"unknown_{kind}"
            assert school.browser(who).post(f"/account/{kind}s/{mine}").status_code == 404
    assert school.browser("student").delete(f"/api/v1/{kind}s/{mine}").status_code == 204


def test_a_member_of_another_course_is_not_reached_through_the_own_one(school: School) -> None:
    browser = school.browser("stranger")
    own = browser.get("/api/v1/courses").json()[0]["id"]
    for place in (f"/api/v1/courses/{own}", f"/courses/{own}"):
        reply = browser.post(f"{place}/members/{school.people['other']}/link")
        assert (reply.status_code, reply.json()["error"]["code"]) == (404, "unknown_member")
    change = browser.patch(f"/api/v1/courses/{own}/members/{school.people['other']}", json={"role": "lecturer"})
    assert change.json()["error"]["code"] == "unknown_member"
    foreign = browser.patch(f"/api/v1/courses/{own}/members/{school.people['stranger']}", json={"group": school.group})
    assert foreign.json()["error"]["code"] == "unknown_group"
