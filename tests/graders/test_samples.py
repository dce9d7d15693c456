"""Tables of a cycle: read from any spreadsheet, judged column by column, slips told apart."""

from __future__ import annotations

import json
from collections.abc import Callable
from contextlib import suppress
from functools import partial
from math import asin, cos, degrees, pi, radians, sin

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from exercises.exercise import Submission
from exercises.grading import grade
from exercises.variants import deal
from graders import AnswerSyntaxError, Code, Series, Symbols
from graders.cycle.curve import Rows, cycle_of
from graders.cycle.table import LARGEST, MOST_ROWS, Column
from graders.language import Reason
from graders.remarks import Remarks, Slip
from graders.verdict import Verdict
from graders.words import LANGUAGES, message, tolerance
from tests.depth import amount
from tests.graders.effort import effort

NOTHING = Symbols(())
COLUMNS = (
    Column("t", "s"), Column("alpha", "deg"), Column("x", "mm"), Column("v", "m/s", "x"), Column("a", "m/s^2", "v"),
)  # fmt: skip
JUDGE = Series(COLUMNS, abscissae=2)
CRANK, ROD, SPEED, START = 0.08, 0.30, 30.0, radians(30)
State = tuple[float, float, float]


def motion(alpha: float) -> State:
    """A slider-crank in millimetres, m/s and m/s^2 (domain VP-2)."""
    rod = -asin(CRANK * sin(alpha) / ROD)
    turn = -CRANK * SPEED * cos(alpha) / (ROD * cos(rod))
    spin = (CRANK * SPEED**2 * sin(alpha) + ROD * turn**2 * sin(rod)) / (ROD * cos(rod))
    return (
        1e3 * (CRANK * cos(alpha) + ROD * cos(rod)),
        -CRANK * SPEED * sin(alpha) - ROD * turn * sin(rod),
        -CRANK * SPEED**2 * cos(alpha) - ROD * (turn**2 * cos(rod) + spin * sin(rod)),
    )


def reference(rows: int = 36) -> Rows:
    found = []
    for k in range(rows + 1):
        alpha = START + 2 * pi * k / rows
        x, v, a = motion(alpha)
        found.append((2 * pi / SPEED * k / rows, alpha, x / 1e3, v, a))
    return tuple(found)


REFERENCE = reference()


def table(
    state: Callable[[float], tuple[float, ...]] = motion,
    head: str = "t;x;v;a",
    rows: int = 60,
    mark: str = ";",
    abscissa: Callable[[float], float] = lambda turn: 2 * pi / SPEED * turn,
    figures: int = 6,
) -> str:
    """Write a table in steps of a turn; the decimal mark is a comma unless commas part the columns."""
    lines = [head] if head else []
    for k in range(rows + 1):
        cells = (abscissa(k / rows), *state(START + 2 * pi * k / rows))
        line = mark.join(f"{cell:.{figures}g}" for cell in cells)
        lines.append(line if mark == "," else line.replace(".", ","))
    return "\n".join(lines)


def judged(text: str, judge: Series = JUDGE, rows: Rows = REFERENCE) -> Verdict:
    return judge.check(judge.parse(text, NOTHING), rows)


def read(text: str) -> None:
    with suppress(AnswerSyntaxError):
        judged(text)


def slips(text: str) -> list[tuple[Slip, str]]:
    details = judged(text).details
    assert isinstance(details, Remarks)
    return [(remark.slip, remark.name) for remark in details.found]


def test_a_table_passes_its_own_samples() -> None:
    samples = JUDGE.samples(REFERENCE)
    assert {judged(text).code for text in (*samples.right, JUDGE.show(REFERENCE))} == {Code.RIGHT}
    assert all(judged(text).code is not Code.RIGHT for text in samples.wrong)
    for text in samples.unreadable:
        with pytest.raises(AnswerSyntaxError):
            JUDGE.parse(text, NOTHING)


def by_columns() -> dict[str, list[float]]:
    columns = list(zip(*REFERENCE, strict=True))
    return {name: list(columns[at]) for name, at in (("t", 0), ("x [m]", 2), ("v", 3), ("a", 4))}


def angle(turn: float) -> float:
    return START + 2 * pi * turn


