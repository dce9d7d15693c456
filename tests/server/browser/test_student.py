"""A student in a real browser: by keyboard alone, without script, on a phone, in three languages."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from playwright.sync_api import Browser, Page

from exercises import catalogue, grading
from exercises.variants import deal
from server.web import static_files
from tests.server.browser.conftest import watched
from tests.server.browser.walking import desk, focus_by_tab, follow, practise, width
from tests.server.conftest import Live

RIGHT = grading.reference(deal("slider_crank", 7))
WIDTHS = (1360, 360, 320)
BUTTONS = {"pl": "Sprawdź odpowiedzi", "ru": "Проверить ответы", "en": "Check answers"}


@pytest.fixture
def plain(browser: Browser) -> Iterator[Page]:
    """A browser without script."""
    context = browser.new_context(locale="pl", java_script_enabled=False)
    yield from watched(context.new_page())
    context.close()


def test_right_wrong_and_unreadable_by_keyboard_alone(page: Page, site: Live) -> None:
    practise(page, site)
    for name, text in (("alpha2", RIGHT["alpha2"]), ("l3", "1 mm"), ("v3", "1 m/")):
        focus_by_tab(page, f"answer.{name}")
        page.keyboard.type(text)
    with page.expect_navigation():
        page.keyboard.press("Enter")
    page.wait_for_selector("#result:focus")
    assert page.evaluate("document.activeElement.id") == "result"
    assert page.inner_text("#result") == "1 of 5 right"
    seen = {name: page.inner_text(f"li:has([name='answer.{name}']) .verdict strong") for name in ("alpha2", "l3", "v3")}
    assert seen["alpha2"] == "Right." and seen["l3"].startswith("Not yet") and seen["v3"].startswith("Not read")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    assert page.evaluate("document.activeElement.closest('li.answer') !== null")


def test_without_script_a_task_is_read_previewed_and_checked(plain: Page, site: Live) -> None:
    practise(plain, site)
    for name, text in RIGHT.items():
        plain.fill(f"[name='answer.{name}']", text)
    follow(plain, "button[formaction]")
    assert "odczytano" in plain.inner_text(".answers")
    follow(plain, "button.main")
    assert plain.inner_text("#result") == "Dobrze: 5 z 5"
    assert plain.locator(".keys:visible").count() == 0
    follow(plain, "a[href$='/solution']")
    assert plain.inner_text("h1") == "Rozwiązanie krok po kroku"


def too_narrow(page: Page) -> list[int]:
    """The widths at which the page scrolls sideways."""
    found = []
    for wide in WIDTHS:
        page.set_viewport_size({"width": wide, "height": 800})
        found += [wide] if width(page) > wide else []
    return found


def test_the_catalogue_does_not_scroll_sideways(page: Page, site: Live) -> None:
    page.goto(site.url)
    assert too_narrow(page) == []


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_nothing_scrolls_sideways(page: Page, site: Live, exercise: str) -> None:
    desk(page, site.url, exercise)
    address = page.url
    page.goto(f"{address}?lang=ru")  # the language of the longest words
    assert too_narrow(page) == []
    page.goto(f"{address}?lang=en")
    place = address.replace("/variants/", "/api/v1/variants/")
    graded = page.request.post(f"{place}/submissions", data={"answers": grading.reference(deal(exercise, 7))})
    page.goto(f"{address}?receipt={graded.json()['receipt']['id']}")
    page.evaluate("document.querySelectorAll('form details').forEach((one) => { one.open = true; })")
    assert page.locator(".verdict").count() > 0 and too_narrow(page) == []
    follow(page, "a[href$='/solution']")
    assert too_narrow(page) == []


def test_the_language_switches_and_stays(page: Page, site: Live) -> None:
    desk(page, site.url)
    for language, button in BUTTONS.items():
        follow(page, f".tools a[hreflang='{language}']")
        assert page.inner_text("button.main") == button
        assert page.get_attribute("html", "lang") == language
        assert f'<html lang="{language}"' in page.request.get(site.url).text()


def test_the_echo_comes_while_typing_and_the_draft_stays(page: Page, site: Live) -> None:
    if static_files.find().script is None:
        pytest.skip("the asset build is missing: the islands were not tried on a served page")
    practise(page, site)
    page.locator("[name='answer.l3']").press_sequentially("12,5")
    page.wait_for_selector("li:has([name='answer.l3']) .read math")
    assert "mm" in page.inner_text("li:has([name='answer.l3']) .read")
    page.click("li:has([name='answer.omega2_formula']) .keys button[data-insert='l1']")
    assert page.input_value("[name='answer.omega2_formula']") == "l1"
    page.wait_for_timeout(500)
    page.reload()
    assert page.input_value("[name='answer.l3']") == "12,5"
    follow(page, "form[data-preview] button.main")
    assert page.inner_text("li:has([name='answer.l3']) .verdict strong").startswith("Not yet")
