"""A reader's walk from page to page: what a click opens is there in full before the test looks at it."""

from __future__ import annotations

from playwright.sync_api import Page


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
