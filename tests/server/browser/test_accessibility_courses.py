"""No finding of axe-core on the pages of people, courses and sets, dark on a phone and light on a wide screen."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import pytest
from playwright.sync_api import Browser, Page

from server.settings import Settings
from tests.depth import amount
from tests.server.browser import axe
from tests.server.browser.conftest import watched
from tests.server.browser.walking import follow, width
from tests.server.conftest import Live
from tests.server.regrading.test_api import judged_otherwise
from tests.server.school import CODE
from tests.server.sets.conftest import EXERCISE, Course, made, moment
from tests.server.stores import lay

COOKIE = "grubler_session"
TASK = {"exercise": EXERCISE, "points": 10, "attempts": 2}
SIGHTS: tuple[axe.Sight, axe.Sight] = (axe.NARROW, "dark"), (axe.WIDE, "light")  # one by default, in turn
PEOPLE = ("administrator", "lecturer", "student")
MANY_TASKS = """() => document.querySelectorAll(".book tr").forEach((row) => {
    for (let more = 0; more < 12; more += 1) row.append(row.lastElementChild.cloneNode(true));
})"""


@dataclass(frozen=True, slots=True)
class Campus:
    """A running server with a course that has been worked in, and the session of each of `PEOPLE`."""

    live: Live
    paths: dict[str, str]
    cookies: dict[str, str]


def filled(course: Course) -> dict[str, str]:
    """Work in the course; gives the addresses of what there is to see."""
    school, lecturer = course.school, course.lecturer
    place = f"/api/v1/courses/{school.course}"
    lecturer.post(f"{place}/claims", json={"open": True})
    lecturer.post(f"{place}/roster", json={"csv": "2001;Olga Nowa-Żółcińska;Środa\n2002;Jan;", "apply": True})
    new = {"code": CODE, "login": "2001", "name": "Olga", "password": "a lever and a place"}
    assert school.browser().post("/api/v1/join", json=new).status_code == 201
    link = lecturer.post(f"{place}/members/{school.people['leaver']}/link").json()["link"]
    draft, number = course.built(title="Draft of set 5", due=moment(days=7), items=[TASK] * 2), course.published()
    variant = course.variant(number)
    judged_otherwise(course, course.hand_in(variant, {"l3": "1 mm"}).json()["receipt"]["id"])
    course.student.post(f"/api/v1/variants/{variant}/problems", json={"text": "The figure and the text disagree."})
    lecturer.post("/api/v1/tokens", json={"name": "nightly grading"})
    home = f"/courses/{school.course}"
    return {
        "course": home, "sets": f"{home}/sets", "log": f"{home}/audit", "class": f"{home}/results",
        "draft": f"/sets/{draft}", "set": f"/sets/{number}", "results": f"/sets/{number}/results",
        "analysis": f"/sets/{number}/analysis", "regrade": f"/sets/{number}/regrade", "card": f"/variants/{variant}",
        "work": f"/sets/{number}/students/{school.people['student']}", "person": f"/people/{school.people['student']}",
        "link": link.removeprefix(school.bench.settings.address),
    }  # fmt: skip


@pytest.fixture(scope="module")
def campus(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Campus]:
    settings = Settings(tmp_path_factory.mktemp("campus"))
    lay(settings)
    for course in made(settings):
        paths = filled(course)
        cookies = {who: str(course.school.browser(who).cookies[COOKIE]) for who in PEOPLE}
    live = Live(settings.data_dir)
    live.start()
    yield Campus(live, paths, cookies)
    live.kill()


@pytest.fixture(scope="module")
def page(browser: Browser) -> Iterator[Page]:
    context = browser.new_context(locale="en", reduced_motion="reduce")
    yield from watched(context.new_page())
    context.close()


def roster_preview(page: Page) -> None:
    page.fill("#roster", "2001;Olga Kowalska;B\n3001;Ewa;A\n3002")
    follow(page, "form:has(#roster) button")
    page.wait_for_selector("[role=alert]")


def fresh_link(page: Page) -> None:
    follow(page, "form[action$='/link'] button")
    page.wait_for_selector("[role=status] code")


def shelf(page: Page) -> None:
    page.locator(".shelf summary").first.press("Enter")
    page.wait_for_selector(".shelf input:visible")


def refused_draft(page: Page) -> None:
    page.fill("[name='slot.2.points']", "many")
    follow(page, "button[name=then]")
    page.wait_for_selector("[role=alert]")


def clashed_draft(page: Page) -> None:
    page.evaluate("""async () => {
        const form = new URLSearchParams(new FormData(document.querySelector("#draft")));
        form.set("title", `Changed in another window ${Date.now()}`);
        form.set("minutes", "45");
        await fetch(location.href, { method: "POST", body: form });
    }""")
    page.fill("#title", "Changed in this window")
    follow(page, "#draft > .row > button:not([name])")
    page.wait_for_selector("[role=alert] td")


def extra_time(page: Page) -> None:
    page.click("details:has(form[action$='/time']) > summary")
    page.wait_for_selector("#minutes")


def dry_run(page: Page) -> None:
    follow(page, "button[value=look]")


def changes(page: Page) -> None:
    dry_run(page)
    follow(page, "a[href$='/regrade']:visible")
    page.wait_for_selector("tr.begins")


def refused_sign_in(page: Page) -> None:
    page.fill("#login", "student")
    page.fill("#password", "wrong")
    follow(page, "form:has(#password) button")
    page.wait_for_selector("[role=alert]")


STATES: dict[str, tuple[str | None, str, Callable[[Page], None] | None]] = {
    "sign in": (None, "/signin", refused_sign_in),
    "join": (None, f"/join/{CODE}", None),
    "link": (None, "link", None),
    "home": ("lecturer", "/home", None),
    "account": ("lecturer", "/account", None),
    "course": ("lecturer", "course", fresh_link),
    "roster": ("lecturer", "course", roster_preview),
    "audit log": ("lecturer", "log", None),
    "reports": ("lecturer", "/problems", None),
    "sets": ("lecturer", "sets", None),
    "builder": ("lecturer", "draft", None),
    "choice of exercises": ("lecturer", "draft", shelf),
    "refused builder": ("lecturer", "draft", refused_draft),
    "draft changed twice": ("lecturer", "draft", clashed_draft),
    "work of a student": ("lecturer", "work", extra_time),
    "published set": ("lecturer", "set", None),
    "results": ("lecturer", "results", None),
    "item analysis": ("lecturer", "analysis", None),
    "regrade": ("lecturer", "regrade", None),
    "changes of a regrade": ("lecturer", "regrade", changes),
    "job": ("lecturer", "regrade", dry_run),
    "results of a course": ("lecturer", "class", None),
    "card of a student": ("student", "card", None),
    "home of a student": ("student", "/home", None),
    "course of a student": ("student", "course", None),
    "sets of a student": ("student", "sets", None),
    "set of a student": ("student", "set", None),
    "accounts": ("administrator", "/people", None),
    "person": ("administrator", "person", None),
}


def arrive(page: Page, campus: Campus, state: str) -> None:
    """Open the page of a state as who may see it."""
    who, path, act = STATES[state]
    page.context.clear_cookies()
    if who is not None:
        page.context.add_cookies([{"name": COOKIE, "value": campus.cookies[who], "url": campus.live.url}])
    reply = page.goto(campus.live.url + campus.paths.get(path, path))
    assert reply is not None and reply.status == 200, path
    if act is not None:
        act(page)


@pytest.mark.parametrize("state", STATES)
def test_axe_finds_nothing_dark_on_a_phone_and_light_on_a_wide_screen(page: Page, campus: Campus, state: str) -> None:
    first, second = SIGHTS if list(STATES).index(state) % 2 else reversed(SIGHTS)
    axe.look(page, *first)
    arrive(page, campus, state)
    broken = axe.found(page)
    for sight in amount([], [second]):
        axe.look(page, *sight)
        broken += axe.found(page, looks_only=True)
    assert broken == [], "\n".join(broken)
    page.set_viewport_size({"width": 320, "height": 800})
    assert width(page) <= 320


def test_the_points_of_a_set_of_one_task_are_seen_on_a_phone(page: Page, campus: Campus) -> None:
    page.set_viewport_size({"width": 360, "height": 740})
    page.context.add_cookies([{"name": COOKIE, "value": campus.cookies["lecturer"], "url": campus.live.url}])
    page.goto(campus.live.url + campus.paths["results"])
    points = page.locator("th.num", has_text="Points").bounding_box()
    assert points is not None and points["x"] + points["width"] <= 360


@pytest.mark.parametrize(
    "state",
    [
        "roster",
        "audit log",
        "account",
        "course",
        "draft changed twice",
        "work of a student",
        "changes of a regrade",
        "accounts",
    ],
)
def test_no_wide_table_scrolls_sideways_on_a_phone(page: Page, campus: Campus, state: str) -> None:
    page.set_viewport_size({"width": 360, "height": 740})
    arrive(page, campus, state)
    widths = page.locator(".scroll:has(> .stacks)").evaluate_all(
        "all => all.map((one) => [one.scrollWidth, one.clientWidth])"
    )
    assert widths and all(whole <= seen for whole, seen in widths), widths


@pytest.mark.parametrize("state", ["results", "results of a course"])
def test_names_and_groups_stay_beside_the_marks_on_a_phone(page: Page, campus: Campus, state: str) -> None:
    axe.look(page, axe.NARROW, "light")
    arrive(page, campus, state)
    page.evaluate(MANY_TASKS)
    page.evaluate("document.querySelector('.scroll:has(> .book)').scrollLeft = 300")
    name, mark = page.locator(".book th.person").first, page.locator(".book tbody tr td:last-child").first
    region = page.locator(".scroll:has(> .book)").bounding_box()
    found = name.bounding_box()
    assert region is not None and found is not None and found["x"] == pytest.approx(region["x"], abs=1)
    assert name.locator("small").inner_text() == "Środa" and not page.locator(".apart").first.is_visible()
    mark.scroll_into_view_if_needed()
    seen = mark.bounding_box()
    assert seen is not None and seen["x"] >= found["x"] + found["width"] - 1
