"""Laws of the drawn gear trains, and what a student reads of them."""

from __future__ import annotations

import pytest

from exercises import presenting, variants
from exercises.exercise import Submission, Variant
from exercises.givens import each
from exercises.grading import grade, reference
from exercises.solving import Solved
from exercises.transmissions.gear_train import EXERCISE, SHAPES, Givens
from exercises.transmissions.gear_train.wheels import Coaxial, Coupled, Input, Mesh, Wheel, kinds
from graders import Outcome
from graders.words import LANGUAGES
from mechanics import willis


def dealt(*wheels: Wheel) -> Variant:
    return Variant("gear_train", EXERCISE.version, 0, Givens(wheels, 150.0, 10.0, 0.95))


def solved(*wheels: Wheel) -> Solved:
    return Solved(EXERCISE, dealt(*wheels))


def test_the_seeds_reach_every_shape() -> None:
    seen = set()
    for seed in range(250):
        wheels = variants.deal("gear_train", seed).givens.wheels
        seen.add("".join("+" if isinstance(w, Coupled) else type(w).__name__[0] + w.type[0] for w in wheels[1:]))
    assert len(seen) == len(set(SHAPES))


@pytest.mark.parametrize("kind", ["external", "internal"])
def test_a_coaxial_train_comes_back_to_its_first_axis(kind: str) -> None:
    last = Coaxial("external" if kind == "external" else "internal")
    z4 = solved(Input(23), Mesh(51, "external"), Coupled(19), last).values["z4"]
    assert willis.coaxial(willis.Stage(23, 51), willis.Stage(19, int(float(str(z4))), last.type))


def test_an_idler_changes_the_sense_and_nothing_else() -> None:
    pair = solved(Input(20), Mesh(50, "external")).values
    idle = solved(Input(20), Mesh(33, "external"), Mesh(50, "external")).values
    assert (pair["u"], pair["sense"], idle["sense"]) == (-2.5, "opposite", "same")
    assert idle["u"] == pytest.approx(2.5)


def test_the_trap_of_a_ratio_of_four_is_wrong() -> None:
    variant = dealt(Input(20), Mesh(40, "external"), Coupled(15), Coaxial("external"))
    verdicts = grade(Submission(variant, {"z4": "40", "u": "4"})).verdicts
    assert {verdicts["z4"].outcome, verdicts["u"].outcome} == {Outcome.WRONG}
    assert reference(variant)["z4"] == "45"


def test_the_formula_may_hold_the_sought_teeth_or_what_they_are_made_of() -> None:
    variant = dealt(Input(20), Mesh(40, "external"), Coupled(15), Coaxial("internal"))
    for text in ("-z2*z4/(z1*z3)", "u = -(z2/z1)*(z1 + z2 + z3)/z3"):
        assert grade(Submission(variant, {"u_formula": text})).verdicts["u_formula"].outcome is Outcome.RIGHT


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_statement_says_which_wheel_meshes_with_which(lang: str) -> None:
    variant = dealt(Input(20), Mesh(40, "external"), Coupled(15), Mesh(90, "internal"))
    lines = [line for line in presenting.presented(variant, lang).statement_text.split("\n") if line.startswith("- ")]
    numbers = [[int(w) for w in line.replace(",", " ").replace("=", " ").split() if w.isdigit()] for line in lines]
    assert numbers == [[1, 20], [2, 40, 1], [3, 15, 2], [4, 90, 3]]


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_solution_words_the_sense_of_rotation(lang: str) -> None:
    variant = dealt(Input(20), Mesh(50, "external"))
    shown = {line.value for line in presenting.solution(variant, lang)}
    assert presenting.words_of("gear_train", lang)["choices"]["sense"]["opposite"] in shown


def test_a_ratio_has_no_unit_at_its_field() -> None:
    assert presenting.presented(variants.deal("gear_train", 1), "en").answers["u"].unit_text == ""


@pytest.mark.parametrize("seed", range(6))
def test_the_figure_has_a_row_for_each_wheel_and_hides_the_sought_teeth(seed: int) -> None:
    variant = variants.deal("gear_train", seed)
    picture = presenting.presented(variant, "en").picture
    assert picture is not None and len(picture.table.rows) == len(variant.givens.wheels)
    wanted = [row[1] == "sought" for row in picture.table.rows]
    assert wanted == [isinstance(wheel, Coaxial) for wheel in variant.givens.wheels]


def test_a_line_of_a_member_may_name_the_member_before() -> None:
    assert each((Input(20), Coupled(30)), lambda _: "z{i}/z{i-1}") == ["z1/z0", "z2/z1"]


def test_the_kinds_of_the_meshes_are_listed_in_order() -> None:
    assert kinds((Input(20), Mesh(30, "external"), Coupled(15), Coaxial("internal"))) == ["external", "internal"]


@pytest.mark.parametrize("lang", LANGUAGES)
def test_the_sense_may_be_typed_in_the_words_of_its_options(lang: str) -> None:
    variant, words = dealt(Input(20), Mesh(50, "external")), presenting.words_of("gear_train", lang)["choices"]["sense"]
    for text in (words["opposite"], f" {words['opposite'].upper()}. "):
        assert grade(Submission(variant, {"sense": text})).verdicts["sense"].outcome is Outcome.RIGHT
    assert grade(Submission(variant, {"sense": words["same"]})).verdicts["sense"].outcome is Outcome.WRONG
    assert grade(Submission(variant, {"sense": words["same"] + "?"})).verdicts["sense"].outcome is Outcome.UNREADABLE
