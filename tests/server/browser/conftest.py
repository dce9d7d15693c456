"""One browser for all tests here, and one tab that most of them walk on, one after the other."""

from __future__ import annotations

import shutil
from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page, sync_playwright

from tests.server.conftest import leave_out

PROGRAMS = ("chromium-headless-shell", "chromium")  # the first draws no window, for a third of the work
ARGUMENTS = [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
]  # fmt: skip


@pytest.fixture(scope="package")
def browser() -> Iterator[Browser]:
    """A real browser, if the machine has one."""
    program = next(filter(None, map(shutil.which, PROGRAMS)), None)
    if program is None:
        leave_out("browser", "no Chromium on this machine: the pages were not tried in a browser")
    with sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=program, args=ARGUMENTS)
        yield found
        found.close()


def watched(page: Page) -> Iterator[Page]:
    """Give the page; fail afterwards if a script has failed or the content-security policy was broken."""
    complaints: list[str] = []
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("console", lambda line: complaints.append(line.text) if "Content Security" in line.text else None)
    yield page
    assert not complaints


@pytest.fixture(scope="package")
def tab(browser: Browser) -> Iterator[Page]:
    """The tab that the tests share."""
    context = browser.new_context(locale="en", reduced_motion="reduce")
    yield from watched(context.new_page())
    context.close()


@pytest.fixture
def page(tab: Page) -> Iterator[Page]:
    """The tab, wide, of a person who has not been here before."""
    tab.set_viewport_size({"width": 1360, "height": 900})
    tab.context.clear_cookies()
    yield tab
    tab.unroute_all()
