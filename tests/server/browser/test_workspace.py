"""Every kind of answer in a real browser, by keyboard: right, wrong, unreadable; editors, files, a lost connection."""

from __future__ import annotations

import re
from functools import cache

import pytest
from playwright.sync_api import Browser, Page, expect

from exercises import grading
from exercises.solving import solved
from exercises.variants import deal
from graders import KINDS
from tests.server.browser import components, posing
from tests.server.browser.walking import desk, follow
from tests.server.conftest import Live

TASKS = {
    "gear_train": ("z4", "u_formula", "u", "sense"), "planetary": ("u0",), "rrr_inverse": ("q",),
    "rrp_table": ("P", "A1"), "beam_diagrams": ("V",), "beam_deflection": ("M",), "slider_crank_cycle": ("cycle",),
    "slider_crank_polygon": ("polygon", "velocities"), "offset_slider_crank": ("position", "turning"),
}  # fmt: skip
OFF = ("v-wrong", "v-partly")
SAVED = "[data-draft-state]:text('saved')"


@cache
def texts(exercise: str, name: str) -> tuple[str, str, str]:
    """A right, a wrong and an unreadable text of an answer."""
    task = solved(deal(exercise, 7))
    shown = task.answers[name].samples(task.reference(name))
    return shown.right[0], shown.wrong[0], next(text for text in shown.unreadable if text.strip())


def tick(page: Page, name: str, wanted: list[str]) -> None:
    """Tick these boxes of an answer and no others by the space bar."""
    for box in page.locator(f"[name='answer.{name}']").all():
        if box.is_checked() != (box.get_attribute("value") in wanted):
            box.press("Space")


def type_in(page: Page, name: str, text: str) -> bool:
    """Type an answer by keyboard; False where it cannot be typed, as an unreadable choice."""
    field = page.locator(f"[name='answer.{name}']").first
    if field.get_attribute("type") == "checkbox":
        tick(page, name, text.split("; "))
        return True
    if field.get_attribute("type") == "radio":
        option = page.locator(f"[name='answer.{name}'][value='{text}']")
        if option.count() == 0:
            return False
        option.focus()
        page.keyboard.press("Space")
        return True
    for summary in field.locator("xpath=ancestor::details[not(@open)]/summary").all()[:1]:
        summary.focus()
        page.keyboard.press("Enter")
    field.focus()
    page.keyboard.press("Control+a")
    page.keyboard.insert_text(text)
    return True


def outcome(page: Page, name: str) -> set[str]:
    """The classes of the verdict that stands by an answer."""
    line = page.locator(f"li.answer:has([name='answer.{name}'])")
    return set((line.locator(".verdict").get_attribute("class") or "").split())


def test_every_kind_is_among_those_that_are_answered_here() -> None:
    tasks = {exercise: solved(deal(exercise, 7)).answers for exercise in TASKS}
    asked = {tasks[exercise][name].kind for exercise, names in TASKS.items() for name in names}
    assert asked | set(posing.POSED) == set(KINDS)


@pytest.mark.parametrize("exercise", TASKS)
def test_each_kind_is_answered_right_wrong_and_unreadably_by_keyboard(page: Page, site: Live, exercise: str) -> None:
    desk(page, site.url, exercise)
    for outcomes, place in ((("v-right",), 0), (OFF, 1), (("v-unread",), 2)):
        typed = [name for name in TASKS[exercise] if type_in(page, name, texts(exercise, name)[place])]
        with page.expect_navigation():
            page.keyboard.press("Control+Enter")
        for name in typed:
            seen = outcome(page, name)
            assert seen & set(outcomes), (name, seen, texts(exercise, name)[place])


def test_kinds_without_an_exercise_are_answered_right_wrong_and_unreadably_by_keyboard(page: Page, site: Live) -> None:
    posing.page(page, site.url)
    for outcomes, place in ((("v-right",), 0), (OFF, 1), (("v-unread",), 2)):
        wanted = {kind: text for kind in posing.POSED if (text := posing.texts(kind)[place]) is not None}
        for kind, text in wanted.items():
            type_in(page, kind, text)
        with page.expect_navigation():
            page.keyboard.press("Control+Enter")
        for kind, text in wanted.items():
            assert outcome(page, kind) & set(outcomes), (kind, outcome(page, kind), text)
    type_in(page, "text", "The rod turns back.")
    with page.expect_navigation():
        page.keyboard.press("Control+Enter")
    assert "v-undecided" in outcome(page, "text")


