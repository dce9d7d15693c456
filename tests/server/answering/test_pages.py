"""Pages are complete HTML: reading, answering, previewing and checking need no script."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from html import escape, unescape

import pytest
from starlette.testclient import TestClient

from exercises import catalogue, grading
from exercises.presenting import words_of
from exercises.solving import solved
from exercises.variants import deal as dealt_by_hand
from server.answering.workspace import SENTENCE_END
from server.app import create_app
from tests.conftest import Laid
from tests.server.conftest import SECRET

EN = {"accept-language": "en"}
RIGHT = grading.reference(dealt_by_hand("slider_crank", 7))


def form(answers: dict[str, str], **more: str) -> dict[str, str]:
    return {f"answer.{name}": text for name, text in answers.items()} | more


def post(client: TestClient, number: str, answers: dict[str, str], **more: str) -> str:
    """Hand in by form; gives the page that follows."""
    reply = client.post(f"/variants/{number}", data=form(answers, **more), headers=EN, follow_redirects=False)
    assert reply.status_code == 303, reply.text
    target = reply.headers["location"]
    assert target.endswith("#result")
    return client.get(target.partition("#")[0], headers=EN).text


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_the_catalogue_shows_every_exercise_by_name(client: TestClient, language: str) -> None:
    page = unescape(client.get(f"/?lang={language}").text)
    assert f'<html lang="{language}"' in page
    for name in catalogue.ids():
        assert words_of(name, language)["title"] in page and f"/exercises/{name}" in page


def test_the_catalogue_is_searched_and_filtered(client: TestClient) -> None:
    assert "/exercises/slider_crank" in client.get("/?q=vp-2&lang=en").text
    assert "/exercises/slider_crank" not in client.get("/?q=no-such-word&lang=en").text
    assert "No exercise says this" in client.get("/?chapter=accuracy&lang=en").text
    hostile = client.get("/", params={"q": '"><script>alert(1)</script>'}).text
    assert "<script>alert" not in hostile


@pytest.mark.parametrize("exercise", catalogue.ids())
def test_every_exercise_can_be_practised_without_script(client: TestClient, exercise: str) -> None:
    assert client.get(f"/exercises/{exercise}").status_code == 200
    dealt = client.post(f"/exercises/{exercise}", data={"seed": "7"}, follow_redirects=False)
    assert dealt.status_code == 303
    number = dealt.headers["location"].rsplit("/", 1)[1]
    variant = dealt_by_hand(exercise, 7)
    right = grading.reference(variant)
    judged = [name for name, answer in solved(variant).answers.items() if answer.kind != "text"]
    page = post(client, number, right)
    assert f"{len(judged)} of {len(right)} right" in page
    assert page.count('class="verdict v-right"') == len(judged)
    solution = client.get(f"/variants/{number}/solution", headers=EN)
    assert solution.status_code == 200 and "Worked solution" in solution.text


@pytest.fixture(scope="module")
def reader(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[TestClient]:
    """Reads the pages of a server that tests share."""
    settings = laid_for_all(tmp_path_factory.mktemp("pages"), secret=SECRET, limited=False)
    with TestClient(create_app(settings), raise_server_exceptions=False) as found:
        yield found


@pytest.mark.parametrize("exercise", catalogue.ids())
@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_every_field_has_a_label_and_its_messages(reader: TestClient, exercise: str, language: str) -> None:
    location = reader.post(f"/exercises/{exercise}", data={"seed": "7"}, follow_redirects=False).headers["location"]
    reader.post(location, data=form({"l3": "1 m/"}))
    page = reader.get(f"{location}?lang={language}").text
    page = re.sub(r"<label>[^<]+<(?:input|select)[^>]*>", "", page)  # a field inside its label
    ids = re.findall(r' id="([^"]+)"', page)
    assert len(ids) == len(set(ids))
    named = set(re.findall(r'<label[^>]* for="([^"]+)"', page))
    for field in re.findall(r"<(?:input|textarea)[^>]*>", page):
        described = re.search(r'aria-describedby="([^"]*)"', field)
        assert not described or set(described[1].split()) <= set(ids)
        own = re.search(r' id="([^"]+)"', field)
        assert "hidden" in field or "radio" in field or "aria-label" in field or (own and own[1] in named), field


def test_no_page_holds_inline_style_or_script(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    client.post(f"/variants/{number}", data=form({"l3": "1"}))
    for path in ("/", "/exercises/slider_crank", f"/variants/{number}", f"/variants/{number}/solution", "/none"):
        page = client.get(path, headers={"accept": "text/html"}).text
        assert not re.search(
            r"\sstyle=|\son\w+=|<style|javascript:|<script(?! type=\"module\" src=\"/static/)", page
        ), path


def test_each_outcome_is_told_at_its_line(client: TestClient, deal: Callable[..., str]) -> None:
    answers = {"alpha2": RIGHT["alpha2"], "l3": "1 mm", "v3": "1 m/", "omega2_formula": "l1*omega1"}
    page = post(client, deal(), answers)
    assert "1 of 5 right" in page
    for outcome in ("v-right", "v-wrong", "v-unread"):
        assert f'class="verdict {outcome}"' in page
    assert re.search(r'name="answer.v3"[^>]*aria-invalid="true"', page)
    assert not re.search(r'name="answer.omega2"[^>]*aria-invalid', page)
    assert re.search(r'<h2 id="result" tabindex="-1">', page)
    assert 'name="answer.l3" type="text" value="1 mm"' in page


def test_the_data_are_named_beside_their_symbols(client: TestClient, deal: Callable[..., str]) -> None:
    page = client.get(f"/variants/{deal('stepped_shaft', 7)}?lang=en").text
    data = page[page.index("<caption>Data") :].partition("</table>")[0]
    assert '<th scope="row">shear modulus</th><td>' in data
    assert '<th scope="row">length of segment\u00a0<math><mrow><mrow><mn>2</mn></mrow></mrow></math></th>' in data


def test_an_angle_is_asked_for_in_words_and_a_length_in_its_unit(client: TestClient, deal: Callable[..., str]) -> None:
    page = client.get(f"/variants/{deal()}?lang=pl").text
    helps = re.findall(r'<p class="help" id="a\d-h">([^<]*)</p>', page)
    assert helps[:2] == ["w stopniach albo w radianach z jednostką rad, ±0,5 %", "mm, ±0,5 %"]


def test_a_recognised_mistake_shows_its_hint(client: TestClient, deal: Callable[..., str]) -> None:
    page = post(client, deal(), {"omega2_formula": "-l1*omega1*sin(alpha1)/(l2*cos(alpha2))"})
    assert "what does the sine become" in page or 'class="note prose"' in page


def test_a_wrong_answer_is_helped_on_step_by_step(client: TestClient, deal: Callable[..., str]) -> None:
    page = post(client, deal(), {"l3": "1 m", "alpha2": RIGHT["alpha2"], "omega2": "1 rad/s", "omega2_formula": "l1"})
    lines = dict(re.findall(r'(?s)name="answer\.(\w+)"(.*?)</li>', page))
    ladder = {name: line.count('<details class="hint"') for name, line in lines.items()}
    assert ladder == {"alpha2": 0, "l3": 3, "omega2_formula": 0, "omega2": 1, "v3": 0}
    assert "This quantity follows from: <math><msub><mi>l</mi><mn>1</mn></msub></math>, " in lines["l3"]
    arm = post(client, deal("tmm2_oop"), {"y_D": "9 m"})
    assert arm.count("Hint: what it follows from") == 1 and "Next hint: the equation" not in arm


def test_what_a_student_types_is_shown_and_never_run(client: TestClient, deal: Callable[..., str]) -> None:
    attack = '"><script>alert(1)</script>{{ 12345*6789 }}</textarea><img src=x onerror=alert(1)>'
    page = post(client, deal(), {"l3": attack, "omega2_formula": attack})
    assert "<script>alert" not in page and "<img" not in page and str(12345 * 6789) not in page
    assert escape(attack) in page.replace("&#34;", "&quot;")


def test_reading_is_shown_without_judging(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    answers = form({"l3": "12,5", "v3": "1 m/", "omega2_formula": "l1*omega1"})
    page = client.post(f"/variants/{number}/preview", data=answers, headers=EN).text
    assert "read as" in page and "Not read" in page and "verdict" not in page
    assert 'value="12,5"' in page
    assert client.get(f"/variants/{number}", headers=EN).text.count("verdict") == 0


def test_a_page_posted_twice_is_one_submission(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    reply = [
        client.post(f"/variants/{number}", data=form({"l3": text}, key="k"), follow_redirects=False).headers["location"]
        for text in ("1", "1", "2")
    ]
    assert reply[0] == reply[1] != reply[2]


def test_the_workspace_continues_where_it_was_left(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    post(client, number, {"l3": "17 mm"})
    page = client.get(f"/variants/{number}", headers=EN).text
    assert 'value="17 mm"' in page and "data-graded" not in page


def test_a_receipt_of_another_variant_is_not_shown_here(client: TestClient, deal: Callable[..., str]) -> None:
    one, other = deal(), deal()
    target = client.post(f"/variants/{one}", data=form({"l3": "1"}), follow_redirects=False).headers["location"]
    receipt = target.partition("receipt=")[2].partition("#")[0]
    assert client.get(f"/variants/{other}?receipt={receipt}").status_code == 404


@pytest.mark.parametrize("seed", ["-1", "x", "9007199254740992", "1" * 30, "٣"])
def test_a_seed_that_is_none_is_refused_on_a_page(client: TestClient, seed: str) -> None:
    reply = client.post("/exercises/slider_crank", data={"seed": seed}, headers={"accept": "text/html"} | EN)
    assert reply.status_code == 422 and "out of range" in reply.text


@pytest.mark.parametrize("content", [b"\xff", b"&".join(b"a=1" for _ in range(3000))])
def test_what_is_no_form_is_refused(client: TestClient, deal: Callable[..., str], content: bytes) -> None:
    headers = {"content-type": "application/x-www-form-urlencoded"}
    assert client.post(f"/variants/{deal()}", content=content, headers=headers).status_code == 422
    assert client.post(f"/variants/{deal()}", json={"answer.l3": "1"}).status_code == 422


def test_language_and_appearance_are_kept(client: TestClient) -> None:
    chosen = client.get("/?lang=ru&theme=dark")
    assert 'data-theme="dark"' in chosen.text
    kept = client.get("/", headers=EN).text
    assert '<html lang="ru" data-theme="dark"' in kept
    client.get("/?theme=system")
    assert "data-theme" not in client.get("/").text
    assert '<html lang="ru"' in client.get("/?lang=xx").text


def test_the_language_switch_stays_on_the_page(client: TestClient, deal: Callable[..., str]) -> None:
    assert "/?q=vp-2&amp;lang=ru" in client.get("/?q=vp-2").text
    number = deal()
    preview = client.post(f"/variants/{number}/preview", data=form({"l3": "1"})).text
    assert f'href="/variants/{number}?lang=ru"' in preview


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_an_answer_named_by_a_word_shows_no_symbol(client: TestClient, deal: Callable[..., str], language: str) -> None:
    page = client.get(f"/variants/{deal('four_bar')}?lang={language}").text
    assert "<mi>assemblies</mi>" not in page and "<mi>ω</mi><mn>2</mn></msub><mo>=</mo>" in page


@pytest.mark.parametrize(
    ("text", "said"), [("1 m/", "Not judged yet: mend what could not be read"), ("1 m", "0 of 5 right")]
)
def test_nothing_is_called_wrong_that_was_not_judged(
    client: TestClient, deal: Callable[..., str], text: str, said: str
) -> None:
    page = post(client, deal(), {"v3": text})
    heading = re.search(r'<h2 id="result"[^>]*>(.*?)</h2>', page)
    assert heading is not None and heading[1] == said
    assert ("not checked yet" in page) == said.startswith("Not judged")


@pytest.mark.parametrize(
    ("message", "first"),
    [
        ("Not read: an end at character 5. No attempt was counted.", "Not read: an end at character 5."),
        ("Nie odczytano od 8. znaku. Próby nie liczymy.", "Nie odczytano od 8. znaku."),
        ("Не прочитано с 8. Попытка не засчитана.", "Не прочитано с 8."),
    ],
)  # fmt: skip
def test_the_first_sentence_of_a_verdict_is_its_headline(message: str, first: str) -> None:
    assert SENTENCE_END.split(message, maxsplit=1)[0] == first
