"""The form of the builder, as a browser fills it and sends it."""

from __future__ import annotations

import re
from html import unescape
from typing import Any

from starlette.testclient import TestClient

from exercises.presenting import words_of
from tests.server.sets.conftest import Course


def fields(page: str) -> dict[str, str]:
    """The fields of the builder as the browser would send them."""
    form = page[page.index('name="revision"') - 40 : page.index('name="then"')]
    found = {match[1]: unescape(match[2]) for match in re.finditer(r'name="([\w.]+)"(?:[^>]*?) value="([^"]*)"', form)}
    for name in {name for name in found if name.endswith(".pool")}:
        ticked = re.findall(rf'type="checkbox" name="{re.escape(name)}" value="([^"]*)" checked', form)
        found[name] = " ".join(map(unescape, ticked))
    for match in re.finditer(r'<select id="\w+" name="(\w+)">(.*?)</select>', form, re.DOTALL):
        chosen = re.search(r'value="([^"]*)" selected', match[2])
        found[match[1]] = chosen[1] if chosen else ""
    for button in ("move", "remove"):
        found.pop(button, None)
    return found


def title(exercise: str, language: str = "en") -> str:
    """The title of an exercise."""
    return str(words_of(exercise, language)["title"])


def started(course: Course) -> str:
    path = f"/courses/{course.school.course}/sets"
    reply = course.lecturer.post(path, data={"title": "Set 7"})
    assert reply.status_code == 303, reply.text
    found: str = reply.headers["location"]
    return found


def saved(browser: TestClient, path: str, **changes: str) -> Any:
    reply = browser.post(path, data=fields(browser.get(path).text) | changes)
    assert reply.status_code == 303, reply.text
    return browser.get(path)
