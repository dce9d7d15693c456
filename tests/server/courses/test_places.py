"""Whoever presses a button on the long page of a course comes back to where it stands."""

from __future__ import annotations

import pytest

from tests.server.school import School


@pytest.mark.parametrize(
    ("path", "form", "at"),
    [
        ("/code", {"open": "yes"}, "h-code"),
        ("/claims", {"open": "yes"}, "h-code"),
        ("/groups", {"name": "Wednesday"}, "h-groups"),
        ("/members/{student}", {"role": "student"}, "m-{student}"),
        ("/members/{leaver}", {"leave": "yes"}, "h-members"),
        ("/roster", {"roster": "5001;Ewa Nowa;B", "apply": "yes"}, "h-members"),
    ],
)
def test_a_button_leads_back_to_its_place(school: School, path: str, form: dict[str, str], at: str) -> None:
    home, people, lecturer = f"/courses/{school.course}", school.people, school.browser("lecturer")
    reply = lecturer.post(home + path.format(**people), data=form)
    place = at.format(**people)
    assert (reply.status_code, reply.headers["location"]) == (303, f"{home}#{place}")
    assert lecturer.get(home).text.count(f'id="{place}"') == 1
