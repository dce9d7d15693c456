"""No finding of axe-core on any page or state, light and dark, on a wide screen and on a phone; nothing moves."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from playwright.sync_api import Browser, Page, ViewportSize

from exercises import grading
from exercises.variants import deal
from server.database import secret_of
from server.people import tokens
from server.settings import Settings
from tests.depth import amount
from tests.server.browser import axe, components
from tests.server.browser.conftest import watched
from tests.server.browser.walking import desk, follow, width
from tests.server.conftest import Live

State = Callable[[Page, Live], None]
ALL_OUTCOMES = {"alpha2": grading.reference(deal("slider_crank", 7))["alpha2"], "l3": "1 mm", "v3": "1 m/"}
SHIFTS = """() => new Promise((done) => new PerformanceObserver((list) =>
    done(list.getEntries().reduce((sum, entry) => sum + (entry.hadRecentInput ? 0 : entry.value), 0))
  ).observe({type: "layout-shift", buffered: true}) || setTimeout(() => done(0), 300))"""


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    context = browser.new_context(locale="en", reduced_motion="reduce")
    yield from watched(context.new_page())
    context.close()


def catalogue_of_one(page: Page, site: Live) -> None:
    page.goto(f"{site.url}/?q=vp-2")


def nothing_found(page: Page, site: Live) -> None:
    page.goto(f"{site.url}/?q=nothing-says-this")


def exercise(page: Page, site: Live) -> None:
    page.goto(f"{site.url}/exercises/slider_crank")
    page.click("details summary")


def all_kinds_and_outcomes(page: Page, site: Live) -> None:
    desk(page, site.url)
    address, whole = f"{site.url}/components", components.page(page.request.get(page.url).text())
    headers = {
        "content-type": "text/html",
        "content-security-policy": page.request.get(site.url).headers["content-security-policy"],
    }
    page.route(address, lambda route: route.fulfill(body=whole, headers=headers))
    page.goto(address)
    page.wait_for_selector(".order button")
    page.locator("[data-draft-conflict]").evaluate("node => { node.hidden = false; }")


def polygon(page: Page, site: Live) -> None:
    desk(page, site.url, "slider_crank_polygon")
    page.fill("[name='answer.polygon']", grading.reference(deal("slider_crank_polygon", 7))["polygon"])
    page.wait_for_selector(".read math")
    page.locator("[data-part=angle]").last.press("Enter")
    page.locator("[data-remove]").last.press("Delete")


def a_handle_with_the_focus(page: Page, site: Live) -> None:
    desk(page, site.url, "beam_diagrams")
    page.locator(".sketch [role=slider]").first.focus()
    for key in ("Enter", "Enter", "Tab", "Shift+ArrowUp"):
        page.keyboard.press(key)


def a_text_beyond_its_table(page: Page, site: Live) -> None:
    desk(page, site.url, "beam_diagrams")
    page.locator("li:has([name='answer.V']) summary").press("Enter")
    page.fill("textarea[name='answer.V']", "0 .. 2: x^3")
    page.wait_for_selector("[data-twin-note]:visible")


def laboratory(page: Page, site: Live) -> None:
    desk(page, site.url, "tmm2_oop")
    page.evaluate("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
    page.fill("[name='answer.polygon']", grading.reference(deal("tmm2_oop", 7))["polygon"])
    page.wait_for_selector("li:has([name='answer.polygon']) .read math")


def table(page: Page, site: Live) -> None:
    desk(page, site.url, "rrp_table")
    page.locator("details summary:visible").last.click()


def verdicts(page: Page, site: Live) -> None:
    desk(page, site.url)
    for name, text in ALL_OUTCOMES.items():
        page.fill(f"[name='answer.{name}']", text)
    follow(page, "form[data-preview] button.main")
    page.evaluate("document.querySelectorAll('details').forEach((details) => { details.open = true; })")


def solution(page: Page, site: Live) -> None:
    follow(page, "a[href$='/solution']")


def visual_editor(page: Page, site: Live) -> None:
    desk(page, site.url)
    page.click(".visual button")
    page.wait_for_selector("math-field:focus")
    page.keyboard.type("l1/l2")


def typing(page: Page, site: Live) -> None:
    page.goto(f"{site.url}/typing")


def nothing_here(page: Page, site: Live) -> None:
    page.goto(f"{site.url}/none")


def problems(page: Page, site: Live) -> None:
    desk(page, site.url)
    page.click("#problem summary")
    page.fill("#problem-text", "The figure and the text disagree.")
    follow(page, "#problem button")
    token = tokens.issue("lecturer", secret_of(Settings(site.folder).store_url))
    page.context.set_extra_http_headers({"authorization": f"Bearer {token}"})
    page.goto(f"{site.url}/problems")
    page.context.set_extra_http_headers({})


STATES: tuple[State, ...] = (
    catalogue_of_one, nothing_found, exercise, all_kinds_and_outcomes, polygon, table, verdicts, solution,
    visual_editor, nothing_here, problems, a_handle_with_the_focus, a_text_beyond_its_table, laboratory, typing,
)  # fmt: skip


def sights(turn: int) -> list[tuple[ViewportSize, axe.Colour, bool]]:
    """At which sizes and in which colours to look, and whether for looks only: one by default, in turn; all in full."""
    size, other = (axe.WIDE, axe.NARROW) if turn % 2 else (axe.NARROW, axe.WIDE)
    colours: tuple[axe.Colour, axe.Colour] = ("light", "dark") if turn // 2 % 2 else ("dark", "light")
    first, second = colours
    more = [(size, second, True), (other, second, False), (other, first, True)]
    return [(size, first, False), *amount([], more)]


@pytest.mark.parametrize("state", STATES, ids=lambda state: state.__name__)
def test_axe_finds_nothing_in_light_and_dark_wide_and_narrow(page: Page, site: Live, state: State) -> None:
    seen, broken = sights(STATES.index(state)), []
    axe.look(page, *seen[0][:2])
    state(page, site)
    for size, colour, looks_only in seen:
        axe.look(page, size, colour)
        broken += axe.found(page, looks_only=looks_only)
    assert broken == [], "\n".join(broken)
    page.set_viewport_size({"width": 320, "height": 800})
    assert width(page) <= 320


def test_axe_would_find_a_label_that_is_missing(page: Page, site: Live) -> None:
    page.goto(f"{site.url}/?q=vp-2")
    page.evaluate(
        "document.querySelector('label[for=find]').remove(); document.querySelector('#find').placeholder = ''"
    )
    assert any(line.startswith("label:") for line in axe.found(page))


def test_nothing_shifts_while_a_page_arrives(page: Page, site: Live) -> None:
    page.set_viewport_size(axe.WIDE)
    desk(page, site.url)
    page.reload()
    page.wait_for_selector(".keys:visible")
    assert page.evaluate(SHIFTS) < 0.1