@pytest.mark.parametrize(
    "text",
    [
        table(),
        table(head=""),
        table(mark="\t", head="t\tx\tv\ta"),
        table(mark=",", head="t,x,v,a"),
        table(mark=",", head=""),
        table(mark=" ", head=""),
        table(mark=" | ", head="t | x | v | a"),
        table(mark=";", head="t; x; v; a").replace("\n", ";\r\n"),
        "\ufeff" + table().replace("-", "−"),
        table(head="czas [s];położenie [mm];prędkość (m/s);przyspieszenie / m/s²"),
        table(head="время;положение;скорость;ускорение"),
        table(head="Time;Position;Velocity;Acceleration"),
        table(head="t, s;x, mm;v, m/s;a, m/s\u00b2"),
        table(head="t, \u0441;x, \u043c\u043c;v, \u043c/\u0441;a, \u043c/\u0441\u00b2"),
        table(head="t(s);x(t);v(t);a(t)"),
        table(lambda alpha: (motion(alpha)[0] / 1e3, *motion(alpha)[1:]), head="t;x [m];v;a"),
        table(lambda alpha: tuple(reversed(motion(alpha))), head="t [s];a;v;x"),
        table(lambda alpha: (1, *motion(alpha), 7), head="t;lp.;x;v;a;i"),
        table(abscissa=lambda turn: 1e3 * 2 * pi / SPEED * turn, head="t [ms];x;v;a"),
        table(abscissa=lambda turn: degrees(angle(turn)), head="alpha;x;v;a"),
        table(abscissa=lambda turn: degrees(angle(turn)) % 360, head="kąt [°];x;v;a"),
        table(abscissa=angle, head="φ;x;v;a"),
        table(abscissa=angle, head="α [rad];x;v;a"),
        table(lambda alpha: (degrees(alpha), *motion(alpha)), head="t;alpha;x;v;a"),
        table(lambda alpha: (degrees(alpha), *motion(alpha)), head=""),
        table(rows=3000),
        json.dumps(by_columns()),
        json.dumps([{"t": t, "x [m]": x, "v": v, "a": a} for t, _, x, v, a in REFERENCE]),
    ],
)
def test_a_table_is_read_however_it_comes(text: str) -> None:
    assert judged(text).code is Code.RIGHT


def spoiled(number: int, change: Callable[[float], float]) -> Callable[[float], tuple[float, ...]]:
    def state(alpha: float) -> tuple[float, ...]:
        return tuple(change(value) if at == number else value for at, value in enumerate(motion(alpha)))

    return state


def backwards(alpha: float) -> State:
    x, v, a = motion(2 * START - alpha)
    return x, -v, a


def quotients(alpha: float) -> State:
    step = 2 * pi / 60
    (x, _, a), (after, *_) = motion(alpha), motion(alpha + step)
    return x, (after - x) / 1e3 / (step / SPEED), a


def bent(alpha: float) -> State:
    x, v, a = motion(alpha)
    return x**1.1, abs(v), a


@pytest.mark.parametrize(
    ("state", "found"),
    [
        (spoiled(1, lambda v: -v), [(Slip.COLUMN_SIGN, "v")]),
        (spoiled(0, lambda x: x / 1e3), [(Slip.COLUMN_UNIT, "x")]),
        (spoiled(1, lambda v: v * 1e3), [(Slip.COLUMN_UNIT, "v")]),
        (spoiled(2, lambda a: a / 9.81), [(Slip.COLUMN_SCALE, "a")]),
        (spoiled(0, lambda x: x - 220), [(Slip.COLUMN_SHIFT, "x")]),
        (spoiled(1, lambda v: v / SPEED), [(Slip.PER_ANGLE, "v")]),
        (spoiled(2, lambda a: a / SPEED**2), [(Slip.PER_ANGLE, "a")]),
        (spoiled(1, lambda v: abs(v)), [(Slip.NOT_THE_RATE, "v")]),
        (lambda alpha: (*motion(alpha)[:2], -CRANK * SPEED**2 * cos(alpha)), [(Slip.NOT_THE_RATE, "a")]),
        (bent, [(Slip.COLUMN, "x"), (Slip.COLUMN, "v")]),
        (quotients, [(Slip.QUOTIENTS, "v")]),
        (lambda alpha: motion(alpha - START), [(Slip.DELAYED, "")]),
        (lambda alpha: motion(alpha + pi), [(Slip.DELAYED, "")]),
        (backwards, [(Slip.REVERSED, "")]),
        (lambda alpha: motion(degrees(alpha)), [(Slip.DEGREES, "")]),
        (lambda _: (0.0, 0.0, 0.0), [(Slip.COLUMN_SHIFT, "x"), (Slip.COLUMN_SHIFT, "v"), (Slip.COLUMN_SHIFT, "a")]),
    ],
)  # fmt: skip
def test_slips_are_told_apart(state: Callable[[float], tuple[float, ...]], found: list[tuple[Slip, str]]) -> None:
    text = table(state)
    if state(0.3) == (0.0, 0.0, 0.0):
        assert judged(text).score == 0
    else:
        assert slips(text) == found
    assert all("{" not in message(judged(text), lang) for lang in LANGUAGES)