def test_a_grid_is_filled_and_echoed_by_keyboard(page: Page, site: Live) -> None:
    desk(page, site.url, "rrr_matrices")
    page.focus("[name='answer.A1.1.1']")
    for row in range(1, 5):
        for column in range(1, 5):
            page.keyboard.insert_text(f"{row}{column}")
            page.keyboard.press("Control+ArrowRight")
        page.keyboard.press("Control+ArrowDown")
        for _ in range(3):
            page.keyboard.press("Control+ArrowLeft")
    page.wait_for_selector("li:has([name='answer.A1']) .read math mtable")
    assert page.input_value("[name='answer.A1.4.4']") == "44"
    page.wait_for_selector(SAVED)
    page.reload()
    assert page.input_value("[name='answer.A1.3.2']") == "32"


PASTE = """([selector, text]) => {
  const clipboardData = new DataTransfer(), bubbles = true, cancelable = true;
  clipboardData.setData("text/plain", text);
  document.querySelector(selector).dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles, cancelable }));
}"""


@pytest.mark.parametrize("cell", ["2.1", "3.2"])  # from the second there is no room: the table fills the whole grid
def test_a_table_copied_from_a_sheet_fills_the_cells(page: Page, site: Live, cell: str) -> None:
    desk(page, site.url, "rrr_matrices")
    table = "50\t0\t0,36\t0\r\n-40\t0\t0\t0\r\n"
    page.evaluate(PASTE, [f"[name='answer.P.{cell}']", table])
    first = 2 if cell == "2.1" else 1
    assert [page.input_value(f"[name='answer.P.{first}.{at}']") for at in (1, 2, 3, 4)] == ["50", "0", "0,36", "0"]
    assert [page.input_value(f"[name='answer.P.{first + 1}.{at}']") for at in (1, 2)] == ["-40", "0"]
    assert "[50; 0; 0,36; 0], [-40; 0; 0; 0]" in page.input_value("textarea[name='answer.P']")


def test_a_diagram_is_drawn_by_keyboard_and_is_its_table(page: Page, site: Live) -> None:
    desk(page, site.url, "beam_diagrams")
    first = page.locator(".sketch [role=slider]").first
    first.focus()
    for key in ("Insert", "Tab", "ArrowUp", "Shift+ArrowUp", "+"):
        page.keyboard.press(key)
    cells = [page.input_value(f"[name='answer.V.1.{column}']") for column in (1, 2, 3)]
    assert cells[:2] == ["0", "0"] and float(cells[2]) > 0
    assert cells[2] in str(page.evaluate("document.querySelector('.handle.right').getAttribute('aria-valuetext')"))
    page.wait_for_selector("li:has([name='answer.V']) .read .echo")
    page.fill("[name='answer.V.1.3']", "-4")
    knob = page.locator(".sketch .handle.right").first
    assert "−4 kN" in (knob.get_attribute("aria-valuetext") or "")
    moment = page.locator(".sketch[data-quantity=M] [role=slider]").first
    moment.focus()
    page.keyboard.press("ArrowUp")
    assert page.input_value("[name='answer.M.1.2']").startswith("-")  # seen going up: M points down


