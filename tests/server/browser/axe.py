"""What axe-core finds on a page: WCAG 2.2 AA and best practice."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, TypeAlias

from playwright.sync_api import Page, ViewportSize

Colour: TypeAlias = Literal["light", "dark"]
Sight: TypeAlias = tuple[ViewportSize, Colour]
WIDE, NARROW = ViewportSize(width=1360, height=900), ViewportSize(width=360, height=800)
SOURCE = (Path(__file__).parents[3] / "server/assets/node_modules/axe-core/axe.min.js").read_text("utf-8")
TAGS = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]
DEPENDS_ON_LOOKS = ["color-contrast", "target-size", "scrollable-region-focusable", "link-in-text-block"]
RUN = """async (only) => (await axe.run(document, {runOnly: only, resultTypes: ["violations"]}))
    .violations.map(({id, nodes}) => `${id}: ${nodes.slice(0, 4).map(({html}) => html.slice(0, 160)).join(" | ")}`)"""


def found(page: Page, *, looks_only: bool = False) -> list[str]:
    """Give each rule that is broken, with the first places; `looks_only` runs what colours and widths decide."""
    only: dict[str, Any] = (
        {"type": "rule", "values": DEPENDS_ON_LOOKS} if looks_only else {"type": "tag", "values": TAGS}
    )
    if not page.evaluate("'axe' in window"):
        page.evaluate(SOURCE)
    broken: list[str] = page.evaluate(RUN, only)
    return broken


def look(page: Page, size: ViewportSize, colour: Colour) -> None:
    """Look at the page at a size, in light or dark colours."""
    page.set_viewport_size(size)
    page.emulate_media(color_scheme=colour)
