"""A13: nothing that a student can reach before the reveal holds a reference value: API, pages, errors, documents."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from math import isclose
from typing import Any

import pytest
from starlette.testclient import TestClient

from exercises import catalogue, grading
from exercises.exercise import Variant
from exercises.solving import Solved
from exercises.variants import deal, dump
from graders import Quantity
from graders.units import read_unit
from graders.words import LANGUAGES
from server.app import create_app
from tests.conftest import Laid
from tests.depth import amount

NUMBER = re.compile(r"(?<![\w.#-])[-−]?\d+(?:[.,]\d+)?(?:e[-+]?\d+)?(?![\w.])")
SEEDS = (3, 7, 11)
SMALL = 40  # whole numbers below this stand on any page (tab index, step, row, a coordinate of a figure)


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[TestClient]:
    """A client that the tests here share: none sees what another has handed in."""
    settings = laid_for_all(tmp_path_factory.mktemp("a13"), secret=b"a13", limited=False)
    with TestClient(create_app(settings), raise_server_exceptions=False) as found:
        yield found


def numbers(text: str) -> Iterator[float]:
    for found in NUMBER.finditer(text):
        yield abs(float(found[0].replace(",", ".").replace("−", "-")))


def secrets_of(exercise: str, seed: int) -> tuple[list[float], list[str]]:
    """What the variant of a seed hides."""
    return secrets_in(deal(exercise, seed))


def secrets_in(variant: Variant) -> tuple[list[float], list[str]]:
    """The reference values in SI and in the unit of the field, and the reference texts of the formulas."""
    solved = Solved(catalogue.load(variant.exercise).exercise, variant)
    asked = [
        (abs(float(solved.values[solved.step_of(name)])), read_unit(grader.unit).factor)  # type: ignore[arg-type]
        for name, grader in solved.answers.items()
        if isinstance(grader, Quantity)
    ]
    formulas = [text for text in grading.reference(variant).values() if re.search(r"[a-z]\w*\(|\*", text)]
    public = list(printed(dump(variant)["givens"]))
    public += [abs(one - other) for one in public for other in public]

    def secret(value: float) -> bool:
        return value > 1e-6 and not any(isclose(value, known) for known in public)

    hidden = [value / unit for value, factor in asked if secret(value) for unit in (1.0, factor)]
    return list(filter(secret, hidden)), formulas


def printed(givens: Any) -> Iterator[float]:
    """The numbers of the givens: an extreme that stands under a given force has a place that everybody may know."""
    if isinstance(givens, Mapping):
        givens = list(givens.values())
    for value in givens if isinstance(givens, list) else [givens]:
        if isinstance(value, Mapping | list):
            yield from printed(value)
        elif isinstance(value, int | float):
            yield abs(float(value))


def reachable(client: TestClient, exercise: str, seed: int, language: str) -> Iterator[str]:
    wish = {"accept-language": language}
    dealt = client.post(f"/api/v1/exercises/{exercise}/variants", json={"seed": seed}, headers=wish)
    body = dealt.json()
    own = {
        key: value
        for key, value in body.items()
        if key not in ("id", "seed", "givens", "statement", "statement_text", "data")
    }
    yield str(own)
    number = body["id"]
    page = client.get(f"/variants/{number}", headers=wish).text
    yield re.sub(
        r'(?s)<div class="statement">.*?</div>|<tbody>.*?</tbody>|<dl class="block">.*?</dl>|value="\w{16}"', "", page
    )
    graded = client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {}}, headers=wish).json()
    yield str({key: value for key, value in graded.items() if key not in ("receipt", "variant")})
    for path in (f"/api/v1/variants/{number}/solution", f"/variants/{number}/solution"):
        refused = client.get(path, headers=wish)
        assert refused.status_code == 403
        yield refused.json()["error"]["message"]
    if catalogue.load(exercise).exercise.report:
        report = client.get(f"/api/v1/reports/tmm2/{number}.md", headers=wish)
        yield "\n".join(line for line in report.text.splitlines() if not line.startswith(("|", "- ")))


HIDING = [exercise for exercise in catalogue.ids() if exercise != "mobility"]  # counts stand on any page


TRIED = [(exercise, seed) for at, exercise in enumerate(HIDING) for seed in amount((SEEDS[at % 3],), SEEDS)]


@pytest.mark.parametrize(("exercise", "seed"), TRIED)
def test_no_reference_value_stands_in_what_a_student_reaches(client: TestClient, exercise: str, seed: int) -> None:
    values, formulas = secrets_of(exercise, seed)
    assert values or formulas
    for text in reachable(client, exercise, seed, LANGUAGES[seed % 3]):
        for formula in formulas:
            assert formula not in text
        for number in numbers(text):
            near = [value for value in values if abs(number - value) <= 1e-3 * value]
            assert not near or (number.is_integer() and number < SMALL), (number, near)


def test_the_search_would_find_a_leak(client: TestClient) -> None:
    values, _ = secrets_of("slider_crank", 7)
    assert any(abs(number - values[0]) <= 1e-3 * values[0] for number in numbers(f'<text x="{values[0]:.5f}">'))


def test_the_description_of_the_interface_holds_no_answer(client: TestClient) -> None:
    described = client.get("/api/v1/openapi.json").text
    for exercise in catalogue.ids():
        for seed in SEEDS:
            for formula in secrets_of(exercise, seed)[1]:
                assert formula not in described
