"""The page of a job in a browser: it goes on by itself, tells how it ended, and gives up a server that is gone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import pytest
from playwright.sync_api import Browser, Page, Route, expect

from server.settings import Settings
from tests.server.browser import axe
from tests.server.browser.walking import follow, width
from tests.server.conftest import Live
from tests.server.sets.conftest import EXERCISE, made, moment
from tests.server.stores import lay

COOKIE = "grubler_session"
TASK = {"exercise": EXERCISE, "points": 10, "attempts": 2}
TASKS, CARDS = 4, 30
AT_ONCE = "from server.sets import pages; pages.PATIENCE = 0.0"  # a fast machine is done before a person waits


@dataclass(frozen=True, slots=True)
class Desk:
    """A running server, the session of its lecturer, and the drafts that wait, first short ones."""

    live: Live
    cookie: str
    drafts: list[str]

    def publish(self, page: Page, language: str = "en", *, short: bool = False) -> None:
        """Publish a draft as its lecturer does, one of few tasks if short; what comes is the page of the job."""
        page.context.add_cookies([{"name": COOKIE, "value": self.cookie, "url": self.live.url}])
        page.goto(f"{self.live.url}/sets/{self.drafts.pop(0 if short else -1)}?lang={language}")
        follow(page, "button[name=then][value=publish]")
        page.wait_for_selector("[data-job]")


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Desk]:
    settings = Settings(tmp_path_factory.mktemp("desk"), workers=1)
    lay(settings)
    for course in made(settings):
        drafts = [
            course.built(title=f"Set {n}", due=moment(days=7), items=[TASK] * tasks)
            for n, tasks in enumerate((1, 1, TASKS, TASKS))
        ]
        cookie = str(course.lecturer.cookies[COOKIE])
    live = Live(settings.data_dir, changed=AT_ONCE)
    live.start()
    yield Desk(live, cookie, drafts)
    live.kill()


def test_publishing_is_followed_card_by_card_to_its_end(page: Page, desk: Desk) -> None:
    loads: list[str] = []
    page.on("framenavigated", lambda frame: loads.append(frame.url))
    desk.publish(page)
    arrived = len(loads)
    bar, first = page.locator("progress"), page.locator("[data-job-item='1']")
    assert page.locator("[data-job]").get_attribute("data-job")
    seen, broken = {bar.evaluate("bar => bar.value")}, [axe.found(page)]
    while page.locator("form[action$='/cancel']").count():
        seen.add(bar.evaluate("bar => bar.value"))
        page.wait_for_timeout(50)
    assert len(seen) > 3 and bar.evaluate("bar => bar.value === bar.max && bar.max") == TASKS * CARDS
    expect(page.locator("[data-job-state]")).to_have_text("done")
    expect(first).to_have_text(f"Task 1: {CARDS} of {CARDS}")
    assert len(loads) == arrived  # nobody has loaded the page anew
    assert [*broken, axe.found(page)] == [[], []]
    page.set_viewport_size({"width": 320, "height": 800})
    assert width(page) <= 320
    follow(page, ".btn.main")
    assert "/sets/" in page.url


def test_cancelling_leads_to_a_page_that_says_so_and_to_the_draft(page: Page, desk: Desk) -> None:
    desk.publish(page, "pl")
    expect(page.locator("[data-job-state]")).to_have_text("w toku")
    follow(page, "form[action$='/cancel'] button")
    expect(page.locator("[data-job-state]")).to_have_text("przerwane")
    follow(page, ".btn.main")
    assert page.locator("button[name=then][value=publish]").count() == 1


def test_a_server_that_is_gone_is_asked_some_times_and_then_no_more(browser: Browser, desk: Desk) -> None:
    asked: list[str] = []

    def refuse(route: Route) -> None:
        asked.append(route.request.url)
        route.abort()

    context = browser.new_context()  # its clock stands still, also on pages that come after
    page = context.new_page()
    page.route("**/events", refuse)
    page.clock.install()
    desk.publish(page, "ru", short=True)
    lost = page.locator("[data-job-lost]")
    for _ in range(20):
        page.clock.run_for(40_000)
        page.wait_for_timeout(20)
    assert lost.is_visible() and "Связь потеряна" in lost.inner_text()
    assert 3 < len(asked) < 10
    follow(page, "[data-job-lost] a")
    context.close()


def test_without_a_script_the_page_loads_itself_anew_to_the_end(browser: Browser, desk: Desk) -> None:
    context = browser.new_context(java_script_enabled=False)
    page = context.new_page()
    desk.publish(page, short=True)
    assert page.locator("noscript").count() or page.locator("text=looks again").count()
    page.wait_for_selector(".btn.main[href^='/sets/']", timeout=120_000)
    context.close()
