"""The list of sessions names browsers as their owners do."""

from __future__ import annotations

import pytest

from server.people.agents import called
from tests.server.school import PASSWORD, School

WINDOWS, PHONE = "Mozilla/5.0 (Windows NT 10.0; Win64; x64)", "Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X)"
CHROME = "AppleWebKit/537.36 (KHTML, like Gecko) Chrome/131.0.0.0 Safari/537.36"


@pytest.mark.parametrize(
    ("agent", "said"),
    [
        (f"{WINDOWS} {CHROME}", "Chrome, Windows"),
        (f"{WINDOWS} {CHROME} Edg/131.0", "Edge, Windows"),
        ("Mozilla/5.0 (X11; Linux x86_64; rv:128.0) Gecko/20100101 Firefox/128.0", "Firefox, Linux"),
        (f"Mozilla/5.0 (Linux; Android 14) {CHROME}", "Chrome, Android"),
        (f"{PHONE} AppleWebKit/605.1.15 Version/18.0 Mobile/15E148 Safari/604.1", "Safari, iPhone"),
        ("curl/8.5.0", "curl/8.5.0"),
        ("", ""),
    ],
)
def test_a_browser_is_called_by_name_and_system(agent: str, said: str) -> None:
    assert called(agent) == said


def test_a_session_is_listed_by_its_browser_and_never_as_markup(school: School) -> None:
    for agent in (f"{WINDOWS} {CHROME}", "<b>tool</b>"):
        browser = school.browser()
        form = {"login": "student", "password": PASSWORD}
        assert browser.post("/signin", data=form, headers={"user-agent": agent}).status_code == 303
    page = browser.get("/account").text
    assert "Chrome, Windows" in page and "Mozilla" not in page
    assert "&lt;b&gt;tool" in page and "<b>tool" not in page
