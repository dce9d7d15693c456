"""A reader's walk from page to page: what a click opens is there in full before the test looks at it."""

from __future__ import annotations

from playwright.sync_api import Page

from tests.server.conftest import Live


def follow(page: Page, selector: str) -> None:
    """Click what leads to another page, and wait until that page is loaded."""
    with page.expect_navigation():
        page.click(selector)


def width(page: Page) -> int:
    """The width that the page asks for, in CSS pixels."""
    return int(page.evaluate("document.documentElement.scrollWidth"))


def desk(page: Page, address: str, exercise: str = "slider_crank", seed: int = 7) -> None:
    """Deal a variant to the browser's cookie and open its workspace."""
    dealt = page.request.post(f"{address}/api/v1/exercises/{exercise}/variants", data={"seed": seed})
    page.goto(f"{address}/variants/{dealt.json()['id']}")


def practise(page: Page, site: Live, exercise: str = "slider_crank", seed: str = "7") -> None:
    """Open the page of an exercise, choose a number and begin, as a reader does."""
    page.goto(f"{site.url}/exercises/{exercise}")
    page.click("details summary")
    page.fill("#seed", seed)
    follow(page, "button.main")
    page.wait_for_selector("form[data-preview]")


def focus_by_tab(page: Page, name: str) -> None:
    """Reach the field of a name by the Tab key alone."""
    tab_to(page, f"[name='{name}']")


def tab_to(page: Page, selector: str) -> None:
    """Reach what a selector names by the Tab key alone."""
    for _ in range(100):
        page.keyboard.press("Tab")
        if page.evaluate("(selector) => document.activeElement.matches(selector)", selector):
            return
    raise AssertionError(f"the keyboard does not reach {selector}")
