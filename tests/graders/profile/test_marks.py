"""The marks of a diagram at their borders: what is just right, and what is just off.

Mutants of the marks that live on change nothing that can be seen:

* an end of the span among the inner places, where it stands anyway; the end of a curve of slopes, which nobody reads;
* powers above both degrees, which add nothing; marks for a diagram without a stretch, which there is not;
* how strictly two pairs of slopes are put side by side; the size of a sign; nothing for what is never nothing.
"""

from __future__ import annotations

import pytest

from graders.profile import marks
from graders.profile.marks import Comparison, Mark, compare, idle_share
from graders.profile.stretches import Stretch
from graders.remarks import Remark, Slip

LEVEL, RAMP = Stretch(0, 4, (4.0,)), Stretch(0, 4, (0.0, 1.0))
ARCH = Stretch(0, 4, (0.0, 4.0, -1.0))  # turns at 2 with the ordinate 4


def seen(drawn: list[Stretch], true: list[Stretch], rtol: float = 0.25) -> Comparison:
    return compare(tuple(drawn), tuple(true), rtol)


def flaws(mark: Mark | None) -> tuple[Remark, ...]:
    assert mark is not None
    assert (mark.share == 1) is not bool(mark.flaws)
    return mark.flaws


def places(mark: Mark | None, slip: Slip) -> list[float | None]:
    found = flaws(mark)
    assert {remark.slip for remark in found} <= {slip}
    return [remark.place for remark in found]


@pytest.mark.parametrize(("border", "count"), [(3.003, 2), (2.997, 2), (3.005, 3), (2.995, 3), (2.003, 2), (3.997, 2)])
def test_a_border_is_the_true_one_where_it_lies_within_a_share_of_the_span(border: float, count: int) -> None:
    true = [Stretch(2, 3, (4.0,)), Stretch(3, 4, (4.0,))]
    found = seen([Stretch(2, border, (4.0,)), Stretch(border, 4, (4.0,))], true)
    assert len(found.pairs) == count


def test_a_border_just_as_far_as_may_be_is_the_true_one() -> None:
    found = seen(
        [Stretch(0, 502, (4.0,)), Stretch(502, 1000, (4.0,))], [Stretch(0, 500, (4.0,)), Stretch(500, 1000, (4.0,))]
    )
    assert [pair.true.end for pair in found.pairs] == [500, 1000] and found.right


def test_a_stretch_too_short_to_be_seen_is_none() -> None:
    true = [Stretch(0, 3, (4.0,)), Stretch(3, 4, (4.0,))]
    assert seen([Stretch(0, 4, (4.0,)), Stretch(3.001, 3.003, (4.0,))], true).right


def test_what_begins_again_at_the_start_covers_it_twice() -> None:
    assert seen([LEVEL, Stretch(0, 1, (4.0,))], [LEVEL]).span.flaws == (Remark(Slip.OVERLAP, 0, 1),)


def test_a_diagram_left_at_zero_has_no_ordinate_right() -> None:
    assert (
        idle_share((Stretch(0, 2, (1.0,)),), 0.01)
        < compare((Stretch(0, 2, (1.0,)),), (Stretch(0, 2, (1.0,)),), 0.01).share
    )


@pytest.mark.parametrize(
    ("true", "drawn", "slip"),
    [
        (4.0, 6.0, None),
        (4.0, 6.25, Slip.JUMP),
        (4.0, 2.0, None),
        (4.0, 1.75, Slip.LOST_JUMP),
        (-4.0, 2.0, Slip.LOST_JUMP),
        (2.0, -4.0, Slip.EXTRA_JUMP),
        (2.0, -4.25, Slip.EXTRA_JUMP),
        (5.0, -3.0, Slip.OPPOSITE_JUMP),
        (5.0, -2.75, Slip.JUMP),
    ],
)
def test_a_jump_may_be_off_by_two_tolerances(true: float, drawn: float, slip: Slip | None) -> None:
    """The tolerance is 1."""
    after = 4.0 if true > 0 else -4.0
    bar = [Stretch(0, 2, (after - true,)), Stretch(2, 4, (after,))]
    highest = max(abs(after - true), 4.0)
    found = marks.jumps(seen([Stretch(0, 2, (0.0,)), Stretch(2, 4, (drawn,))], bar, 1 / highest))
    assert flaws(found) == (() if slip is None else (Remark(slip, 2),))


