"""Slips at diagrams of V and M (SM-11; needs section 7): reactions, jumps, slopes, curves, signs, ends."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from exercises.exercise import each
from exercises.strength._beam import members
from exercises.strength._beam.lines import added
from exercises.strength.beam_diagrams import slips
from tests.slips.simple_beam import about_B, negative, of
from tests.slips.slip import Lines, S

Rows = tuple[tuple[float, ...], ...]


def two_supports(lines: Lines) -> Lines:
    return lambda g: lines(g) if len(g.supports) == 2 else None


def wall(lines: Lines) -> Lines:
    return lambda g: lines(g) if len(g.supports) == 1 else None


def drawn(name: str, change: Callable[[Rows], Rows]) -> Mapping[str, Callable[[Mapping[str, Any]], Rows]]:
    return {name: lambda values: change(values[name])}


def rows(change: Callable[[Sequence[float]], Sequence[float]]) -> Callable[[Rows], Rows]:
    return lambda found: tuple(tuple(change(row)) for row in found)


def scaled(factor: float) -> Callable[[Rows], Rows]:
    return rows(lambda row: (*row[:2], *(c * factor for c in row[2:])))


def stretch(at: int, change: Callable[[Sequence[float]], Sequence[float]]) -> Callable[[Rows], Rows]:
    return lambda found: tuple(
        tuple(change(row)) if i == at % len(found) else tuple(row) for i, row in enumerate(found)
    )


def value(row: Sequence[float], t: float) -> float:
    return sum(c * t**power for power, c in enumerate(row[2:]))


def chord(row: Sequence[float]) -> Sequence[float]:
    """Draw a straight line between the ends."""
    length = row[1] - row[0]
    start, end = value(row, 0.0), value(row, length)
    return (*row[:2], start, (end - start) / length, *(0.0 for _ in row[4:]))


def sagging_the_other_way(row: Sequence[float]) -> Sequence[float]:
    """Draw the parabola hollow where it is full."""
    straight = chord(row)
    return (*row[:2], *(2 * a - b for a, b in zip(straight[2:], row[2:], strict=True)))


def raised(by: float) -> Callable[[Sequence[float]], Sequence[float]]:
    return lambda row: (*row[:2], row[2] + by, *row[3:])


def flat(row: Sequence[float]) -> Sequence[float]:
    return (*row[:2], row[2], *(0.0 for _ in row[3:]))


def nothing(row: Sequence[float]) -> Sequence[float]:
    return (*row[:2], *(0.0 for _ in row[2:]))


def loaded(change: Callable[[Sequence[float]], Sequence[float]], part: int) -> Callable[[Rows], Rows]:
    """Change the stretches under the uniform load: of V those with a slope, of M the curved ones."""
    return rows(lambda row: change(row) if len(row) > part and row[part] else row)


def mirrored(found: Rows) -> Rows:
    """Draw from the right end with the places of the left one."""
    end = found[-1][1]
    turned = []
    for row in found[::-1]:
        length = row[1] - row[0]
        c0, c1, c2 = (*row[2:], 0.0, 0.0, 0.0)[:3]
        turned.append((end - row[1], end - row[0], c0 + c1 * length + c2 * length**2, -c1 - 2 * c2 * length, c2))
    return tuple(turned)


def half_ended(found: Rows) -> Rows:
    """The last stretch runs into nothing."""
    return tuple(found[:-1])


def continued(found: Rows) -> Rows:
    """No jumps: each stretch goes on from the end of the one before."""
    done: list[tuple[float, ...]] = []
    at = found[0][2]
    for row in found:
        done.append((*row[:2], at, *row[3:]))
        at = value(done[-1], row[1] - row[0])
    return tuple(done)


def other_reaction(change: Callable[[str], str]) -> Lines:
    def lines(g: Any) -> Mapping[str, str] | None:
        total = added(each(g.loads, lambda load: load.total))
        return {"R_B": change(f"({total})") + " - R_A"} if len(g.supports) == 2 else None

    return lines


def first_force(g: Any) -> Any:
    return next(load for load in g.loads if isinstance(load, members.Force))


def at_wall(form: str) -> Lines:
    """Type the moment at the wall by a formula of it."""

    def typed(g: Any) -> Mapping[str, str] | None:
        if len(g.supports) == 2:
            return None
        name = "M_A" if isinstance(g.supports[0], members.ClampedLeft) else "M_B"
        return {name: form.format(name)}

    return typed


def reaction(form: str) -> Lines:
    """Type the first reaction by a formula of it."""

    def typed(g: Any) -> Mapping[str, str]:
        name = "R_B" if isinstance(g.supports[0], members.ClampedRight) else "R_A"
        return {name: form.format(name)}

    return typed


SLIPS = (
    # reactions
    S("the resultant of q at the middle of the beam", "lever_half_beam", lambda g: slips.half_beam(g) or None),
    S("a couple in the other sense", "couple_sense term_sign", lambda g: slips.couple_sense(g) or None),
    S("moments about the wrong support", "reactions_exchanged", lambda g: slips.reactions_exchanged(g) or None),
    S(
        "a couple forgotten in the moments",
        "term_lost",
        two_supports(
            lambda g: of(members.Clockwise, lambda _: None)(g) or of(members.Counterclockwise, lambda _: None)(g)
        ),
    ),
    S(
        "a force forgotten in the moments",
        "term_lost",
        two_supports(lambda g: about_B(lambda line, load: None if load is first_force(g) else line)(g)),
    ),
    S("uniform load forgotten in the moments", "term_lost", two_supports(of(members.Uniform, lambda _: None))),
    S("upward force counted downwards", "term_sign", two_supports(of(members.Lift, negative))),
    S(
        "q not multiplied by its length",
        "factor_lost",
        two_supports(of(members.Uniform, lambda line: line.split("*(")[0] + "*(" + line.split("*(", 2)[2])),
    ),
    S("half of q's resultant", "factor_two", two_supports(of(members.Uniform, lambda line: line + "/2"))),
    S(
        "reactions exchanged in the fields",
        "fields_exchanged reactions_exchanged",
        {},
        lambda g: {"R_A": "R_B", "R_B": "R_A"} if len(g.supports) == 2 else None,
    ),
    S("sign of the first reaction", "opposite_sign", {}, reaction("-{}")),
    S("first reaction in newtons", "kilo_prefix factor_of_ten", {}, reaction("{}*1000")),
    S("first reaction off by ten", "power_of_ten factor_of_ten", {}, reaction("{}/10")),
    S("first reaction halved", "factor_two", {}, reaction("{}/2")),
    S(
        "R_A added for R_B",
        "term_sign",
        lambda g: {"R_B": f"{added(each(g.loads, lambda load: load.total))} + R_A"} if len(g.supports) == 2 else None,
    ),
    S(
        "R_A forgotten for R_B",
        "term_lost",
        lambda g: {"R_B": added(each(g.loads, lambda load: load.total))} if len(g.supports) == 2 else None,
    ),
    S(
        "uniform load forgotten in the sum of forces",
        "term_lost",
        lambda g: (
            {
                "R_B": added(
                    line
                    for line, load in zip(each(g.loads, lambda load: load.total), g.loads, strict=True)
                    if not isinstance(load, members.Uniform)
                )
                + " - R_A"
            }
            if len(g.supports) == 2
            else None
        ),
    ),
    S("sign of the moment at the wall", "opposite_sign", {}, at_wall("-{}")),
    S("moment at the wall in N m", "kilo_prefix factor_of_ten", {}, at_wall("{}*1000")),
    S("moment at the wall doubled", "factor_two", {}, at_wall("2*{}")),
    # the shear force
    S("V with the opposite sign", "opposite_convention opposite_shear opposite_sign", {}, drawn("V", scaled(-1))),
    S("V in newtons", "factor_of_ten power_of_ten", {}, drawn("V", scaled(1000))),
    S("V off by ten", "factor_of_ten power_of_ten", {}, drawn("V", scaled(0.1))),
    S(
        "V flat under the uniform load",
        "degree slope straight lost_jump jump extra_jump resultant_drawn",
        {},
        drawn("V", loaded(flat, 3)),
    ),
    S(
        "V rising under the uniform load",
        "opposite_slope slope",
        {},
        drawn("V", loaded(lambda r: (*r[:3], -r[3], *r[4:]), 3)),
    ),
    S("slope of V doubled", "slope", {}, drawn("V", loaded(lambda r: (*r[:3], 2 * r[3], *r[4:]), 3))),
    S("no jumps in V", "lost_jump", {}, drawn("V", continued)),
    S(
        "last stretch of V raised",
        "jump lost_jump extra_jump open_end ordinate",
        {},
        drawn("V", stretch(-1, raised(5000.0))),
    ),
    S(
        "first stretch of V raised",
        "jump lost_jump extra_jump open_end ordinate",
        {},
        drawn("V", stretch(0, raised(5000.0))),
    ),
    S(
        "second stretch of V raised",
        "jump lost_jump extra_jump ordinate opposite_jump",
        {},
        drawn("V", stretch(1, raised(7000.0))),
    ),
    S(
        "V drawn from the right end",
        "opposite_slope slope jump lost_jump extra_jump opposite_jump",
        {},
        drawn("V", mirrored),
    ),
    S("V ending early", "gap open_end", {}, drawn("V", half_ended)),
    S(
        "last stretch of V at zero",
        "lost_jump jump extra_jump slope ordinate degree",
        {},
        drawn("V", stretch(-2, nothing)),
    ),
    S("V halved", "ordinate jump slope", {}, drawn("V", scaled(0.5))),
    # the bending moment
    S("M with the opposite sign", "opposite_convention opposite_moment opposite_sign", {}, drawn("M", scaled(-1))),
    S(
        "both diagrams with the opposite sign",
        "opposite_convention opposite_sign",
        {},
        {**drawn("V", scaled(-1)), **drawn("M", scaled(-1))},
    ),
    S("M in N m", "factor_of_ten power_of_ten", {}, drawn("M", scaled(1000))),
    S(
        "both diagrams in thousands",
        "factor_of_ten power_of_ten",
        {},
        {**drawn("V", scaled(1000)), **drawn("M", scaled(1000))},
    ),
    S("M off by ten", "factor_of_ten power_of_ten", {}, drawn("M", scaled(10))),
    S("M straight under the uniform load", "straight degree resultant_drawn slope", {}, drawn("M", loaded(chord, 4))),
    S(
        "M hollow under the uniform load",
        "slope opposite_slope degree extreme ordinate",
        {},
        drawn("M", loaded(sagging_the_other_way, 4)),
    ),
    S("jumps of M at couples left out", "lost_jump couple_jump_lost", lambda g: slips.couple_jump_lost(g) or None),
    S(
        "no jumps in M drawn at all",
        "lost_jump couple_jump_lost",
        {},
        lambda g: (
            drawn("M", continued)
            if any(isinstance(m, members.Clockwise | members.Counterclockwise) for m in g.loads)
            else None
        ),
    ),
    S("resultant for the uniform load in both diagrams", "resultant_drawn", lambda g: slips.resultant_drawn(g) or None),
    S("moment of the wall left out", "wall_moment_lost", lambda g: slips.wall_moment_lost(g) or None),
    S(
        "V from the right with the signs of the left",
        "opposite_shear opposite_convention",
        lambda g: slips.opposite_shear(g) or None,
    ),
    S(
        "M drawn from the right end",
        "slope opposite_slope jump lost_jump extra_jump opposite_jump ordinate extreme",
        {},
        drawn("M", mirrored),
    ),
    S("M ending early", "gap open_end", {}, drawn("M", half_ended)),
    S(
        "last stretch of M raised",
        "jump lost_jump extra_jump open_end opposite_jump",
        {},
        drawn("M", stretch(-1, raised(5000.0))),
    ),
    S(
        "first stretch of M raised",
        "jump lost_jump extra_jump open_end ordinate opposite_jump",
        {},
        drawn("M", stretch(0, raised(5000.0))),
    ),
    S(
        "second stretch of M flat",
        "slope opposite_slope lost_jump jump extra_jump degree straight",
        {},
        drawn("M", stretch(1, flat)),
    ),
    S("M halved", "ordinate slope extreme jump", {}, drawn("M", scaled(0.5))),
    S(
        "V drawn for M",
        "degree slope jump extra_jump ordinate straight",
        {},
        {"M": lambda v: tuple((*row, 0.0) for row in v["V"])},
    ),
    S("M drawn for V", "degree slope jump lost_jump ordinate bent", {}, {"V": lambda v: v["M"]}),
    # several at once
    S(
        "lever of half the beam, V in newtons",
        "lever_half_beam",
        lambda g: slips.half_beam(g) or None,
        drawn("V", scaled(1000)),
    ),
    S("couple in the other sense, M left empty", "couple_sense", lambda g: slips.couple_sense(g) or None, {}, "M"),
    S(
        "moments about the wrong support, V left empty",
        "reactions_exchanged",
        lambda g: slips.reactions_exchanged(g) or None,
        {},
        "V",
    ),
    S(
        "resultant drawn, first reaction in newtons",
        "resultant_drawn",
        lambda g: slips.resultant_drawn(g) or None,
        reaction("{}*1000"),
    ),
    S("sign of the first reaction, diagrams left empty", "opposite_sign", {}, reaction("-{}"), "V M"),
)
