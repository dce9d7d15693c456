"""The results of a set and of a course and a student's work, as pages that work without a script."""

from __future__ import annotations

import re
from dataclasses import replace
from html import unescape

import pytest
from markupsafe import Markup

from server.marks.gradebook import Cell, gradebook
from server.marks.pages import once
from server.web.language import LANGUAGES
from tests.server.marks.test_api import book, mark, with_open_answer
from tests.server.sets.conftest import Course, moment


def test_results_show_points_and_settle_an_open_answer_by_a_form(
    course: Course, monkeypatch: pytest.MonkeyPatch
) -> None:
    number = course.published(title="Pages")
    receipt, answers = with_open_answer(course, monkeypatch, number)
    path, person = f"/sets/{number}/results", course.school.people["student"]
    page = course.lecturer.get(f"{path}?lang=en").text
    assert "Student, task 1: undecided, 8 of 10 points" in page and "1 of 3" in page and "(provisional)" in page
    assert f'href="/sets/{number}/students/{person}#item-1"' in page
    assert "Task 1, Formula of the angular velocity of the rod" in page and "<code>omega2_formula</code>" not in page
    form = page[page.index("open-answers") :]
    typed = unescape(re.search(r"<textarea[^>]*>\n(.*?)</textarea>", form, re.DOTALL)[1])  # type: ignore[index]
    assert typed == answers["omega2_formula"]
    data = {"item": "1", "answer": "omega2_formula", "text": typed, "share": "100", "comment": "the same by hand"}
    reply = course.lecturer.post(f"/sets/{number}/open-answers", data=data)
    assert (reply.status_code, reply.headers["location"]) == (303, f"{path}#h-left")
    page = course.lecturer.get(path).text
    assert "Student, task 1: right, 10 of 10 points, marked by hand" in page and "open-answers" not in page
    assert receipt in course.lecturer.get(f"/sets/{number}/students/{person}").text


def test_cells_alike_are_drawn_once_and_filled_in_with_the_address_and_name_of_each_student(course: Course) -> None:
    number, drawn = course.published(title="Alike"), []

    def draw(cell: Cell, address: str, name: str) -> Markup:
        drawn.append(cell)
        return Markup(f'<a href="{address}#{cell.slot.number}" title="{name}">')

    task_set = course.school.portal.call(course.school.bench.sets.task_set, number)
    assert task_set is not None
    rows = course.school.portal.call(gradebook, course.school.bench, task_set).rows
    cells = once(draw)
    named = [replace(r, member=replace(r.member, person=replace(r.member.person, name='"<b>\ue000'))) for r in rows]
    assert len(rows) > 1
    assert {cells(row, f"/{at}?a&b") for at, row in enumerate(named)} == {
        f'<a href="/{at}?a&amp;b#1" title="&#34;&lt;b&gt;\ue000">' for at in range(len(rows))
    }
    assert len(drawn) == 1


def test_a_student_s_work_is_shown_in_the_student_s_language_and_marked_by_a_form(course: Course) -> None:
    number = course.published(title="Work")
    variant = course.variant(number)
    path = f"/api/v1/variants/{variant}/submissions?lang=pl"
    receipt = course.student.post(path, json={"answers": {"l3": "<b>1</b> mm"}}).json()["receipt"]["id"]
    place = f"/sets/{number}/students/{course.school.people['student']}"
    page = course.lecturer.get(f"{place}?lang=en").text
    assert 'lang="pl"' in page and "Korba ma długość" in page and "What the student saw" in page
    assert "&lt;b&gt;1&lt;/b&gt; mm" in page and "<b>1</b> mm" not in page
    assert re.search(r'<option value="l3"[^>]*>Położenie suwaka', page)  # as the student was asked, not the bare name
    data = {"receipt": receipt, "answer": "l3", "share": "12,5", "comment": "<i>half</i>\r\nof it"}
    reply = course.lecturer.post(f"/sets/{number}/marks", data=data)
    assert (reply.status_code, reply.headers["location"]) == (303, f"{place}#item-1")
    page = course.lecturer.get(place).text
    assert "12.5 %" in page and "&lt;i&gt;half&lt;/i&gt;" in page and "<i>half</i>" not in page
    assert book(course, number)["Student"]["points"] == 0.25  # an eighth of one answer of five, of ten points
    for share in ("101", "nan", "x"):
        refused = course.lecturer.post(f"/sets/{number}/marks", data=data | {"share": share})
        assert (refused.status_code, refused.json()["error"]["field"]) == (422, "share")


