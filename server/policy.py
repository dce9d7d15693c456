"""Who may do what. A route that is not in the table cannot be served; ownership is decided here too."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import IntEnum
from typing import TypeAlias

from starlette.routing import BaseRoute, Mount, Route

from server.storage import Dealt, Owner


class Role(IntEnum):
    """What a reader may do; a higher role may do all that a lower one may."""

    ANONYMOUS = 0
    STUDENT = 1
    LECTURER = 2
    ADMINISTRATOR = 3


class CourseRole(IntEnum):
    """What a member may do in a course; a higher role may do all that a lower one may."""

    STUDENT = 1
    ASSISTANT = 2
    LECTURER = 3


@dataclass(frozen=True, slots=True)
class InCourse:
    """A policy of a course: its members from a role on, and the administrators.

    Attributes:
        role: The least role in the course.
        by: The parameter of the path that leads to the course; `reader.COURSES` knows how.
    """

    role: CourseRole
    by: str = "course"

    @property
    def name(self) -> str:
        """How the policy is called in documents."""
        return f"{self.role.name} of the course"


Policy: TypeAlias = Role | InCourse
COURSE_STUDENT, COURSE_ASSISTANT, COURSE_LECTURER = map(InCourse, CourseRole)

JOB_ASSISTANT, JOB_LECTURER = InCourse(CourseRole.ASSISTANT, "job"), InCourse(CourseRole.LECTURER, "job")
SET_STUDENT, SET_ASSISTANT, SET_LECTURER = (InCourse(role, "task_set") for role in CourseRole)

POLICIES: dict[tuple[str, str], Policy] = {
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
    ("GET", "/api/v1/variants/{variant}/hints"): Role.ANONYMOUS,
    ("POST", "/api/v1/variants/{variant}/hints"): Role.ANONYMOUS,
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
    ("GET", "/typing"): Role.ANONYMOUS,
    ("GET", "/exercises/{exercise}"): Role.ANONYMOUS,
    ("POST", "/exercises/{exercise}"): Role.ANONYMOUS,
    ("GET", "/variants/{variant}"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}/hints"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}/preview"): Role.ANONYMOUS,
    ("GET", "/variants/{variant}/solution"): Role.ANONYMOUS,
    ("POST", "/variants/{variant}/problem"): Role.ANONYMOUS,
    ("GET", "/problems"): Role.LECTURER,
    ("POST", "/problems/{problem}"): Role.LECTURER,
    ("POST", "/api/v1/sessions"): Role.ANONYMOUS,
    ("GET", "/api/v1/sessions"): Role.STUDENT,
    ("DELETE", "/api/v1/sessions/{session}"): Role.STUDENT,
    ("GET", "/api/v1/me"): Role.STUDENT,
    ("GET", "/api/v1/tokens"): Role.STUDENT,
    ("POST", "/api/v1/tokens"): Role.STUDENT,
    ("DELETE", "/api/v1/tokens/{token}"): Role.STUDENT,
    ("POST", "/api/v1/practice"): Role.STUDENT,
    ("POST", "/api/v1/join"): Role.ANONYMOUS,
    ("GET", "/api/v1/courses"): Role.STUDENT,
    ("POST", "/api/v1/courses"): Role.LECTURER,
    ("GET", "/api/v1/courses/{course}"): COURSE_STUDENT,
    ("POST", "/api/v1/courses/{course}/code"): COURSE_LECTURER,
    ("GET", "/api/v1/courses/{course}/groups"): COURSE_ASSISTANT,
    ("POST", "/api/v1/courses/{course}/groups"): COURSE_LECTURER,
    ("GET", "/api/v1/courses/{course}/members"): COURSE_ASSISTANT,
    ("PATCH", "/api/v1/courses/{course}/members/{person}"): COURSE_LECTURER,
    ("DELETE", "/api/v1/courses/{course}/members/{person}"): COURSE_LECTURER,
    ("POST", "/api/v1/courses/{course}/members/{person}/link"): COURSE_LECTURER,
    ("POST", "/api/v1/courses/{course}/members/{person}/unclaim"): COURSE_LECTURER,
    ("POST", "/api/v1/courses/{course}/links"): COURSE_LECTURER,
    ("POST", "/api/v1/courses/{course}/claims"): COURSE_LECTURER,
    ("POST", "/api/v1/courses/{course}/roster"): COURSE_LECTURER,
    ("GET", "/signin"): Role.ANONYMOUS,
    ("POST", "/signin"): Role.ANONYMOUS,
    ("POST", "/signout"): Role.ANONYMOUS,
    ("GET", "/oidc"): Role.ANONYMOUS,
    ("GET", "/oidc/callback"): Role.ANONYMOUS,
    ("GET", "/join"): Role.ANONYMOUS,
    ("GET", "/join/{code}"): Role.ANONYMOUS,
    ("POST", "/join/{code}"): Role.ANONYMOUS,
    ("GET", "/links/{link}"): Role.ANONYMOUS,
    ("POST", "/links/{link}"): Role.ANONYMOUS,
    ("GET", "/account"): Role.STUDENT,
    ("POST", "/account"): Role.STUDENT,
    ("POST", "/account/password"): Role.STUDENT,
    ("POST", "/account/practice"): Role.STUDENT,
    ("POST", "/account/sessions/{session}"): Role.STUDENT,
    ("POST", "/account/tokens"): Role.STUDENT,
    ("POST", "/account/tokens/{token}"): Role.STUDENT,
    ("GET", "/home"): Role.STUDENT,
    ("POST", "/courses"): Role.LECTURER,
    ("GET", "/courses/{course}"): COURSE_STUDENT,
    ("POST", "/courses/{course}/code"): COURSE_LECTURER,
    ("POST", "/courses/{course}/groups"): COURSE_LECTURER,
    ("POST", "/courses/{course}/members/{person}"): COURSE_LECTURER,
    ("POST", "/courses/{course}/members/{person}/link"): COURSE_LECTURER,
    ("POST", "/courses/{course}/members/{person}/unclaim"): COURSE_LECTURER,
    ("POST", "/courses/{course}/links"): COURSE_LECTURER,
    ("POST", "/courses/{course}/claims"): COURSE_LECTURER,
    ("POST", "/courses/{course}/roster"): COURSE_LECTURER,
    ("POST", "/api/v1/task-sets"): Role.STUDENT,
    ("GET", "/api/v1/courses/{course}/task-sets"): COURSE_STUDENT,
    ("POST", "/api/v1/courses/{course}/extend"): COURSE_LECTURER,
    ("POST", "/api/v1/courses/{course}/copy"): COURSE_LECTURER,
    ("GET", "/api/v1/task-sets/{task_set}"): SET_STUDENT,
    ("PATCH", "/api/v1/task-sets/{task_set}"): SET_LECTURER,
    ("DELETE", "/api/v1/task-sets/{task_set}"): SET_LECTURER,
    ("POST", "/api/v1/task-sets/{task_set}/open"): SET_LECTURER,
    ("POST", "/api/v1/task-sets/{task_set}/items/{number}/variant"): SET_STUDENT,
    ("GET", "/api/v1/task-sets/{task_set}/accommodations"): SET_ASSISTANT,
    ("PUT", "/api/v1/task-sets/{task_set}/accommodations/{person}"): SET_LECTURER,
    ("POST", "/api/v1/task-sets/{task_set}/extend"): SET_LECTURER,
    ("POST", "/api/v1/task-sets/{task_set}/copy"): SET_LECTURER,
    ("GET", "/api/v1/task-sets/{task_set}/items/{number}/sheets.{form}"): SET_LECTURER,
    ("GET", "/api/v1/task-sets/{task_set}/gradebook"): SET_ASSISTANT,
    ("GET", "/api/v1/courses/{course}/gradebook"): COURSE_ASSISTANT,
    ("GET", "/api/v1/task-sets/{task_set}/progress"): SET_ASSISTANT,
    ("GET", "/api/v1/task-sets/{task_set}/statistics"): SET_ASSISTANT,
    ("GET", "/api/v1/task-sets/{task_set}/marks.{form}"): SET_ASSISTANT,
    ("GET", "/api/v1/courses/{course}/marks.{form}"): COURSE_ASSISTANT,
    ("GET", "/api/v1/task-sets/{task_set}/students/{person}"): SET_ASSISTANT,
    ("POST", "/api/v1/task-sets/{task_set}/marks"): SET_ASSISTANT,
    ("GET", "/api/v1/task-sets/{task_set}/open-answers"): SET_ASSISTANT,
    ("POST", "/api/v1/task-sets/{task_set}/open-answers"): SET_ASSISTANT,
    ("GET", "/courses/{course}/sets"): COURSE_STUDENT,
    ("POST", "/courses/{course}/sets"): COURSE_LECTURER,
    ("GET", "/sets/{task_set}"): SET_STUDENT,
    ("POST", "/sets/{task_set}"): SET_LECTURER,
    ("POST", "/sets/{task_set}/items/{number}"): SET_STUDENT,
    ("POST", "/sets/{task_set}/extend"): SET_LECTURER,
    ("POST", "/sets/{task_set}/students/{person}/time"): SET_LECTURER,
    ("POST", "/sets/{task_set}/remove"): SET_LECTURER,
    ("POST", "/sets/{task_set}/copy"): SET_LECTURER,
    ("POST", "/sets/{task_set}/sheets"): SET_LECTURER,
    ("POST", "/api/v1/task-sets/{task_set}/sheets"): SET_LECTURER,
    ("POST", "/courses/{course}/extend"): COURSE_LECTURER,
    ("POST", "/courses/{course}/copy"): COURSE_LECTURER,
    ("GET", "/sets/{task_set}/results"): SET_ASSISTANT,
    ("GET", "/sets/{task_set}/analysis"): SET_ASSISTANT,
    ("GET", "/sets/{task_set}/students/{person}"): SET_ASSISTANT,
    ("POST", "/sets/{task_set}/marks"): SET_ASSISTANT,
    ("POST", "/sets/{task_set}/open-answers"): SET_ASSISTANT,
    ("GET", "/courses/{course}/results"): COURSE_ASSISTANT,
    ("GET", "/api/v1/audit"): Role.ADMINISTRATOR,
    ("GET", "/api/v1/courses/{course}/audit"): COURSE_LECTURER,
    ("GET", "/audit"): Role.ADMINISTRATOR,
    ("GET", "/courses/{course}/audit"): COURSE_LECTURER,
    ("GET", "/api/v1/jobs/{job}"): JOB_ASSISTANT,
    ("GET", "/api/v1/jobs/{job}/events"): JOB_ASSISTANT,
    ("GET", "/api/v1/jobs/{job}/documents/{number}"): JOB_LECTURER,
    ("POST", "/api/v1/jobs/{job}/cancel"): JOB_LECTURER,
    ("GET", "/api/v1/jobs/{job}/changes"): JOB_ASSISTANT,
    ("POST", "/api/v1/task-sets/{task_set}/regrade"): SET_LECTURER,
    ("GET", "/sets/{task_set}/regrade"): SET_ASSISTANT,
    ("POST", "/sets/{task_set}/regrade"): SET_LECTURER,
    ("GET", "/jobs/{job}"): JOB_ASSISTANT,
    ("POST", "/jobs/{job}/cancel"): JOB_LECTURER,
    ("GET", "/api/v1/me/data"): Role.STUDENT,
    ("GET", "/account/data"): Role.STUDENT,
    ("GET", "/api/v1/people"): Role.ADMINISTRATOR,
    ("GET", "/api/v1/people/{person}"): Role.ADMINISTRATOR,
    ("PATCH", "/api/v1/people/{person}"): Role.ADMINISTRATOR,
    ("DELETE", "/api/v1/people/{person}"): Role.ADMINISTRATOR,
    ("POST", "/api/v1/people/{person}/link"): Role.ADMINISTRATOR,
    ("DELETE", "/api/v1/people/{person}/sessions"): Role.ADMINISTRATOR,
    ("GET", "/api/v1/people/{person}/data"): Role.ADMINISTRATOR,
    ("GET", "/people"): Role.ADMINISTRATOR,
    ("GET", "/people/{person}"): Role.ADMINISTRATOR,
    ("POST", "/people/{person}"): Role.ADMINISTRATOR,
    ("POST", "/people/{person}/link"): Role.ADMINISTRATOR,
    ("POST", "/people/{person}/sessions"): Role.ADMINISTRATOR,
    ("POST", "/people/{person}/erase"): Role.ADMINISTRATOR,
    ("GET", "/people/{person}/data"): Role.ADMINISTRATOR,
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


def may_see_variant(role: Role, owner: str | None, variant: Dealt, teaches: bool) -> bool:
    """Whether a reader may look at a variant: its owner, and those who teach the owner."""
    return variant.owner.id == owner or may_look_over(role, variant.owner, teaches)


def may_look_over(role: Role, owner: Owner, teaches: bool) -> bool:
    """Whether a reader may look at the work of an owner: administrators, those who teach the owner, and where the owner
    is in nobody's course, lecturers."""
    return role is Role.ADMINISTRATOR or teaches or (role >= Role.LECTURER and owner.anonymous)


def may_answer(owner: str | None, variant: Dealt) -> bool:
    """Whether a reader may hand in answers to a variant: its owner alone."""
    return variant.owner.id == owner


def may_see_solution(role: Role, counted: bool) -> bool:
    """Whether the worked solution is open. In practice it opens with the first submission that counts: a blank or
    unreadable one opens nothing."""
    return role >= Role.LECTURER or counted


def may_reset(actor: str | None, target: str, role: str, staff: bool) -> bool:
    """Whether a lecturer of a course may make a link with which a member sets a password: a student's, nowhere more
    than a student; else the link would be a way to become somebody with more rights."""
    return actor != target and role == Role.STUDENT.name.lower() and not staff


def may_replace(role: Role, elsewhere: bool) -> bool:
    """Whether a password that somebody has may be replaced: by who lectures all courses of that person, else by an
    administrator; putting an index number on a roster must not open what was handed in elsewhere."""
    return role is Role.ADMINISTRATOR or not elsewhere


def may_change_role(actor: str | None, target: str) -> bool:
    """Whether a lecturer of a course may change the role of a member: everybody's but the own, so one stays."""
    return actor != target