def test_each_column_earns_its_share() -> None:
    assert judged(table(spoiled(1, lambda v: -v))).score == pytest.approx(2 / 3, abs=1e-5)
    verdict = judged(table(lambda alpha: motion(alpha)[:2], head="t;x;v"))
    assert verdict.score == pytest.approx(2 / 3, abs=1e-5) and verdict.code is Code.SOME_MARKS
    assert slips(table(lambda alpha: motion(alpha)[:2], head="t;x;v")) == [(Slip.NO_COLUMN, "a")]


def test_a_shift_is_measured_in_the_angle() -> None:
    details = judged(table(lambda alpha: motion(alpha - START))).details
    assert isinstance(details, Remarks)
    assert details.found[0].place == pytest.approx(-30, abs=0.2) and details.found[0].unit == "deg"
    timed = Series((COLUMNS[0], *COLUMNS[2:]))
    rows = tuple((t, *rest) for t, _, *rest in REFERENCE)
    late = judged(table(lambda alpha: motion(alpha - START)), timed, rows).details
    assert isinstance(late, Remarks) and late.found[0].place == pytest.approx(-START / SPEED, abs=1e-4)
    assert late.found[0].unit == "s"


def test_a_cycle_needs_enough_rows_and_no_gap() -> None:
    assert slips(table(rows=20)) == [(Slip.FEW_ROWS, "")]
    half = "\n".join(table().split("\n")[:34])
    details = judged(half).details
    assert isinstance(details, Remarks) and details.found[0].slip is Slip.NOT_A_CYCLE
    assert details.found[0].place == pytest.approx(30 + 32 * 6, abs=1)
    assert judged("t;x;v;a\n" + "1;1;1;1\n" * 40).score == 0


def times(figures: int, rows: int = 36, of: float = 1.0) -> str:
    """Write a table whose times are rounded to some figures, or whose rows are late by a part of a step."""
    return table(abscissa=lambda turn: float(f"{2 * pi / SPEED * turn * of:.{figures}g}"), rows=rows)


def test_times_of_equal_steps_may_be_rounded_to_three_figures() -> None:
    assert judged(times(3)).code is judged(times(3, 90)).code is Code.RIGHT
    assert judged(times(2)).code is not Code.RIGHT


def test_a_turn_of_another_length_is_no_rounding() -> None:
    assert judged(times(9, of=1.02)).code is judged(times(9, of=0.98)).code is Code.NO_MARKS


def test_steps_that_do_not_divide_the_turn_are_judged_as_typed() -> None:
    assert judged(table(rows=900)).code is Code.RIGHT
    text = table(
        lambda alpha: motion(START + (alpha - START) * 0.9937),
        rows=200,
        abscissa=lambda turn: 0.9937 * 2 * pi / SPEED * turn,
    )
    assert judged(text).code is Code.RIGHT


def test_the_angle_is_judged_where_the_times_beside_it_are_coarse() -> None:
    def coarse(turn: float) -> float:
        return round(2 * pi / SPEED * turn, 2)

    both = table(lambda alpha: (degrees(alpha), *motion(alpha)), abscissa=coarse, head="t;alpha;x;v;a")
    assert judged(both).code is Code.RIGHT and judged(table(abscissa=coarse)).code is not Code.RIGHT


def test_several_cycles_and_rows_in_any_order_are_one_cycle() -> None:
    lines = table(rows=48).split("\n")
    assert judged("\n".join([lines[0], *reversed(lines[1:])])).code is Code.RIGHT
    twice = table(lambda alpha: motion(2 * alpha - START), abscissa=lambda turn: 4 * pi / SPEED * turn, rows=90)
    assert judged(twice).code is Code.RIGHT


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", Reason.EMPTY),
        ("\ufeff", Reason.EMPTY),
        ("abc", Reason.NOT_A_TABLE),
        ("sin(\n\t", Reason.NOT_A_TABLE),
        ("t;x;v;a", Reason.NOT_A_TABLE),
        ("1;2", Reason.NOT_A_TABLE),
        ("t;x;v;a\n1;2;3;nan", Reason.NOT_A_TABLE),
        ("t;x;v;a\n1;2;3;1e5e5", Reason.NOT_A_TABLE),
        ("t;x;v;a\n1;2;3;1e999", Reason.OUT_OF_RANGE),
        ("t;x;v;a\n1;2;3", Reason.RAGGED_MATRIX),
        ("t;x;v;a\n1;2;3;4\n1;2;3", Reason.RAGGED_MATRIX),
        ("t;x;v;a;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q;q\n" + ";".join("1" * 25), Reason.RAGGED_MATRIX),
        ("t;x;v;qq\n1;2;3;4", Reason.NO_SUCH_COLUMN),
        ("x;v;a\n1;2;3", Reason.NO_SUCH_COLUMN),
        ("t;x;v;x\n1;2;3;4", Reason.REPEATED_ITEM),
        ("t;x [kN];v;a\n1;2;3;4", Reason.UNKNOWN_UNIT),
        ("t;x [qq];v;a\n1;2;3;4", Reason.UNKNOWN_UNIT),
        ("t;x;v;a\n" + "1;2;3;4\n" * (MOST_ROWS + 1), Reason.TOO_LONG),
        ("1" * (LARGEST + 1), Reason.TOO_LONG),
        ("{", Reason.NOT_A_TABLE),
        ("[" * 100_000, Reason.NOT_A_TABLE),
        ("[1, 2]", Reason.NOT_A_TABLE),
        ("[]", Reason.NOT_A_TABLE),
        ('{"t": [1], "x": [1, 2]}', Reason.RAGGED_MATRIX),
        ('{"t": [], "x": []}', Reason.NOT_A_TABLE),
        ('[{"t": 1, "x": null}]', Reason.NOT_A_NUMBER),
        ('[{"t": 1, "x": true}]', Reason.NOT_A_NUMBER),
        ('{"t": [1e999], "x": [1]}', Reason.NOT_A_NUMBER),
    ],
)
def test_what_is_no_table_is_refused(text: str, reason: Reason) -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        JUDGE.parse(text, NOTHING)
    assert refused.value.reason is reason


