"""The laboratory in a real browser: from the polygon to the report, a wrong formula, a phone, keyboard, samples."""

from __future__ import annotations

import re
from base64 import b64encode
from collections.abc import Mapping
from pathlib import Path

from playwright.sync_api import Browser, Page, Route, expect

from exercises import grading
from exercises.variants import deal
from tests.exercises.test_arms import closed_by_one_vector
from tests.server.browser.walking import desk, focus_by_tab, follow
from tests.server.conftest import Live

RIGHT = grading.reference(deal("tmm2_oop", 7))
WRONG = RIGHT["polygon"].replace("l_AB*sin(Theta1)", "l_AB*cos(Theta1)")
AGREES = "The links keep their lengths, and D follows the true motion."


def part(page: Page, name: str) -> str:
    return page.inner_text(f"[data-lab='{name}']")


def fill(page: Page, name: str, text: str) -> None:
    field = page.locator(f"[name='answer.{name}']")
    if not field.is_visible():
        page.click(f".sections > li:has([name='answer.{name}']) > details > summary")
    field.fill(text)


def fill_all(page: Page, answers: Mapping[str, str]) -> None:
    """Type all answers at once, whether their sections are open or not."""
    page.evaluate(
        """(answers) => Object.entries(answers).forEach(([name, text]) => {
          const field = document.querySelector(`[name='answer.${name}']`);
          field.value = text;
          field.dispatchEvent(new Event("input", { bubbles: true }));
        })""",
        answers,
    )


def test_the_laboratory_from_the_polygon_to_the_report(page: Page, site: Live) -> None:
    desk(page, site.url, "tmm2_oop")
    fill(page, "polygon", RIGHT["polygon"])
    expect(page.locator("[data-lab='note']")).to_have_text(AGREES)
    assert "waits for section 10" in page.inner_text("[data-plot='velocity'] output")
    follow(page, "button[name='section'][value='7']")
    page.wait_for_selector("#section-7 .v-right")
    fill_all(page, RIGHT)
    expect(page.locator("[data-plot='acceleration'] output")).to_contain_text("m/s²")
    page.press("#lab-l_AB", "End")
    expect(page.locator("[data-lab='ratio']")).to_have_text(f"{float(RIGHT['k_v']):.4f}")
    expect(page.locator("[data-draft-state]")).to_contain_text("saved")
    follow(page, "form[data-preview] button.main")
    page.wait_for_selector("#result")
    assert page.inner_text("#result") == "21 of 23 right"
    assert page.locator(".sections .v .v-right").count() == 6 and page.locator(".sections .v .v-undecided").count() == 2
    page.fill("#person-name", "Anna Nowak")
    for button, head in (("PDF", b"%PDF"), ("Markdown", b"# ")):
        with page.expect_download() as saved:
            page.click(f"[data-person] button:text-is('{button}')")
        content = Path(saved.value.path()).read_bytes()
        assert content.startswith(head)
    assert "Anna Nowak" in content.decode() and "Theta" not in content.decode()[:200]


def test_a_polygon_closed_by_one_vector_moves_under_coordinates_of_its_end(page: Page, site: Live) -> None:
    typed = closed_by_one_vector("tmm2_oop", 7)
    desk(page, site.url, "tmm2_oop")
    fill(page, "polygon", typed["polygon"].replace("r*cos(phi)", "x_D").replace("r*sin(phi)", "y_D"))
    expect(page.locator("[data-lab='note']")).to_have_text(AGREES)
    fill(page, "velocities", typed["velocities"])
    expect(page.locator("[data-plot='velocity'] output")).to_contain_text("m/s")


def test_one_wrong_formula_breaks_the_named_link_in_the_language_of_the_page(page: Page, site: Live) -> None:
    desk(page, site.url, "tmm2_oop")
    fill(page, "polygon", WRONG)
    expect(page.locator("[data-lab='note']")).to_have_text(
        re.compile(r"Link AB is 0\.430\u202fm long; your formulas make it 0\.106\u202fm\.")
    )
    own = page.locator("[data-link]:not([data-link=''])")
    assert [own.nth(k).get_attribute("class") for k in range(3)] == ["f-load f-heavy", "f-link", "f-link"]
    assert page.input_value("#lab-t") == "0"
    page.click("[data-lab='play']")
    expect(page.locator("#lab-t")).not_to_have_value("0")
    page.click("[data-lab='play']")
    page.wait_for_selector("[data-draft-state]:has-text('saved')")
    follow(page, ".tools a[hreflang='pl']")
    expect(page.locator("[data-lab='note']")).to_have_text(
        "Człon AB ma 0,430\u202fm, a z Twoich wzorów wychodzi 0,106\u202fm."
    )