def test_jumps_within_two_tolerances_are_none() -> None:
    bar = [Stretch(0, 2, (2.0,)), Stretch(2, 4, (4.0,))]
    assert marks.jumps(seen([Stretch(0, 2, (4.0,)), Stretch(2, 4, (2.0,))], bar)) is None


def test_jumps_beside_what_is_not_drawn_are_lost_each_at_its_place() -> None:
    bar = [Stretch(at, at + 1, (height,)) for at, height in enumerate((0.0, 4.0, 2.0, -1.0))]
    found = marks.jumps(seen([bar[0], bar[3]], bar))
    assert flaws(found) == (Remark(Slip.LOST_JUMP, 1), Remark(Slip.LOST_JUMP, 3))
    assert flaws(marks.jumps(seen([bar[0], bar[2], Stretch(3, 4, (2.0,))], bar)))[-1] == Remark(Slip.LOST_JUMP, 3)


@pytest.mark.parametrize(("slope", "off"), [(0.5, False), (0.625, True), (-0.5, False), (-0.625, True)])
def test_the_slope_of_a_level_bar_may_be_as_large_as_its_tolerance_allows(slope: float, off: bool) -> None:
    """Two tolerances over the length."""
    assert bool(flaws(marks.slopes(seen([Stretch(0, 4, (4.0, slope))], [LEVEL])))) is off


@pytest.mark.parametrize(("slope", "off"), [(20.0, False), (30.0, True)])
def test_beside_a_steep_stretch_a_slope_may_be_off_by_a_share_of_the_steepest(slope: float, off: bool) -> None:
    bar = [Stretch(0, 1, (0.0, 100.0)), Stretch(1, 8, (100.0,))]
    found = marks.slopes(seen([bar[0], Stretch(1, 8, (100.0, slope))], bar))
    assert flaws(found) == ((Remark(Slip.SLOPE, 1, 8),) if off else ())


@pytest.mark.parametrize(("slope", "slip"), [(-1.0, Slip.OPPOSITE_SLOPE), (-0.875, Slip.SLOPE)])
def test_a_slope_is_the_opposite_one_within_its_tolerance(slope: float, slip: Slip) -> None:
    bar = [Stretch(0, 4, (0.0, 2.0))]
    assert flaws(marks.slopes(seen([Stretch(0, 4, (0.0, slope))], bar))) == (Remark(slip, 0, 4),)


@pytest.mark.parametrize(
    ("true", "drawn", "slip"),
    [
        (Stretch(10, 11, (4.0,)), (4.0, 0.5), None),
        (Stretch(10, 11, (4.0,)), (4.0, 1.0), None),
        (Stretch(10, 11, (4.0,)), (4.0, 1.125), Slip.DEGREE),
        (Stretch(10, 13, (4.0,)), (4.0, 0.0, 0.1), None),
        (Stretch(10, 13, (4.0,)), (4.0, 0.0, 0.15), Slip.BENT),
        (RAMP, (0.0, 0.5), None),
        (RAMP, (0.0, 0.4375), Slip.DEGREE),
        (RAMP, (0.0, 0.075), Slip.DEGREE),
        (Stretch(0, 4, (2.5, 0.375)), (2.5, -0.15), Slip.DEGREE),
    ],
)
def test_a_power_counts_by_what_it_adds_along_its_stretch(
    true: Stretch, drawn: tuple[float, ...], slip: Slip | None
) -> None:
    found = marks.degree(seen([Stretch(true.start, true.end, drawn)], [true]))
    assert flaws(found) == (() if slip is None else (Remark(slip, true.start, true.end),))


