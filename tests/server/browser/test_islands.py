"""The islands in a real browser, under the content-security policy that pages are served with."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from playwright.sync_api import Browser, ConsoleMessage, Error, Page, Route, expect

BUILT = Path(__file__).parents[3] / "server/static/build"
ENTRY = json.loads((BUILT / "manifest.json").read_text())["main.ts"]
HOME = "http://grubler.test/"
POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; font-src 'self'; connect-src 'self'; form-action 'self'"
)
PAGE = f"""<!doctype html><html lang="pl"><meta charset="utf-8"><title>x</title>
<link rel="stylesheet" href="/static/build/{ENTRY["css"][0]}">
<script type="module" src="/static/build/{ENTRY["file"]}"></script>
<form method="post" action="/sent" data-preview="/preview" data-word-read="odczytano" data-word-offline="brak"
 data-draft="/draft"{{graded}}>
<template data-draft-words data-saved="zapisany {{{{time}}}}" data-saving="zapisywanie" data-unsaved="niezapisany"
 data-places="na serwerze" data-here="tutaj" data-spoken="Zapisane." data-not-saved="Jeszcze nie." data-lost="Nigdzie.">
</template>
<p><span data-draft-state>pusty</span> <small data-draft-place></small><span role="status" data-draft-spoken></span></p>
<div data-draft-conflict hidden><b data-draft-which></b><button type="button" data-draft-take="mine">moje</button>
<button type="button" data-draft-take="theirs">tamte</button></div>
<div class="answer"><span class="no">1</span><div class="body">
<label class="q" for="w">w</label><textarea id="w" name="answer.w" class="formula" rows="1" data-echo="w-e">
</textarea><div class="keys" role="group" aria-label="s" hidden><button type="button" data-insert="l1">l1</button>
<button type="button" data-insert="sqrt()" data-back="1">r</button>
<button type="button" data-key="backspace">b</button></div><p class="read" id="w-e" role="status"></p>
<div class="verdict v-right" id="w-v">Dobrze.</div></div></div>
<div class="matrix columns-2"><input name="answer.T.1.1"><input name="answer.T.1.2"><input name="answer.T.2.1">
<input name="answer.T.2.2"></div>
<label><input type="radio" name="answer.c" value="a">a</label>
<label><input type="radio" name="answer.c" value="b">b</label>
<button class="btn main" type="submit" data-sending="Wysyłanie">Sprawdź</button></form>
<p><small id="stage" data-late-in="2" data-late="po terminie" data-closed-in="5"
 data-closed="zamknięty">otwarty</small>