def test_a_section_is_opened_filled_and_checked_by_keyboard_on_a_phone(page: Page, site: Live) -> None:
    page.set_viewport_size({"width": 360, "height": 740})
    desk(page, site.url, "tmm2_oop")
    for _ in range(80):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.closest('#section-9') !== null"):
            break
    page.keyboard.press("Enter")
    focus_by_tab(page, "answer.alpha3")
    page.keyboard.type(RIGHT["alpha3"])
    for _ in range(3):
        page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    page.wait_for_selector("#section-9 .verdict")
    assert page.evaluate("document.activeElement.id") == "section-9"
    assert page.inner_text("#section-9 .verdict strong") == "Right."
    page.evaluate("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
    assert page.evaluate("document.documentElement.scrollWidth") == 360
    page.focus("#lab-t")
    page.keyboard.press("End")
    assert page.inner_text("[data-lab='time-value']") == "2.00\u202fs"


def test_enter_in_a_field_checks_its_own_section_and_no_other(page: Page, site: Live) -> None:
    desk(page, site.url, "tmm2_oop")
    page.locator("#section-9 summary").first.click()
    page.fill("[name='answer.alpha3']", "10°")
    with page.expect_navigation():
        page.press("[name='answer.alpha3']", "Enter")
    assert page.url.endswith("&section=9#section-9")
    assert page.locator("#section-9 .verdict").first.is_visible()


def test_a_hint_in_a_section_is_one_line_to_open(page: Page, site: Live) -> None:
    page.set_viewport_size({"width": 360, "height": 740})
    desk(page, site.url, "tmm2_oop")
    fill(page, "x_D", "9 m")
    follow(page, "button[name='section'][value='9']")
    hint = page.locator("#section-9 details.hint > summary").first
    assert hint.evaluate("one => getComputedStyle(one).display") == "list-item"
    box = hint.bounding_box()
    assert box is not None and box["height"] < 60


def test_samples_come_back_and_the_largest_difference_is_told(page: Page, site: Live) -> None:
    desk(page, site.url, "tmm2_oop")
    fill(page, "polygon", RIGHT["polygon"])
    expect(page.locator("[data-lab='note']")).to_have_text(AGREES)
    with page.expect_download() as saved:
        page.click("[data-lab='export']")
    head, first, *rows = Path(saved.value.path()).read_text().splitlines()
    t, x, *more = first.split(";")
    page.fill("#lab-csv", "\n".join([head, ";".join([t, str(float(x) + 0.01), *more]), *rows]))
    page.click("[data-lab='compare']")
    assert part(page, "differences") == "Column x: largest difference 0.0100\u202fm at t = 0.00\u202fs."
    page.fill("#lab-csv", "x\n1")
    page.click("[data-lab='compare']")
    assert part(page, "differences").startswith("Line 1 was not read.")
    fill(page, "polygon", "l1: A > , co")
    expect(page.locator("[data-lab='note']")).to_have_text("The polygon has not been read yet; section 7 says why.")


def test_without_script_five_positions_stand_in_the_place_of_the_stage(browser: Browser, site: Live) -> None:
    context = browser.new_context(locale="pl", java_script_enabled=False)
    plain = context.new_page()
    desk(plain, site.url, "slider_crank_polygon")
    assert plain.locator(".strip svg:visible").count() == 5
    assert plain.locator("[data-lab='play']:visible").count() == 0
    context.close()


def test_while_results_are_held_nothing_of_the_true_motion_is_shown(page: Page, site: Live) -> None:
    def hold(route: Route) -> None:
        reply = route.fetch()
        route.fulfill(response=reply, body=reply.text().replace(" data-laboratory=", " data-held data-laboratory="))

    page.route("**/variants/*", hold)
    desk(page, site.url, "tmm2_oop")
    fill(page, "polygon", WRONG)
    expect(page.locator("[data-lab='note']")).to_contain_text("In an examination")
    assert page.locator("[data-link='AB']").get_attribute("class") == "f-link"
    assert page.locator("[data-lab='stage'] .f-ghost").count() == 0
    assert part(page, "distance") == "–"


INKED = """async (picture) => {
  const bytes = Uint8Array.from(atob(picture), (sign) => sign.charCodeAt(0));
  const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
  const canvas = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
  canvas.drawImage(bitmap, 0, 0);
  const row = (y) => [...canvas.getImageData(0, y, bitmap.width, 1).data].filter((_, at) => at % 4 === 0);
  return [...Array(bitmap.height).keys()].map((y) => Math.min(...row(y)) < 128);
}"""


def test_the_dot_of_a_rate_stands_free_of_a_tall_letter(browser: Browser, site: Live) -> None:
    context = browser.new_context(device_scale_factor=4, color_scheme="light")
    page = context.new_page()
    desk(page, site.url, "tmm2_oop")
    page.click("a[href='#givens']")
    rate = page.locator("#givens td mover", has_text="h˙").first
    rate.scroll_into_view_if_needed()
    box = rate.bounding_box()
    assert box is not None
    picture = page.screenshot(clip={**box, "y": box["y"] - 4, "height": box["height"] + 4})
    inked = page.evaluate(INKED, b64encode(picture).decode())
    begins = [at for at in range(1, len(inked)) if inked[at] and not inked[at - 1]]
    assert len(begins) == 2, "the dot, and the letter below it"
    context.close()