def test_an_ordinate_off_by_the_tolerance_is_right() -> None:
    assert not flaws(marks.ordinates(seen([Stretch(0, 4, (5.0,))], [LEVEL])))
    assert flaws(marks.ordinates(seen([Stretch(0, 4, (4.0, 0.3))], [LEVEL]))) == (Remark(Slip.ORDINATE, 4.0),)


@pytest.mark.parametrize(
    ("true", "drawn", "lost"),
    [
        ([ARCH], [Stretch(0, 4, (0.0, 4.1, -1.0))], None),
        ([ARCH], [Stretch(0, 4, (0.0, 4.2, -1.0))], 2.0),
        ([Stretch(10, 14, ARCH.curve)], [Stretch(10, 14, (0.0, 4.1, -1.0))], None),
        ([ARCH], [Stretch(0, 4, (0.0, 6.0, -1.5))], None),
        ([ARCH], [Stretch(0, 4, (0.0, 6.5, -1.625))], 2.0),
        ([Stretch(10, 11, (0.0, 4.0, -1.0))], [Stretch(10, 11, (0.0, 3.0))], None),
        ([Stretch(10, 11, (0.0, 4.0, -4.0))], [Stretch(10, 11, (0.0,))], 10.5),
        ([Stretch(0, 5, (4.0, -1.0))], [Stretch(0, 5, (4.0, -0.8))], None),
        ([Stretch(0, 5, (4.0, -1.1))], [Stretch(0, 5, (4.0, -0.8))], 5.0),
    ],
)
def test_an_extreme_is_met_near_its_place_and_ordinate(
    true: list[Stretch], drawn: list[Stretch], lost: float | None
) -> None:
    found = places(marks.extremes(seen(drawn, true)), Slip.EXTREME)
    assert found == ([] if lost is None else [pytest.approx(lost)])


def test_an_extreme_may_be_off_by_two_tolerances_however_small() -> None:
    assert flaws(marks.extremes(seen([Stretch(0, 4, (0.0, 6.0, -1.5))], [ARCH], 0.125)))


@pytest.mark.parametrize(("top", "met"), [(52, True), (53, False), (48, True), (47, False)])
def test_an_extreme_may_lie_aside_by_a_share_of_the_span(top: float, met: bool) -> None:
    roof = [Stretch(0, 50, (0.0, 2.0)), Stretch(50, 100, (100.0, -2.0))]
    drawn = [Stretch(0, top, (0.0, 100 / top)), Stretch(top, 100, (100.0, -100 / (100 - top)))]
    assert (marks.extremes(seen(drawn, roof, 0.01)) == Mark(1.0)) is met


PLATEAU = [Stretch(0, 1, (0.0, 4.0)), Stretch(1, 3, (4.0,)), Stretch(3, 4, (4.0, -4.0))]


def test_a_level_stretch_is_extreme_everywhere() -> None:
    risen = [PLATEAU[0], Stretch(1, 3, (4.0, 0.05)), Stretch(3, 4, (4.1, -4.1))]
    assert not flaws(marks.extremes(seen(risen, PLATEAU)))
    later = [Stretch(0, 1, (0.0, 3.0)), Stretch(1, 3, (3.0, 0.5)), Stretch(3, 4, (4.0, -4.0))]
    assert not flaws(marks.extremes(seen(later, PLATEAU)))
    beyond = [Stretch(0, 3.75, (0.0, 4 / 3.75)), Stretch(3.75, 4, (4.0, -16.0))]
    assert flaws(marks.extremes(seen(beyond, PLATEAU))) == (Remark(Slip.EXTREME, 1),)


@pytest.mark.parametrize(("fall", "rtol", "met"), [(1.0, 0.25, True), (1.25, 0.25, False), (1.0, 0.125, False)])
def test_a_stretch_is_level_that_falls_by_two_tolerances_at_most(fall: float, rtol: float, met: bool) -> None:
    bar = [Stretch(0, 1, (0.0, 4.0)), Stretch(1, 3, (4.0, -fall)), Stretch(3, 4, (4.0 - 2 * fall, 2 * fall - 4))]
    later = [Stretch(0, 3, (0.0, 4 / 3)), Stretch(3, 4, (4.0, -4.0))]
    assert (marks.extremes(seen(later, bar, rtol)) == Mark(1.0)) is met


