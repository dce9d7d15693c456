"""A20: no statistic reveals a person to others: a student reaches no page about more than the own work."""

from __future__ import annotations

import re

import pytest

from server.policy import POLICIES, CourseRole, InCourse, Role
from tests.server.sets.conftest import Course

ABOUT_OTHERS = re.compile(
    r"gradebook|progress|results|statistic|analysis|/students|/members|accommodations|answers|audit|/marks|sheets"
)


def test_what_tells_about_others_is_for_those_who_teach() -> None:
    told = {route: policy for (_, route), policy in POLICIES.items() if ABOUT_OTHERS.search(route)}
    assert len(told) >= 15
    for route, policy in told.items():
        if isinstance(policy, InCourse):
            assert policy.role >= CourseRole.ASSISTANT, route
        else:
            assert policy >= Role.LECTURER, route


@pytest.mark.parametrize("path", ["/api/v1/task-sets/{}", "/sets/{}"])
def test_a_student_sees_no_other_student_and_no_mean_of_all(course: Course, path: str) -> None:
    number = course.published()
    variant = course.variant(number)
    course.hand_in(variant, {"l3": "1 mm"})
    mine, theirs = (browser.get(path.format(number)).text for browser in (course.student, course.other))
    codes = [course.card(number).code, variant]
    assert all(code in mine and code not in theirs for code in codes[:1])
    for login in ("student", "leaver", "assistant"):
        assert course.school.people[login] not in theirs