def test_a_polygon_is_built_row_by_row(page: Page, site: Live) -> None:
    desk(page, site.url, "slider_crank_polygon")
    text = grading.reference(deal("slider_crank_polygon", 7))["polygon"]
    vectors = (
        ("l1", "A", "B", "l1", "alpha1", "+"),
        ("l2", "B", "C", "l2", "alpha2", "+"),
        ("l3", "A", "C", "l3", "0", "-"),
    )
    for row, vector in enumerate(vectors):
        item = page.locator(".vectors li").nth(row)
        for part, value in zip(("name", "from", "to", "length", "angle", "sign"), vector, strict=True):
            control = item.locator(f"[data-part={part}]")
            if part in ("from", "to", "sign"):
                control.select_option(value)
            else:
                control.fill(value)
    for part in ("x", "y", "unknowns"):
        line = next(line for line in text.splitlines() if line.startswith(f"{part}:"))
        page.fill(f".builder-polygon [data-part={part}]", line.partition(": ")[2])
    assert page.input_value("[name='answer.polygon']") == text
    page.fill("[name='answer.polygon']", text.replace("l1: A > B", "l1: B > A"))
    assert page.locator(".vectors li").first.locator("[data-part=from]").input_value() == "B"
    page.locator(".vectors [data-remove]").last.click()
    assert "l3: A > C" not in page.input_value("[name='answer.polygon']")


def test_orders_boxes_and_files_are_answers(page: Page, site: Live) -> None:
    desk(page, site.url)
    address, whole = f"{site.url}/kinds", components.page(page.request.get(page.url).text())
    page.route(address, lambda route: route.fulfill(body=whole, content_type="text/html"))
    page.goto(address)
    page.locator(".order button").nth(1).press("Enter")
    assert page.input_value("[name='answer.ordering']") == "b; a; c"
    assert "now number 2" in page.inner_text("li:has(.order) .vh[role=status]")
    page.fill("[name='answer.ordering']", "c; b; a")
    assert page.locator(".order li").first.get_attribute("data-letter") == "c"
    for option in ("one", "three"):
        page.locator(f"[name='answer.choices'][value={option}]").press("Space")
    assert page.locator("[name='answer.choices']:checked").count() == 2
    sheet = {"name": "cycle.csv", "mimeType": "text/csv", "buffer": "\ufefft;x\r\n0;1,5\r\n".encode()}
    page.set_input_files(".drop input", sheet)  # type: ignore[arg-type]
    page.wait_for_selector(".drop [role=status]:text('cycle.csv')")
    assert page.input_value("[name='answer.samples']") == "t;x\n0;1,5"
    page.set_input_files(".drop input", sheet | {"buffer": b"0" * 50_000})  # type: ignore[arg-type]
    page.wait_for_selector(".drop [role=status]:text('too large')")


def test_the_visual_editor_keeps_in_step_with_the_text(page: Page, site: Live) -> None:
    desk(page, site.url)
    field = "[name='answer.omega2_formula']"
    page.fill(field, "l1")
    page.click(".visual button")
    expect(page.locator("math-field .ML__latex")).to_contain_text("l1")
    page.keyboard.press("End")
    page.keyboard.type("*omega1/")
    page.keyboard.type("l2")
    expect(page.locator(field)).to_have_value(re.compile("/l2"))
    assert page.input_value(field).replace("(", "").replace(")", "") == "l1*omega1/l2"
    box = page.locator("math-field").bounding_box()
    assert box is not None and box["height"] > 40
    assert (
        page.evaluate(
            "getComputedStyle(document.querySelector('math-field').shadowRoot.querySelector('[part=container]')).visibility"
        )
        == "visible"
    )


DRAWN = """() => {
    const root = document.querySelector("math-field").shadowRoot;
    const most = (side) => (["x", "y"].includes(side) ? Math.min : Math.max);
    const boxes = (all) => [...root.querySelectorAll(all)].map((one) => one.getBoundingClientRect());
    const whole = (all) => ["x", "y", "right", "bottom"].map(
        (side) => most(side)(...boxes(all).map((box) => box[side])));
    const [drawn, marked] = [whole(".ML__base"), whole(".ML__selection")];
    return drawn.map((side, k) => Math.abs(side - marked[k]));
}"""


def test_what_is_selected_in_the_visual_editor_is_marked_where_it_stands(page: Page, site: Live) -> None:
    desk(page, site.url)
    page.click(".visual button")
    page.wait_for_selector("math-field:focus")
    page.keyboard.type("omega1*l1/l2")
    page.keyboard.press("Control+a")
    page.wait_for_selector("math-field .ML__selection")
    assert max(page.evaluate(DRAWN)) < 8