def test_an_arch_between_two_ordinates_alike_is_not_level() -> None:
    moved = [Stretch(0, 3, (0.0, 4 / 3)), Stretch(3, 4, (4.0, -4.0))]
    assert places(marks.extremes(seen(moved, [ARCH], 0.01)), Slip.EXTREME) == [pytest.approx(2.0)]


@pytest.mark.parametrize(
    ("true", "place"),
    [
        ([Stretch(10, 14, (4.0, -2.0))], 12.0),
        ([Stretch(10, 11, (4.0, -8.0))], 10.5),
        ([Stretch(10, 11, (4.0, -0.5)), Stretch(11, 12, (-4.0,))], 11.0),
        ([Stretch(10, 14, (4.0, -1.25)), Stretch(14, 16, (-1.0, -1.0))], 13.2),
        ([Stretch(10, 12, (4.0,)), Stretch(12, 14, (0.0,)), Stretch(14, 16, (-4.0,))], 14.0),
    ],
)
def test_a_change_of_sign_that_is_not_drawn_is_told_at_its_place(true: list[Stretch], place: float) -> None:
    flat = [Stretch(true[0].start, true[-1].end, (4.0,))]
    assert places(marks.zeros(seen(flat, true)), Slip.ZERO) == [pytest.approx(place)]
    assert places(marks.zeros(seen(true, flat)), Slip.ZERO) == [pytest.approx(place)]
    assert not flaws(marks.zeros(seen(true, true)))


@pytest.mark.parametrize(
    ("true", "rtol"),
    [
        ([Stretch(0, 4, (-4.0,))], 0.25),
        ([Stretch(0, 2, (4.0,)), Stretch(2, 4, (-1.0,))], 0.25),
        ([Stretch(0, 2, (4.0,)), Stretch(2, 4, (0.5,))], 0.01),
    ],
)
def test_what_stays_on_its_side_has_no_zero(true: list[Stretch], rtol: float) -> None:
    assert marks.zeros(seen(true, true, rtol)) is None


def test_zeros_lost_and_too_many_count_beside_those_that_are_met() -> None:
    wave = [Stretch(0, 2, (4.0, -4.0)), Stretch(2, 4, (-4.0, 4.0))]
    found = marks.zeros(seen([Stretch(0, 4, (4.0, -4.0))], wave))
    assert found is not None and found.share == 0.5
    assert places(found, Slip.ZERO) == [pytest.approx(3.0)]
    assert not flaws(marks.zeros(seen([wave[1]], [Stretch(0, 2, (-4.0,)), wave[1]])))


@pytest.mark.parametrize(("place", "met"), [(52, True), (53, False), (48, True), (47, False)])
def test_a_zero_may_lie_aside_by_a_share_of_the_span(place: float, met: bool) -> None:
    steps = [Stretch(0, 50, (4.0,)), Stretch(50, 100, (-4.0,))]
    found = marks.zeros(seen([Stretch(0, place, (4.0,)), Stretch(place, 100, (-4.0,))], steps))
    assert flaws(found) == (() if met else (Remark(Slip.ZERO, 50), Remark(Slip.ZERO, place)))


@pytest.mark.parametrize(
    ("start", "fall", "open_at"),
    [
        (4.0, 1.25, None),
        (5.0, 1.25, None),
        (3.0, 1.0, None),
        (5.25, 1.5, 0),
        (2.75, 1.0, 0),
        (4.0, 1.0, None),
        (4.0, 0.75, 4),
    ],
)
def test_a_diagram_closes_where_its_ends_are_right_to_the_tolerance(
    start: float, fall: float, open_at: int | None
) -> None:
    found = marks.ends(seen([Stretch(0, 4, (start, -fall))], [Stretch(0, 4, (4.0, -1.25))]))
    assert flaws(found) == (() if open_at is None else (Remark(Slip.OPEN_END, open_at),))
