"""The workspace by keyboard alone: editors, the formula field, and the way through a whole page and back."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypedDict

import pytest
from playwright.sync_api import Page, expect

from exercises import grading
from exercises.variants import deal
from tests.server.browser.walking import desk, tab_to
from tests.server.conftest import Live

Opened = Callable[[Page], None]
FORMULA = "[name='answer.omega2_formula']"
SAVED = "[data-draft-state]:text('saved')"
LEAST = 24  # px, of a target (WCAG 2.5.8)


class Stop(TypedDict):
    """One stop of the Tab key: its number in the page, what it is, whether its focus shows, is in sight, is large."""

    at: int
    what: str
    rings: bool
    sight: bool
    large: bool


STOP = """(least) => {
  const node = document.activeElement, all = [...document.querySelectorAll("*")];
  const ring = node.matches(".handle") ? node.querySelector(".target") : node;
  const style = getComputedStyle(ring), box = node.getBoundingClientRect();
  const hit = document.elementFromPoint(box.x + box.width / 2, box.y + Math.min(box.height / 2, 20));
  const inline = node.matches("a, summary, input[type=radio], input[type=checkbox]");
  return {
    at: all.indexOf(node), what: node.outerHTML.slice(0, 120),
    rings: style.stroke !== "none" || (style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2),
    sight: hit !== null && (node.contains(hit) || hit.contains(node)) || node.matches(".handle"),
    large: inline || (box.width >= least && box.height >= least),
  };
}"""


def at_focus(page: Page) -> Stop:
    """Say where the focus is."""
    stop: Stop = page.evaluate(STOP, LEAST)
    return stop


def walk(page: Page, key: str) -> list[Stop]:
    """Press a key until the focus leaves the page."""
    stops: list[Stop] = []
    for _ in range(150):
        page.keyboard.press(key)
        stop = at_focus(page)
        if stop["what"].startswith("<body"):
            return stops
        stops.append(stop)
    raise AssertionError(f"{key} does not leave the page: {stops[-1]['what']}")


def with_formula_editor(page: Page) -> None:
    page.focus(".visual button")
    page.keyboard.press("Enter")
    page.wait_for_selector("math-field")
    page.evaluate("document.activeElement.blur()")


def with_every_handle(page: Page) -> None:
    page.locator(".sketch [role=slider]").first.focus()
    for key in ("Enter", "Enter", "Tab", "ArrowUp"):
        page.keyboard.press(key)
    page.evaluate("document.activeElement.blur()")
    page.wait_for_selector(".read .echo math")  # what was read is a part of the page, and comes when the server answers
    page.wait_for_selector(SAVED)


@pytest.mark.parametrize(
    ("exercise", "opened"), [("slider_crank", with_formula_editor), ("beam_diagrams", with_every_handle)]
)
def test_tab_goes_through_the_whole_page_and_back(page: Page, site: Live, exercise: str, opened: Opened) -> None:
    desk(page, site.url, exercise)
    opened(page)
    page.focus(".skip")
    there = [at_focus(page), *walk(page, "Tab")]
    page.locator("a, button, summary").last.focus()
    back = walk(page, "Shift+Tab")
    places = [stop["at"] for stop in there]
    assert len(places) > 20 and [stop["at"] for stop in back] == places[-2::-1]
    for flaw in ("rings", "sight", "large"):
        assert [stop["what"] for stop in there if not stop[flaw]] == [], flaw


def test_a_polygon_is_built_by_keyboard_alone(page: Page, site: Live) -> None:
    desk(page, site.url, "slider_crank_polygon")
    text = grading.reference(deal("slider_crank_polygon", 7))["polygon"]
    vectors = (("l1", "A", "B", "l1", "alpha1"), ("l2", "B", "C", "l2", "alpha2"), ("l3", "A", "C", "l3", "0"))
    tab_to(page, "[data-part=name]")
    for vector in vectors:
        for value in vector:
            page.keyboard.type(value)
            page.keyboard.press("Tab")
        for key in (["ArrowDown"] if vector[0] == "l3" else []) + ["Tab", "Tab"]:
            page.keyboard.press(key)
    tab_to(page, "[data-part=x]")
    for part in ("x", "y", "unknowns"):
        line = next(line for line in text.splitlines() if line.startswith(f"{part}:"))
        page.keyboard.insert_text(line.partition(": ")[2])
        page.keyboard.press("Tab")
    assert page.input_value("[name='answer.polygon']") == text
    with page.expect_navigation():
        page.keyboard.press("Control+Enter")
    assert page.locator("li:has([name='answer.polygon']) .verdict").get_attribute("class") == "verdict v-right"


def test_vectors_are_added_and_removed_by_keyboard_and_it_is_said(page: Page, site: Live) -> None:
    desk(page, site.url, "slider_crank_polygon")
    said, rows = page.locator(".builder-polygon [data-spoken]"), page.locator(".vectors li")
    row = "document.activeElement.closest('[role=group]').getAttribute('aria-label')"
    page.locator("[data-part=length]").last.focus()
    page.keyboard.press("Enter")
    expect(said).to_have_text("Vector 4 added.")
    assert rows.count() == 4 and page.evaluate(row) == "vector 4"
    assert page.evaluate("document.activeElement.dataset.part") == "length"
    page.keyboard.type("l4")
    page.keyboard.press("Control+ArrowUp")
    assert page.evaluate(row) == "vector 3"
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Delete")
    expect(said).to_have_text("Vector 3 removed, 3 left.")
    assert rows.count() == 3 and page.evaluate(row) == "vector 3"
    assert page.evaluate("document.activeElement.matches('[data-remove]')")
    assert "length l4" in page.input_value("[name='answer.polygon']")
    page.keyboard.press("Escape")
    assert page.evaluate("document.activeElement.name") == "answer.polygon"


def test_a_diagram_grows_and_shrinks_by_keyboard_and_it_is_said(page: Page, site: Live) -> None:
    desk(page, site.url, "beam_diagrams")
    said, name = page.locator(".sketch").first.locator("[role=status]"), "answer.V"
    tab_to(page, ".sketch [role=slider]")
    steps = (
        ("Enter", "Jump added at place 1."), ("Space", "Place 2 added."), ("ArrowRight", "Place 2 added."),
        ("Delete", "Place 1 removed."), ("Delete", "The two ends stay."), ("Enter", "Jump added at place 1."),
        ("Tab", "Jump added at place 1."), ("Delete", "Jump at place 1 removed."),
    )  # fmt: skip
    for key, words in steps:
        page.keyboard.press(key)
        expect(said).to_have_text(words)
    for key in ("ArrowRight", "Shift+ArrowRight", "ArrowUp", "PageUp"):
        page.keyboard.press(key)
    place, ordinate = page.input_value(f"[name='{name}.1.1']"), page.input_value(f"[name='{name}.1.2']")
    assert float(ordinate) > 0
    spoken = page.evaluate("document.activeElement.getAttribute('aria-valuetext')")
    assert spoken == f"x {place} m, V {ordinate} kN"
    assert page.evaluate("document.activeElement.getAttribute('aria-label')") == "place 1, just left"
    page.keyboard.press("Escape")
    assert page.evaluate("document.activeElement.name") == f"{name}.1.2"


def cells(page: Page, name: str, row: int) -> list[str]:
    return [page.input_value(f"[name='{name}.{row}.{column}']") for column in (1, 2, 3, 4)]


def test_a_diagram_typed_in_pieces_fills_its_table_and_the_table_its_text(page: Page, site: Live) -> None:
    desk(page, site.url, "beam_diagrams")
    name, text = "answer.V", page.locator("textarea[name='answer.V']")
    line = page.locator("li:has([name='answer.V'])")
    line.locator("summary").focus()
    page.keyboard.press("Enter")
    text.fill("0 .. 1: 4 - 2*x^2\n1 .. 5: 1")
    expect(page.locator(f"[name='{name}.3.1']")).to_have_value("5")
    assert [cells(page, name, row) for row in (1, 2)] == [["0", "4", "", "3.5"], ["1", "2", "1", ""]]
    assert line.locator(".sketch .handle").count() == 6
    page.fill(f"[name='{name}.2.3']", "1.5")
    assert text.input_value() == "0; 4; ; 3.5\n1; 2; 1.5\n5; 1"
    page.wait_for_selector(SAVED)
    page.reload()
    assert cells(page, name, 2) == ["1", "2", "1.5", ""] and text.input_value().endswith("5; 1")
    line.locator("summary").press("Enter")
    text.fill("0 .. 2: x^3")
    expect(line.locator("[data-twin-note]")).to_be_visible()
    assert cells(page, name, 1) == [""] * 4 and not line.locator(".sketch").is_visible()
    assert page.get_attribute(f"[name='{name}.1.1']", "readonly") is not None
    text.fill("")
    expect(line.locator(".sketch")).to_be_visible()
    assert page.get_attribute(f"[name='{name}.1.1']", "readonly") is None


def test_what_was_handed_in_in_pieces_stands_in_the_table_beside_its_verdict(page: Page, site: Live) -> None:
    desk(page, site.url, "beam_diagrams")
    pieces = grading.reference(deal("beam_diagrams", 7))["V"]
    page.locator("textarea[name='answer.V']").evaluate("(node, text) => { node.value = text; }", pieces)
    with page.expect_navigation():
        page.locator("[name='answer.V.1.1']").press("Control+Enter")
    line = page.locator("li:has([name='answer.V'])")
    expect(page.locator("[name='answer.V.1.1']")).to_have_value("0")
    assert line.locator(".verdict.v-right").is_visible()
    page.locator("[name='answer.V.1.2']").press("9")
    assert line.locator(".verdict").is_hidden()


def test_a_matrix_typed_as_text_fills_its_grid_and_the_grid_its_text(page: Page, site: Live) -> None:
    desk(page, site.url, "rrr_matrices")
    line, text = page.locator("li:has([name='answer.A1'])"), page.locator("textarea[name='answer.A1']")
    line.locator("summary").press("Enter")
    text.fill("[[1, 0, 0, a1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]")
    assert cells(page, "answer.A1", 1) == ["1", "0", "0", "a1"]
    page.fill("[name='answer.A1.1.4']", "7")
    assert text.input_value().startswith("[[1; 0; 0; 7], [0; 1; 0; 0]")
    text.fill("[[1, 2]]")
    expect(line.locator("[data-twin-note]")).to_be_visible()
    assert cells(page, "answer.A1", 1) == [""] * 4


def test_the_formula_editor_is_left_by_tab_and_escape_and_loses_no_key(page: Page, site: Live) -> None:
    desk(page, site.url)
    where = "document.activeElement.localName + '.' + (document.activeElement.name ?? '')"
    tab_to(page, ".visual button")
    page.keyboard.press("Enter")
    expect(page.locator("math-field")).to_be_focused()
    assert page.locator("math-field [aria-live]").get_attribute("lang") is None  # it speaks as the page does
    page.keyboard.type("l1/")  # an empty denominator is a gap that the editor's own Tab would go to
    for key, place in (
        ("Tab", "input.answer.omega2"), ("Shift+Tab", "math-field."), ("Shift+Tab", "button."), ("Tab", "math-field."),
        ("Escape", "textarea.answer.omega2_formula"),
    ):  # fmt: skip
        page.keyboard.press(key)
        assert page.evaluate(where) == place, key
    page.fill(FORMULA, "l1")
    expect(page.locator("math-field .ML__mfrac")).to_have_count(0)
    page.focus("math-field")
    page.keyboard.press("End")
    page.keyboard.press("Enter")  # no second line
    page.keyboard.type("+l2")
    with page.expect_navigation():
        page.keyboard.press("Control+Enter")  # at once: before the text has followed
    assert page.input_value(FORMULA).replace(" ", "") in ("l1+l2", "l_{1}+l_{2}", "l_1+l_2")
    assert page.locator(f"li:has({FORMULA}) .verdict").get_attribute("class") == "verdict v-wrong"