<small data-left="2" data-days="-" data-hours="{{first}} h {{second}} min" data-over="minął">5 h</small><span
 id="said" role="status"></span></p></html>"""

SLOW_FIRST = """() => { window.fetch = async (url, {body}) => {
  if (!url.endsWith("/preview")) return new Promise(() => {});
  const {text} = JSON.parse(body);
  await new Promise((done) => setTimeout(done, text === "a" ? 900 : 0));
  setTimeout(() => { document.documentElement.dataset.replied = text; }, 50);
  return new Response(JSON.stringify({ok: true, mathml: `<math><mi>${text}</mi></math>`}));
}; }"""

Reply = Callable[[dict[str, str]], dict[str, Any] | str | None]


def understood(mathml: str) -> dict[str, Any]:
    return {"ok": True, "mathml": mathml, "text": "t", "unit": None, "note": None}


class Site:
    """The pages and the preview as the browser sees them; nothing listens on a port."""

    def __init__(self, page: Page) -> None:
        self.page = page
        self.complaints: list[str] = []
        self.asked: list[dict[str, str]] = []
        self.languages: list[str | None] = []
        self.sent: list[str | None] = []
        self.graded = ""
        self.draft: dict[str, Any] = {"answers": {}, "revision": 0, "time": None}
        self.connected = True
        self.reply: Reply = lambda question: understood(f"<math><mi>{question['text']}</mi></math>")
        page.route(HOME + "**", self._answer)

    def _answer(self, route: Route) -> None:
        path = route.request.url.removeprefix(HOME)
        if path.startswith("static/build/"):
            route.fulfill(path=BUILT / path.rsplit("/", 1)[1])
        elif path == "preview":
            self._preview(route)
        elif path == "draft":
            self._keep(route)
        elif path == "sent":
            self.sent.append(route.request.post_data)
            route.fulfill(status=204)
        else:
            body = PAGE.replace("{graded}", self.graded)
            route.fulfill(body=body, headers={"Content-Type": "text/html", "Content-Security-Policy": POLICY})

    def _keep(self, route: Route) -> None:
        sent = json.loads(route.request.post_data or "{}")
        if not self.connected:
            route.abort()
        elif not sent:
            route.fulfill(json=self.draft)
        elif sent["revision"] != self.draft["revision"]:
            route.fulfill(status=409, json={"error": {}})
        else:
            time = "2026-11-22T09:42:00Z"
            self.draft = {"answers": sent["answers"], "revision": sent["revision"] + 1, "time": time}
            route.fulfill(json=self.draft)

    def _preview(self, route: Route) -> None:
        question = json.loads(route.request.post_data or "")
        self.asked.append(question)
        self.languages.append(route.request.headers.get("accept-language"))
        reply = self.reply(question)
        if reply is None:
            route.abort()
        else:
            route.fulfill(body=reply if isinstance(reply, str) else json.dumps(reply), content_type="application/json")

    def fails(self, error: Error) -> None:
        self.complaints.append(str(error))

    def says(self, line: ConsoleMessage) -> None:
        if "Content Security" in line.text:
            self.complaints.append(line.text)

    def open(self) -> Page:
        self.page.goto(HOME)
        self.page.wait_for_selector(".keys")
        return self.page


@pytest.fixture(scope="module")
def shared(browser: Browser) -> Iterator[Page]:
    context = browser.new_context()
    yield context.new_page()
    context.close()


@pytest.fixture
def site(shared: Page) -> Iterator[Site]:
    """The pages in a tab that keeps nothing of the test before."""
    yield from shown(shared)
    shared.goto(HOME + "static/build/" + ENTRY["css"][0])
    shared.evaluate("localStorage.clear()")
    shared.unroute_all()


@pytest.fixture
def fresh(browser: Browser) -> Iterator[Site]:
    """The pages in a browser of their own."""
    context = browser.new_context()
    yield from shown(context.new_page())
    context.close()


def shown(page: Page) -> Iterator[Site]:
    """Give the pages; fail afterwards if a script has failed or the policy was broken."""
    site = Site(page)
    page.on("pageerror", site.fails)
    page.on("console", site.says)
    yield site
    page.remove_listener("pageerror", site.fails)
    page.remove_listener("console", site.says)
    assert not site.complaints


def test_a_typed_line_is_echoed_once_as_mathematics(site: Site) -> None:
    page = site.open()
    page.type("#w", "l1")
    page.wait_for_selector("#w-e mi")
    assert site.asked == [{"answer": "w", "text": "l1"}]
    assert site.languages == ["pl"]
    assert page.inner_text("#w-e").split() == ["odczytano", "l1"]
    is_maths = "document.querySelector('#w-e mi').namespaceURI"
    assert page.evaluate(is_maths) == "http://www.w3.org/1998/Math/MathML"


def test_nothing_but_mathematics_gets_from_a_preview_into_the_page(site: Site) -> None:
    attack = (
        '<math href="javascript:x=1" onclick="x=1" style="color:red" id="w"><mi mathvariant="normal">a</mi><script>x=1'
        '</script><mtext><img src="/x" onerror="x=1"/><b>b</b></mtext><annotation-xml encoding="text/html"><p>c</p>'
        '</annotation-xml></math><img src="/y"/><p>d</p>'
    )
    site.reply = lambda question: understood(attack)
    page = site.open()
    page.type("#w", "a")
    page.wait_for_selector("#w-e mi")
    safe = '<math><mi mathvariant="normal">a</mi><mtext></mtext></math>'
    assert page.inner_html("#w-e .echo") == safe


def test_damaged_mathematics_falls_back_to_its_text(site: Site) -> None:
    site.reply = lambda question: understood("<math><mi>a</math>")
    page = site.open()
    page.type("#w", "a")
    page.wait_for_selector("#w-e .echo:text-is('t')")
    assert page.query_selector("#w-e .echo math") is None
    site.complaints.clear()  # Chromium styles its own report of the damage, which the policy stops


def test_an_unreadable_line_is_explained_and_marked_until_it_can_be_read(site: Site) -> None:
    page = site.open()
    site.reply = lambda question: {"ok": False, "message": "<b>Nie odczytano", "position": 2}
    page.type("#w", "a/")
    page.wait_for_selector("#w-e.bad")
    assert page.inner_text("#w-e") == "<b>Nie odczytano"
    assert page.get_attribute("#w", "aria-invalid") == "true"
    site.reply = lambda question: understood("<math><mi>a</mi></math>")
    page.type("#w", "b")
    page.wait_for_selector("#w-e mi")
    assert page.get_attribute("#w", "aria-invalid") is None
    page.fill("#w", "")
    assert page.inner_text("#w-e") == ""


@pytest.mark.parametrize("reply", [None, "<html>", "{}"])
def test_without_a_preview_the_page_says_so_quietly(site: Site, reply: str | None) -> None:
    site.reply = lambda question: reply
    page = site.open()
    page.type("#w", "a")
    page.wait_for_selector("#w-e:text-is('brak')")
    assert page.get_attribute("#w", "aria-invalid") is None


def test_a_late_reply_does_not_cover_a_newer_line(site: Site) -> None:
    page = site.open()
    page.evaluate(SLOW_FIRST)
    page.type("#w", "a")
    page.wait_for_timeout(450)
    page.type("#w", "b")
    page.wait_for_selector("html[data-replied='a']")
    assert page.text_content("#w-e mi") == "ab"


def test_symbol_keys_type_at_the_caret_and_give_the_focus_back(site: Site) -> None:
    page = site.open()
    page.type("#w", "2*")
    page.click("text=l1")
    page.click('button:text-is("r")')
    page.keyboard.type("x")
    assert page.input_value("#w") == "2*l1sqrt(x)"
    page.click('button:text-is("b")')
    assert page.input_value("#w") == "2*l1sqrt()"
    page.keyboard.press("Control+a")
    page.click('button:text-is("r")')
    assert page.input_value("#w") == "sqrt(2*l1sqrt())"
    page.keyboard.press("Control+z")
    assert page.input_value("#w") == "2*l1sqrt()"


def test_the_symbol_row_is_one_tab_stop_with_arrows_inside(site: Site) -> None:
    page = site.open()
    page.focus("#w")
    focused = "document.activeElement.textContent"
    page.keyboard.press("Tab")
    assert page.evaluate(focused) == "l1"
    page.keyboard.press("ArrowLeft")
    assert page.evaluate(focused) == "b"
    page.keyboard.press("Shift+Tab")
    page.keyboard.press("Tab")
    assert page.evaluate(focused) == "b"
    page.keyboard.press("Home")
    page.keyboard.press("Enter")
    assert page.input_value("#w") == "l1"
    assert page.evaluate("document.activeElement.id") == "w"


def test_a_formula_grows_takes_no_line_break_and_is_sent_once_by_ctrl_enter(site: Site) -> None:
    page = site.open()
    height = "document.querySelector('#w').offsetHeight"
    low = page.evaluate(height)
    page.fill("#w", "a+" * 300)
    assert page.evaluate(height) > 2 * low
    page.fill("#w", "a")
    page.keyboard.press("Enter")
    assert page.input_value("#w") == "a"
    assert not site.sent
    with page.expect_request(HOME + "sent"):
        for _ in range(3):
            page.keyboard.press("Control+Enter")
        page.click("button.main", force=True)
    page.wait_for_timeout(200)  # time for a second one
    assert len(site.sent) == 1
    assert page.inner_text("button.main") == "Wysyłanie"
    assert page.get_attribute("button.main", "aria-disabled") == "true"
    page.evaluate("window.dispatchEvent(new PageTransitionEvent('pageshow'))")
    assert page.inner_text("button.main") == "Sprawdź"
    assert page.get_attribute("button.main", "aria-disabled") is None


def test_the_time_left_goes_on_and_its_end_is_said(site: Site) -> None:
    page = site.open()
    page.wait_for_selector(".soon:text('0 h 0 min')")
    page.fill("[name='answer.w']", "l1 + 1")
    assert (page.inner_text("#said"), page.inner_text("#stage")) == ("", "otwarty")
    page.wait_for_selector("[data-left]:text('minął')")
    page.wait_for_selector("#stage:text('po terminie')")
    assert page.inner_text("#said") == "minął"
    page.wait_for_selector("#stage:text('zamknięty')")  # the page stays open
    assert page.input_value("[name='answer.w']") == "l1 + 1"


def test_ctrl_and_an_arrow_move_in_the_matrix(site: Site) -> None:
    page = site.open()
    page.focus('[name="answer.T.1.1"]')
    names = []
    for key in ("Right", "Down", "Left", "Up", "Up"):
        page.keyboard.press(f"Control+Arrow{key}")
        names.append(page.evaluate("document.activeElement.name"))
    assert names == ["answer.T.1.2", "answer.T.2.2", "answer.T.2.1", "answer.T.1.1", "answer.T.1.1"]


def test_a_draft_comes_back_and_is_echoed_until_it_is_graded(site: Site) -> None:
    page = site.open()
    page.fill("#w", "l1")
    page.fill('[name="answer.T.2.1"]', "5")
    page.check('[value="b"]')
    page = site.open()
    assert page.input_value("#w") == "l1"
    assert page.input_value('[name="answer.T.2.1"]') == "5"
    assert page.is_checked('[value="b"]')
    page.wait_for_selector("#w-e mi")
    site.graded = ' data-graded="R1"'
    assert site.open().input_value("#w") == ""
    page.fill("#w", "l2")
    assert site.open().input_value("#w") == "l2"  # typed after the check, on the same page
    site.graded = ""
    assert site.open().input_value("#w") == "l2"


def test_a_draft_is_saved_on_the_server_within_five_seconds_and_says_so(site: Site) -> None:
    page = site.open()
    page.fill("#w", "l1")
    assert page.inner_text("[data-draft-state]") == "zapisywanie"
    page.wait_for_selector("[data-draft-state]:text('zapisany')", timeout=5000)
    assert site.draft["answers"] == {"w": "l1", "T": "", "c": ""} and site.draft["revision"] == 1
    assert page.inner_text("[data-draft-place]") == "na serwerze"
    assert page.inner_text("[data-draft-spoken]") == ""


def test_without_a_connection_the_answers_stay_and_go_out_when_it_returns(site: Site) -> None:
    page = site.open()
    site.connected = False
    page.fill("#w", "l1")
    page.wait_for_selector("[data-draft-state]:text-is('niezapisany')")
    assert page.inner_text("[data-draft-spoken]") == "Jeszcze nie." and page.inner_text("[data-draft-place]") == "tutaj"
    assert site.open().input_value("#w") == "l1"
    site.connected = True
    page.evaluate("window.dispatchEvent(new Event('online'))")
    page.wait_for_selector("[data-draft-state]:text('zapisany')")
    assert site.draft["answers"]["w"] == "l1"


def test_what_another_device_changed_is_taken_over_or_asked(site: Site) -> None:
    page = site.open()
    site.draft = {"answers": {"w": "l2", "T": "[[1; ], [; 4]]", "c": ""}, "revision": 3, "time": None}
    page.fill("#w", "l1")
    page.wait_for_selector("[data-draft-conflict]:visible")
    assert page.input_value('[name="answer.T.2.2"]') == "4"  # changed there only
    assert page.inner_text("[data-draft-which]") == "w" and page.input_value("#w") == "l1"
    page.click("[data-draft-take=theirs]")
    assert page.input_value("#w") == "l2" and page.is_hidden("[data-draft-conflict]")
    page.fill("#w", "l3")
    page.wait_for_selector("[data-draft-state]:text('zapisany')")
    assert site.draft["revision"] == 4 and site.draft["answers"]["w"] == "l3"


def test_two_tabs_of_one_browser_agree_at_once(site: Site) -> None:
    page = site.open()
    other = page.context.new_page()
    other.route(HOME + "**", site._answer)
    other.goto(HOME)
    page.fill("#w", "l1")
    expect(other.locator("#w")).to_have_value("l1")
    other.check('[value="b"]')
    expect(page.locator('[value="b"]')).to_be_checked()
    page.wait_for_selector("[data-draft-state]:text('zapisany')")
    assert site.draft["answers"]["w"] == "l1" and page.is_hidden("[data-draft-conflict]")
    other.close()


def test_a_verdict_steps_back_while_the_answer_is_another_one(site: Site) -> None:
    page = site.open()
    verdict = page.locator("#w-v")
    assert verdict.is_visible()
    page.fill("#w", "5 mm")
    assert verdict.is_hidden()
    page.check("input[value=a]")
    page.fill("#w", "")
    assert verdict.is_visible()


def test_a_browser_that_keeps_nothing_loses_only_the_draft(fresh: Site) -> None:
    refusal = (
        "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('no', 'SecurityError'); }})"
    )
    fresh.page.add_init_script(refusal)
    page = fresh.open()
    page.type("#w", "l1")
    page.wait_for_selector("#w-e mi")
    assert page.input_value("#w") == "l1" and fresh.open().input_value("#w") == ""