@pytest.mark.parametrize("typed", ["Theta1_d*l_AB-v_Cx", "[Theta1_d][*][l_AB]-[v_Cx]"])
def test_names_with_a_mark_below_are_typed_in_the_visual_editor(page: Page, site: Live, typed: str) -> None:
    desk(page, site.url, "tmm2_oop")
    page.evaluate("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
    line = page.locator("li:has(> .body [name='answer.v_x_formula'])").last
    line.locator(".visual button").click()
    page.wait_for_selector("math-field:focus")
    for key, text in re.findall(r"\[(.+?)\]|([^\[\]]+)", typed):
        page.keyboard.type(text) if text else line.locator(f"[data-insert='{key}']").click()
    expect(page.locator("[name='answer.v_x_formula']")).to_have_value("Theta1_d*l_AB - v_Cx")


@pytest.mark.parametrize(
    ("language", "said"), [("pl", "koniec: licznik"), ("en", "end of numerator"), ("ru", "конец: числитель")]
)
def test_the_visual_editor_speaks_the_language_of_the_page(page: Page, site: Live, language: str, said: str) -> None:
    desk(page, site.url)
    page.goto(f"{page.url}?lang={language}")
    page.click(".visual button")
    page.wait_for_selector("math-field:focus")
    page.keyboard.type("l1/l2")
    page.keyboard.press("ArrowLeft")
    page.keyboard.press("ArrowUp")
    expect(page.locator("math-field [aria-live]")).to_contain_text(said)


def test_a_lost_connection_keeps_the_answers_and_sends_them_when_it_is_back(page: Page, site: Live) -> None:
    desk(page, site.url)
    page.locator("[name='answer.l3']").press_sequentially("12,")
    page.context.set_offline(True)
    page.locator("[name='answer.l3']").press_sequentially("5 mm")
    page.wait_for_selector("[data-draft-state]:text('not saved yet')")
    assert "kept in this browser" in page.inner_text("[data-draft-place]")
    page.context.set_offline(False)
    page.wait_for_selector(SAVED)
    other = page.context.new_page()
    other.goto(page.url)
    assert other.input_value("[name='answer.l3']") == "12,5 mm"
    other.fill("[name='answer.v3']", "1 m/s")
    expect(page.locator("[name='answer.v3']")).to_have_value("1 m/s")
    other.close()


def test_who_is_not_known_any_more_is_told_to_sign_in(page: Page, site: Live) -> None:
    desk(page, site.url)
    page.context.clear_cookies()
    page.fill("[name='answer.l3']", "500 mm")
    expect(page.locator("[data-draft-place]")).to_contain_text("your session has ended: sign in in another tab")
    follow(page, "button.main")
    assert page.locator("textarea[readonly]").input_value() == "500 mm"


def test_what_is_handed_in_without_a_connection_waits_for_it(page: Page, site: Live) -> None:
    desk(page, site.url)
    button, waiting = page.locator("form[data-preview] button.main"), page.locator("[data-waiting]")
    page.fill("[name='answer.l3']", "12,5 mm")
    page.context.set_offline(True)
    button.click()
    expect(waiting).to_contain_text("No connection. Your answers are kept in this browser")
    page.fill("[name='answer.l3']", "12,6 mm")
    expect(waiting).to_be_empty()
    expect(button).to_have_text("Check answers")
    page.focus("[name='answer.l3']")
    page.keyboard.press("Enter")
    expect(waiting).not_to_be_empty()
    with page.expect_navigation(url="**receipt=*"):
        page.context.set_offline(False)
    assert page.input_value("[name='answer.l3']") == "12,6 mm"
    assert page.locator("li:has([name='answer.l3']) .verdict").count() == 1


def test_two_tabs_that_write_different_answers_are_put_together(page: Page, site: Live) -> None:
    desk(page, site.url)
    other = page.context.new_page()
    other.goto(page.url)
    length, speed = "[name='answer.l3']", "[name='answer.v3']"
    for key in "125,":
        page.locator(length).press_sequentially(key)
        other.locator(speed).press_sequentially(key)
    page.locator(length).press_sequentially("5 mm")
    other.locator(speed).press_sequentially("1 m/s")
    for tab in (page, other):
        expect(tab.locator(length)).to_have_value("125,5 mm")
        expect(tab.locator(speed)).to_have_value("125,1 m/s")
        expect(tab.locator("[data-draft-state]")).to_contain_text("saved")
        assert tab.is_hidden("[data-draft-conflict]")
    kept = page.request.get(f"{site.url}/api/v1/variants/{page.url.split('/')[-1]}/draft").json()["answers"]
    assert (kept["l3"], kept["v3"]) == ("125,5 mm", "125,1 m/s")
    other.close()


def test_an_answer_that_is_changed_in_another_tab_at_once_is_what_was_typed_last(page: Page, site: Live) -> None:
    desk(page, site.url)
    other = page.context.new_page()
    other.goto(page.url)
    for tab, text in ((page, "1 mm"), (other, "1,5 mm"), (page, "2 mm")):
        tab.fill("[name='answer.l3']", text)
        for each in (page, other):
            expect(each.locator("[name='answer.l3']")).to_have_value(text)
    for tab in (page, other):
        expect(tab.locator("[data-draft-state]")).to_contain_text("saved")
        assert tab.input_value("[name='answer.l3']") == "2 mm" and tab.is_hidden("[data-draft-conflict]")
    other.close()


def on_a_phone(page: Page, site: Live, browser: Browser) -> Page:
    """The same page of the same person on a phone; nothing that the first browser keeps."""
    phone = browser.new_context(locale="en", viewport={"width": 360, "height": 740}, has_touch=True, is_mobile=True)
    for cookie in page.context.cookies():
        phone.add_cookies([{"name": cookie["name"], "value": cookie["value"], "url": site.url}])
    small = phone.new_page()
    small.goto(page.url)
    return small


def test_what_two_devices_wrote_is_asked_about_in_sight_of_a_phone(page: Page, site: Live, browser: Browser) -> None:
    desk(page, site.url)
    small = on_a_phone(page, site, browser)
    page.fill("[name='answer.l3']", "17 mm")
    page.keyboard.press("Tab")
    page.wait_for_selector(SAVED)
    small.fill("[name='answer.l3']", "18 mm")
    small.tap("[name='answer.v3']")
    asked = small.locator("[data-draft-conflict]")
    expect(asked).to_be_in_viewport(ratio=1)
    small.locator("[name='answer.alpha2']").focus()  # above the field that was left: it stands clear of the question
    box, field = asked.bounding_box(), small.locator("[name='answer.alpha2']").bounding_box()
    assert box is not None and field is not None and field["y"] >= box["y"] + box["height"]
    small.tap("[data-draft-take=theirs]")
    expect(small.locator("[name='answer.l3']")).to_have_value("17 mm")
    assert asked.is_hidden()
    small.context.close()


def test_another_device_finds_what_was_typed_on_the_first(page: Page, site: Live, browser: Browser) -> None:
    desk(page, site.url)
    page.fill("[name='answer.l3']", "17 mm")
    page.keyboard.press("Tab")
    page.wait_for_selector(SAVED)
    small = on_a_phone(page, site, browser)
    assert small.input_value("[name='answer.l3']") == "17 mm"
    small.tap("[name='answer.omega2_formula']")
    small.tap(".keys button[data-insert='l1']")
    small.tap(".keys button[data-insert='*']")
    assert small.input_value("[name='answer.omega2_formula']") == "l1*"
    assert (
        small.evaluate("Math.min(...[...document.querySelectorAll('.keys button')].map((key) => key.offsetHeight))")
        >= 44
    )
    assert small.evaluate("document.documentElement.scrollWidth") <= 360
    small.tap("[name='answer.l3']")  # leaving a field saves at once
    small.wait_for_selector(SAVED)
    small.context.close()
    page.fill("[name='answer.v3']", "1 m/s")  # the other device came first: both are kept
    page.keyboard.press("Tab")
    expect(page.locator("[name='answer.omega2_formula']")).to_have_value("l1*")
    assert page.input_value("[name='answer.v3']") == "1 m/s" and page.is_hidden("[data-draft-conflict]")