def test_a_student_reads_the_marks_and_comments_at_the_answer_and_at_the_result(course: Course) -> None:
    number = course.published(title="Marked")
    variant = course.variant(number)
    old, new = (course.hand_in(variant, {"l3": text}).json()["receipt"]["id"] for text in ("1 mm", "2 mm"))
    page = course.student.get(f"/variants/{variant}?lang=en").text
    assert "Your lecturer:" not in page and "What the lecturer says" not in course.student.get(f"/sets/{number}").text
    for receipt, body in ((old, {"comment": "the old one"}), (new, {"answer": "l3", "share": 0.5, "comment": "<b>"})):
        mark(course, number, receipt=receipt, **body)
    mark(course, number, receipt=new, comment="Draw it first.")
    page = course.student.get(f"/variants/{variant}?lang=en").text
    result, answers = page.split('id="h-ans"')
    assert "Draw it first." in result and "With the marks by hand: 10 % of the points." in result
    assert "50 % of the points. &lt;b&gt;" in answers and "50 %" not in result and "the old one" not in page
    assert re.search(r'aria-describedby="a2-h a2-v a2-m a2-r"', answers)
    links = re.findall(r'href="(/variants/[^"]*)">What the lecturer says', course.student.get(f"/sets/{number}").text)
    assert links == [f"/variants/{variant}?receipt={old}", f"/variants/{variant}"]
    assert "the old one" in course.student.get(links[0]).text
    place = f"/api/v1/variants/{variant}/draft"
    draft = {"revision": course.student.get(place).json()["revision"], "answers": {"l3": "3 mm"}}
    assert course.student.put(place, json=draft).status_code == 200
    result, answers = course.student.get(f"/variants/{variant}?lang=en").text.split('id="h-ans"')
    assert "50 % of the points. &lt;b&gt;" in result and "50 %" not in answers


def test_an_examination_keeps_the_marks_of_the_lecturer_back_too(course: Course) -> None:
    number = course.published(title="Held", rules={"mode": "exam"}, opens=moment(hours=-1))
    variant = course.variant(number)
    receipt = course.hand_in(variant, {"l3": "1 mm"}).json()["receipt"]["id"]
    mark(course, number, receipt=receipt, share=0.5, comment="half of it")
    pages = [course.student.get(f"{place}?lang=en").text for place in (f"/variants/{variant}", f"/sets/{number}")]
    assert not [page for page in pages if "half of it" in page or "lecturer" in page.lower()]


@pytest.mark.parametrize("language", ["pl", "en"])
def test_points_are_written_as_the_language_does(course: Course, language: str) -> None:
    number = course.published(title="Commas", item={"points": 2.5})
    worth = "2,5" if language == "pl" else "2.5"
    for path in (f"/sets/{number}", f"/courses/{course.school.course}/sets"):
        assert worth in course.student.get(f"{path}?lang={language}").text


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_results_of_a_course_link_to_those_of_its_sets(course: Course, language: str) -> None:
    number = course.published(title="Linked")
    page = course.lecturer.get(f"/courses/{course.school.course}/results?lang={language}").text
    assert f'href="/sets/{number}/results">Linked' in page and "Student" in page
    assert (
        f'href="/courses/{course.school.course}/results"'
        in course.lecturer.get(f"/courses/{course.school.course}").text
    )
    assert course.student.get(f"/sets/{number}/results").status_code == 403


def test_a_choice_is_shown_by_its_words_in_the_work_of_a_student(course: Course) -> None:
    number = course.published(title="Chosen", item={"exercise": "gear_train"})
    course.hand_in(course.variant(number), {"sense": "same"})
    page = course.lecturer.get(f"/sets/{number}/students/{course.school.people['student']}").text
    assert '<td class="code wrap-anywhere" data-label="Typed">in the same sense as the input shaft</td>' in page
