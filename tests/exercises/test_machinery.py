"""The machinery of the exercise room: chance, givens, solving, follow-through, counting, words."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from exercises import catalogue, variants
from exercises.draw import Draw, Rejected
from exercises.exercise import Exercise, Submission
from exercises.exercise import given as domain_of
from exercises.givens import domains, dump, each, numbers, option, restore, words_of
from exercises.grading import UnknownAnswer, failed, grade
from exercises.solving import solve
from exercises.verifying import agree, verify
from exercises.words import COMMAND, MATHS, SPOKEN, fill, html, indexed, inline, plain, read_words
from graders import Code, Outcome
from graders.language.doubles import UndefinedError

SLIDER = "slider_crank"


def test_the_generator_is_frozen() -> None:
    """SHA-256 of the words and a counter, eight bytes a word: computed here once more by hand."""
    from hashlib import sha256

    block = sha256(b"a\x1f7\x1e" + bytes(8)).digest()
    expected = [int.from_bytes(block[i : i + 8], "big") % 1000 for i in range(0, 32, 8)]
    rng = Draw("a", 7)
    assert [rng.below(1000) for _ in range(4)] == expected


@given(st.integers(1, 50), st.integers(0, 2**53 - 1))
def test_a_number_below_a_bound_is_below_it(count: int, seed: int) -> None:
    assert 0 <= Draw(seed).below(count) < count


def test_all_options_are_equally_likely() -> None:
    rng = Draw("fair")
    counts = Counter(rng.pick("abcde") for _ in range(5000))
    assert sum((n - 1000) ** 2 / 1000 for n in counts.values()) < 18.5  # chi-square, 4 degrees, 0.1 %


def test_a_sub_stream_is_not_shifted_by_draws_of_another() -> None:
    one, other = Draw("x", 1), Draw("x", 1)
    one.below(10)
    assert [one.stream("loads").below(99) for _ in range(3)] == [other.stream("loads").below(99) for _ in range(3)]


def test_a_sample_has_no_repetition_and_uniform_stays_inside() -> None:
    rng = Draw("s")
    assert sorted(rng.sample(range(6), 6)) == list(range(6))
    assert all(2 <= rng.uniform(2, 3) < 3 for _ in range(100))
    with pytest.raises(Rejected):
        rng.reject()


@dataclass(frozen=True, slots=True)
class Pull:
    F: float = domain_of(1, 9)
    moment = "F{i}*({x} - 1)"


@dataclass(frozen=True, slots=True)
class Spread:
    q: float = domain_of(1, 9)
    moment = "q{i}*{x}^2/2"


@dataclass(frozen=True, slots=True)
class Bar:
    L: float = domain_of(1, 5)
    lambda_: float = domain_of(1, 2)
    kind: str = option("round", "square")
    loads: tuple[Pull | Spread, ...] = ()


BAR = Bar(2.0, 1.5, "round", (Pull(3.0), Spread(4.0), Pull(5.0)))


def test_members_of_a_list_get_names_counted_over_all_kinds() -> None:
    assert numbers(BAR) == {"L": 2.0, "lambda": 1.5, "F1": 3.0, "q2": 4.0, "F3": 5.0}
    assert words_of(BAR) == {"kind": "round"}
    assert set(domains(BAR)) == set(numbers(BAR))
    assert each(BAR, lambda p: p.moment, "c") == ["F1*(c - 1)", "q2*c^2/2", "F3*(c - 1)"]
    assert each(BAR.loads, lambda p: p.moment)[1] == "q2*x^2/2"


def test_givens_are_stored_and_restored_with_their_kinds() -> None:
    assert restore(Bar, dump(BAR)) == BAR
    with pytest.raises(ValueError, match="do not fit"):
        restore(Bar, {"L": 1})


def test_a_given_without_a_domain_is_refused() -> None:
    @dataclass(frozen=True)
    class Loose:
        a: float

    with pytest.raises(TypeError, match="declares no domain"):
        domains(Loose(1.0))


def submit(**changed: str) -> Submission:
    variant = variants.deal(SLIDER, 1)
    values = solve(catalogue.load(SLIDER).exercise, variant.givens)
    shown = {name: f"{values[name]}" for name in ("l3", "omega2", "v3")}
    answers = {"alpha2": f"{values['alpha2']} rad", **shown, "l3": f"{values['l3']} m"}
    answers["omega2_formula"] = "-l1*ω1*cos(α1)/(l2*cos(α2))"
    return Submission(variant, {**answers, **changed})


def test_later_answers_follow_from_the_students_own_formula() -> None:
    exercise, variant = catalogue.load(SLIDER).exercise, variants.deal(SLIDER, 1)
    wrong = "l1*omega1*cos(alpha1)/l2"  # not among the known mistakes
    values = solve(exercise, variant.givens, replaced={"omega2": wrong})
    found = grade(submit(omega2_formula=wrong, omega2=str(values["omega2"]), v3=str(values["v3"])))
    codes = {name: verdict.code for name, verdict in found.verdicts.items()}
    assert codes["omega2_formula"] is Code.WRONG
    assert (codes["omega2"], codes["v3"]) == (Code.FOLLOWED, Code.FOLLOWED)
    assert found.score == pytest.approx(0.8)


def test_later_answers_follow_from_the_students_own_number() -> None:
    exercise, variant = catalogue.load(SLIDER).exercise, variants.deal(SLIDER, 1)
    values = solve(exercise, variant.givens, fixed={"omega2": 3.0})
    found = grade(submit(omega2="3 rad/s", v3=str(values["v3"])))
    assert found.verdicts["omega2"].outcome is Outcome.WRONG
    assert found.verdicts["v3"].code is Code.FOLLOWED


@pytest.mark.parametrize("trivial", ["0", "1e30", "1e-30"])
def test_nothing_follows_from_a_trivial_or_implausible_value(trivial: str) -> None:
    exercise, variant = catalogue.load(SLIDER).exercise, variants.deal(SLIDER, 1)
    values = solve(exercise, variant.givens, fixed={"omega2": float(trivial)})
    found = grade(submit(omega2=trivial, v3=str(values["v3"])))
    assert found.verdicts["v3"].outcome is not Outcome.RIGHT


def test_nothing_follows_from_an_unreadable_answer() -> None:
    found = grade(submit(omega2="3 qq", v3="1.0"))
    assert found.verdicts["omega2"].outcome is Outcome.UNREADABLE
    assert found.verdicts["v3"].outcome is Outcome.WRONG


def test_where_attempts_are_limited_an_unreadable_answer_stops_the_judging() -> None:
    found = grade(submit(v3="1 +"), limited=True)
    assert (list(found.verdicts), found.counted, found.score) == (["v3"], False, 0)
    assert grade(submit(v3=""), limited=True).counted


def test_an_answer_that_is_not_asked_for_is_named() -> None:
    with pytest.raises(UnknownAnswer, match="v9"):
        grade(Submission(variants.deal(SLIDER, 1), {"v9": "1"}))


def test_a_failure_of_ours_is_not_counted_and_kept_for_the_lecturer() -> None:
    found = failed(submit())
    assert {verdict.outcome for verdict in found.verdicts.values()} == {Outcome.FAULT}
    assert (found.counted, found.provisional, found.score) == (False, True, 0)


def test_the_verdict_on_a_formula_does_not_depend_on_the_secret() -> None:
    submission = submit(omega2_formula="-l1*ω1*cos(α1)/sqrt(l2^2 - l1^2*sin(α1)^2)")
    assert {grade(submission, secret).score for secret in (b"a", b"b", b"c")} == {1}


@pytest.mark.parametrize("seed", [-1, 2**53, True, 1.5, "1"])
def test_a_seed_out_of_range_is_refused(seed: int) -> None:
    with pytest.raises(ValueError, match="seed"):
        variants.deal(SLIDER, seed)


def test_an_unknown_exercise_is_refused_by_name() -> None:
    with pytest.raises(catalogue.UnknownExercise, match="no_such"):
        variants.deal("no_such", 1)


def test_an_incomplete_folder_is_refused_loudly(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "strength" / "half").mkdir(parents=True)
    monkeypatch.setattr(catalogue, "ROOT", tmp_path)
    catalogue._shelf.cache_clear()
    try:
        with pytest.raises(catalogue.IncompleteExercise, match=r"strength/half lacks __init__.py, pl.toml"):
            catalogue.ids()
    finally:
        catalogue._shelf.cache_clear()


def test_every_folder_is_checked_when_the_server_starts() -> None:
    catalogue.check()
    assert all(catalogue.chapter_of(name) in catalogue.CHAPTERS for name in catalogue.ids())


def broken(**changes: object) -> list[str]:
    """Gate a slider-crank with something broken."""
    entry = catalogue.load(SLIDER)
    worse: Exercise[object] = replace(entry.exercise, **changes)  # type: ignore[arg-type]
    catalogue.load.cache_clear()
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(catalogue, "load", lambda _id: replace(entry, exercise=worse))
        return list(verify(SLIDER, range(3)).failures)


def test_the_gate_sees_steps_that_disagree_with_the_oracle() -> None:
    good = catalogue.load(SLIDER).exercise.oracle
    failures = broken(oracle=lambda givens: {**good(givens), "l3": 1.0})
    assert any("step l3" in failure and "oracle 1.0" in failure for failure in failures)


def test_the_gate_sees_a_forgotten_version() -> None:
    assert any("stores the digest of version" in failure for failure in broken(version=2))


def test_the_gate_sees_a_changed_step() -> None:
    good = catalogue.load(SLIDER).exercise
    steps = {**good.steps_of(variants.deal(SLIDER, 1).givens), "l3": "l1*cos(alpha1) + 1.000001*l2*cos(alpha2)"}
    assert any("raise `version`" in failure for failure in broken(steps=steps))


def test_values_agree_by_shape_and_size() -> None:
    assert agree(1.0, 1.0 + 1e-12) and not agree(1.0, 1.001)
    assert agree(((1.0, 1e-12),), ((1.0, 0.0),)) and not agree(((1.0,),), 1.0)
    assert agree("a", "a") and not agree("a", 1.0)


def test_a_step_without_a_finite_value_is_undefined() -> None:
    exercise, variant = catalogue.load(SLIDER).exercise, variants.deal(SLIDER, 1)
    with pytest.raises(UndefinedError):
        solve(exercise, variant.givens, replaced={"alpha2": "asin(2)"})


def test_statements_are_filled_with_units_and_the_mark_of_the_language() -> None:
    words = {"options": {"round": "okrągły"}}
    text = '{{ L | unit("mm") }} {{ kind }} {{ lambda }}'
    assert fill(text, BAR, words, "pl") == "2000\u202fmm okrągły 1,5"
    assert fill('{{ lambda | unit("m") }}', BAR, words, "en") == "1.5\u202fm"
    with pytest.raises(KeyError, match="no given"):
        fill("{{ nothing }}", BAR, words, "en")


def test_drawn_lists_are_worded_by_class_with_their_index() -> None:
    words = {"loads": {"Pull": """force $F_{i} =$ {{ F | unit("N") }}""", "Spread": """load {{ q | unit("N/m") }}"""}}
    shown = html(fill("Given:\n\n{{ loads }}\n", BAR, words, "en"))
    assert shown.count("<li>") == 3 and "<mn>3</mn>" in shown
    assert "\u202fN" in shown and "\u202fN/m" in shown  # a number stays with its unit


def test_words_become_html_and_plain_text() -> None:
    assert inline("a < b & $x$, y").startswith("a &lt; b &amp; <span")
    assert 'rspace="0"' in inline("$l_1 =$ 45") and "rspace" not in inline("$a = b$")
    assert plain(r"Kąt $\alpha_2$ i $l_1$") == "Kąt α2 i l1"
    assert indexed({"T{i}": "moment $T_{i}$"}, "T2") == "moment $T_{2}$"
    with pytest.raises(KeyError):
        indexed({}, "T2")


@pytest.mark.parametrize(
    ("latex", "spoken"),
    [
        (r"$\varepsilon_1 =$ 5", "ε1 = 5"),
        (r"$u_0 = \dfrac{\omega_1 - \omega_H}{\omega_n - \omega_H}$", "u0 = (ω1 - ωH)/(ωn - ωH)"),
        (r"$l_1\sin\alpha_1 + l_2 \cos(\alpha_2) = 0$", "l1 sin α1 + l2 cos(α2) = 0"),
        (r"$\pm 90^\circ$", "± 90°"),
        (r"$\dot{\varphi}_1$", "φ\u03071"),
        (r"$M_{\mathrm{out}}$ · $\frac{a}{2}$", "Mout · a/2"),
        (r"$\langle x - a \rangle^1$", "⟨ x - a ⟩^1"),
    ],
)
def test_plain_text_says_all_that_the_formula_says(latex: str, spoken: str) -> None:
    assert plain(latex) == spoken


def test_a_dot_stands_close_above_its_letter() -> None:
    assert r'<mover accent="true"><mi>&#x00398;</mi>' in inline(r"$\dot\Theta_1$")


def test_every_command_in_the_words_has_a_plain_form() -> None:
    folder = Path(catalogue.__file__).parent
    maths = [piece for path in folder.glob("*/*/??.toml") for piece in MATHS.findall(path.read_text("utf-8"))]
    built = {"mathrm", "text", "operatorname", "frac", "dfrac", "tfrac", "dot", "ddot"}
    assert len(maths) > 500
    assert not {name for piece in maths for name in COMMAND.findall(piece)} - built - set(SPOKEN)


def test_a_word_file_without_a_section_is_refused(tmp_path: Path) -> None:
    (tmp_path / "pl.toml").write_text("title = 'x'", "utf-8")
    with pytest.raises(ValueError, match="lacks summary"):
        read_words(tmp_path / "pl.toml")
