"""Who may do what. A route that is not in the table cannot be served; ownership is decided here too."""

from __future__ import annotations

from collections.abc import Iterable
from enum import IntEnum

from starlette.routing import BaseRoute, Mount, Route

from server.storage import Dealt, Handed


class Role(IntEnum):
    """What a reader may do; a higher role may do all that a lower one may."""

    ANONYMOUS = 0
    STUDENT = 1
    LECTURER = 2
    ADMINISTRATOR = 3


POLICIES: dict[tuple[str, str], Role] = {
    ("GET", "/health"): Role.ANONYMOUS,
    ("GET", "/ready"): Role.ANONYMOUS,
    ("GET", "/metrics"): Role.ADMINISTRATOR,
    ("GET", "/api/v1/openapi.json"): Role.ANONYMOUS,
    ("GET", "/api/v1/exercises"): Role.ANONYMOUS,
    ("GET", "/api/v1/exercises/{exercise}"): Role.ANONYMOUS,
    ("POST", "/api/v1/exercises/{exercise}/variants"): Role.ANONYMOUS,
    ("GET", "/api/v1/variants/{variant}"): Role.ANONYMOUS,
    ("POST", "/api/v1/variants/{variant}/preview"): Role.ANONYMOUS,
    ("POST", "/api/v1/variants/{variant}/submissions"): Role.ANONYMOUS,
    ("GET", "/api/v1/variants/{variant}/solution"): Role.ANONYMOUS,
    ("GET", "/api/v1/variants/{variant}/draft"): Role.ANONYMOUS,
    ("PUT", "/api/v1/variants/{variant}/draft"): Role.ANONYMOUS,
    ("POST", "/api/v1/variants/{variant}/problems"): Role.ANONYMOUS,
    ("GET", "/api/v1/submissions/{receipt}"): Role.ANONYMOUS,
    ("GET", "/api/v1/problems"): Role.LECTURER,
    ("POST", "/api/v1/problems/{problem}/settle"): Role.LECTURER,
    ("GET", "/api/v1/solvers"): Role.ANONYMOUS,
    ("POST", "/api/v1/solve/{solver}"): Role.LECTURER,
    ("POST", "/api/v1/compare"): Role.LECTURER,
    ("GET", "/api/v1/reports/tmm2/{variant}.{form}"): Role.ANONYMOUS,
    ("GET", "/"): Role.ANONYMOUS,
    ("GET", "/exercises/{exercise}"): Role.ANONYMOUS,
    ("POST", "/exercises/{exercise}"): Role.ANONYMOUS,
    ("GET", "/variants/{variant}"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}/preview"): Role.ANONYMOUS,
    ("GET", "/variants/{variant}/solution"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}/problem"): Role.ANONYMOUS,
    ("GET", "/problems"): Role.LECTURER,
    ("POST", "/problems/{problem}"): Role.LECTURER,
    ("GET", "/static"): Role.ANONYMOUS,
}


class UndeclaredRoute(RuntimeError):
    """A route has no policy; the program does not start."""


def check(routes: Iterable[BaseRoute]) -> None:
    """Refuse routes without a policy.

    Raises:
        UndeclaredRoute: The first route that is not in the table, or is of a kind that cannot be looked up.
    """
    for route in routes:
        if not isinstance(route, Route | Mount):
            raise UndeclaredRoute(f"{route!r} is not a route with a path of its own")
        methods = route.methods or () if isinstance(route, Route) else ("GET",)
        for method in methods:
            if (method, route.path) not in POLICIES:
                raise UndeclaredRoute(f"{method} {route.path} declares no policy in server/policy.py")


def may_see_variant(role: Role, owner: str | None, variant: Dealt) -> bool:
    """Whether a reader may look at a variant: its owner, and the lecturers."""
    return role >= Role.LECTURER or variant.owner.id == owner


def may_answer(owner: str | None, variant: Dealt) -> bool:
    """Whether a reader may hand in answers to a variant: its owner alone."""
    return variant.owner.id == owner


def may_see_submission(role: Role, owner: str | None, handed: Handed) -> bool:
    """Whether a reader may look at a submission: its owner, and the lecturers."""
    return role >= Role.LECTURER or handed.owner == owner


def may_see_solution(role: Role, counted: bool) -> bool:
    """Whether the worked solution is open. In practice it opens with the first submission that counts: a blank or
    unreadable one opens nothing."""
    return role >= Role.LECTURER or counted