def test_a_bad_cell_is_named_with_its_place() -> None:
    with pytest.raises(AnswerSyntaxError) as refused:
        JUDGE.parse("t;x;v;a\n0;1;2;3\n1;2;a;3", NOTHING)
    assert (refused.value.position, refused.value.proposal.found) == (20, "a;3")
    with pytest.raises(AnswerSyntaxError) as ragged:
        JUDGE.parse("t;x;v;a\n0;1;2;3\n1;2;3", NOTHING)
    assert ragged.value.position == 16


@settings(max_examples=amount(10, 30), deadline=None)
@given(st.integers(24, 200), st.floats(0, 1))
def test_between_the_rows_of_the_reference_the_curve_is_true(rows: int, share: float) -> None:
    """Interpolation of 37 rows costs less than a hundredth of the tolerance."""
    cycle = cycle_of(REFERENCE, 2)
    for k in range(0, rows, 7):
        phase = (k + share) / rows
        true = motion(START + 2 * pi * phase)
        for column, (value, scale) in enumerate(zip((true[0] / 1e3, *true[1:]), cycle.scales, strict=True)):
            assert abs(cycle.at(column, cycle.knot(phase)) - value) < 1e-4 * scale


def test_a_coarse_reference_is_refused() -> None:
    with pytest.raises(ValueError, match="too coarse"):
        cycle_of(reference(7), 2)


def test_tables_lie_apart_by_their_largest_difference_in_tolerances() -> None:
    faster = tuple((0.9 * t, *rest) for t, *rest in REFERENCE)
    higher = tuple((t, alpha, x + 0.0016, v, a) for t, alpha, x, v, a in REFERENCE)
    assert JUDGE.apart(REFERENCE, REFERENCE) == 0
    assert JUDGE.apart(REFERENCE, faster) == pytest.approx(10, rel=1e-6)
    assert JUDGE.apart(REFERENCE, higher) == pytest.approx(2, rel=0.01)
    assert JUDGE.apart(REFERENCE, reference(30)) == float("inf")


def test_a_table_is_echoed_described_and_carried() -> None:
    answer = JUDGE.parse(table(rows=30), NOTHING)
    assert JUDGE.echo(answer).text == "31 × (t [s]; x [mm]; v [m/s]; a [m/s^2])"
    assert len(JUDGE.carried(answer)) == 31
    described = JUDGE.describe()
    assert described == json.loads(json.dumps(described)) and described["least_rows"] == 24
    assert "1 %" in tolerance(described, "ru")


def test_the_longest_table_is_judged_in_time() -> None:
    zero = "t;x;v;a\n" + "\n".join(f"{k * 2 * pi / SPEED / 9999:.9f};0;{k % 7};1" for k in range(MOST_ROWS))
    for text in (table(rows=9_000), zero, "1;" * 250_000, "\n" * 499_999 + "a"):
        # tens of milliseconds on a free core; minutes if it grew as a square
        assert effort(partial(read, text), enough=1.0) < 1.0


def test_a_long_wrong_table_is_graded_with_little_work() -> None:
    variant = deal("slider_crank_cycle", 3)
    rows = "\n".join(f"{k / 10_000};{k % 97};{k % 13};{k % 7}" for k in range(6600))
    submission = Submission(variant, {"cycle": f"t;x;v;a\n{rows}"})
    assert grade(submission).verdicts["cycle"].code is Code.NO_MARKS
    assert effort(lambda: grade(submission), 2, enough=0.5) < 0.5  # ten times quicker than its square would be
