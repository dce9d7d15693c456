"""Slips at a gear train (TR-3, TR-4): turned ratios, signs of meshes, idlers, coaxial teeth, losses, units."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from exercises.transmissions.gear_train import Givens
from exercises.transmissions.gear_train.wheels import Coaxial, Coupled, Mesh
from tests.slips.slip import S

Ratios = list[tuple[str, bool]]


def meshes(givens: Givens) -> Ratios:
    """Write z of the driven over z of the driving wheel, and whether the mesh is external."""
    found = []
    for at, wheel in enumerate(givens.wheels):
        if isinstance(wheel, Mesh | Coaxial):
            found.append((f"z{at + 1}/z{at}", wheel.type == "external"))
    return found


def product(ratios: Ratios) -> str:
    return "*".join(f"(-{ratio})" if external else f"({ratio})" for ratio, external in ratios)


def ratio(change: Callable[[Ratios], Ratios | None]) -> Callable[[Any], Mapping[str, str] | None]:
    """The ratio made of other meshes; no occasion where nothing is changed."""

    def lines(givens: Any) -> Mapping[str, str] | None:
        true = meshes(givens)
        changed = change(true)
        return None if changed is None or changed == true else {"u": product(changed)}

    return lines


def turned(ratio: str) -> str:
    over, under = ratio.split("/")
    return f"{under}/{over}"


def all_turned(ratios: Ratios) -> Ratios:
    return [(turned(one), external) for one, external in ratios]


def one_turned(at: int) -> Callable[[Ratios], Ratios | None]:
    def change(ratios: Ratios) -> Ratios | None:
        if not -len(ratios) <= at < len(ratios) or len(ratios) < 2:
            return None
        place = at % len(ratios)
        return [(turned(one), e) if i == place else (one, e) for i, (one, e) in enumerate(ratios)]

    return change


def one_left_out(at: int) -> Callable[[Ratios], Ratios | None]:
    def change(ratios: Ratios) -> Ratios | None:
        if not -len(ratios) <= at < len(ratios) or len(ratios) < 2:
            return None
        place = at % len(ratios)
        return [one for i, one in enumerate(ratios) if i != place]

    return change


def all_external(ratios: Ratios) -> Ratios:
    return [(one, True) for one, _ in ratios]


def all_internal(ratios: Ratios) -> Ratios | None:
    return [(one, False) for one, _ in ratios] if sum(external for _, external in ratios) % 2 else None


def summed(givens: Any) -> Mapping[str, str] | None:
    """The ratios added."""
    sizes = [one for one, _ in meshes(givens)]
    sign = "-" if sum(external for _, external in meshes(givens)) % 2 else ""
    return {"u": f"{sign}({' + '.join(sizes)})"} if len(sizes) > 1 else None


def ends(givens: Any) -> Mapping[str, str] | None:
    sign = "-" if sum(external for _, external in meshes(givens)) % 2 else ""
    coupled = any(isinstance(wheel, Coupled) for wheel in givens.wheels)
    return {"u": f"{sign}z{len(givens.wheels)}/z1"} if coupled else None


def ends_turned(givens: Any) -> Mapping[str, str] | None:
    sign = "-" if sum(external for _, external in meshes(givens)) % 2 else ""
    simple = not any(isinstance(wheel, Coupled) for wheel in givens.wheels)
    return {"u": f"{sign}z1/z{len(givens.wheels)}"} if simple else None


def coaxial(line: str) -> Callable[[Any], Mapping[str, str] | None]:
    return lambda givens: {"z4": line} if isinstance(givens.wheels[-1], Coaxial) else None


def of_type(external: str, internal: str) -> Callable[[Any], Mapping[str, str] | None]:
    def lines(givens: Any) -> Mapping[str, str] | None:
        last = givens.wheels[-1]
        if not isinstance(last, Coaxial) or givens.wheels[1].type != "external":
            return None
        return {"z4": external if last.type == "external" else internal}

    return lines


def losses(form: str) -> Callable[[Any], Mapping[str, str]]:
    return lambda givens: {"M_out": form.format(n=len(meshes(givens)), more=len(meshes(givens)) + 1)}


def shared(word: str) -> Callable[[Any], Mapping[str, str] | None]:
    """The opposite choice of the sense, typed alone."""
    return lambda givens: (
        {"sense": word} if (sum(e for _, e in meshes(givens)) % 2 == 0) == (word == "=opposite") else None
    )


SLIPS = (
    S("all ratios upside down", "ratio_inverted inverted_ratio", ratio(all_turned)),
    S("only the number u upside down", "inverted_ratio", {}, {"u": "1/u"}),
    S("the first mesh upside down", "upside_down first_inverted last_inverted", ratio(one_turned(0))),
    S("the last mesh upside down", "last_inverted upside_down", ratio(one_turned(-1))),
    S("the second mesh upside down", "upside_down last_inverted", ratio(one_turned(1))),
    S("the first mesh left out", "factor_lost", ratio(one_left_out(0))),
    S("the last mesh left out", "factor_lost", ratio(one_left_out(-1))),
    S("the second mesh left out", "factor_lost", ratio(one_left_out(1))),
    S("ratios added", "sum_of_ratios", summed),
    S("first and last wheel only", "ends_only", ends),
    S("first over last wheel, all between idlers", "ratio_inverted inverted_ratio", ends_turned),
    S(
        "every mesh taken as external",
        "internal_as_external opposite_sign sign_by_wheels term_sign",
        ratio(all_external),
    ),
    S("signs left out", "opposite_sign sign_by_wheels term_sign internal_as_external", ratio(all_internal)),
    S("sign of the number alone", "opposite_sign", {}, {"u": "-u"}),
    S(
        "sign of the formula and number by the count of wheels",
        "sign_by_wheels opposite_sign internal_as_external term_sign",
        lambda g: (
            {
                "u": product([(r, False) for r, _ in meshes(g)])
                if len(g.wheels) % 2 == 0
                else "-" + product([(r, False) for r, _ in meshes(g)])
            }
            if (len(g.wheels) - sum(e for _, e in meshes(g))) % 2
            else None
        ),
    ),
    # the coaxial wheel
    S(
        "difference for a sum of teeth",
        "axes_apart term_sign internal_as_external",
        of_type("z1 - z2 + z3", "z1 + z2 - z3"),
    ),
    S("teeth of the second pair equal to the first", "equal_pairs", coaxial("z2")),
    S("the sum of all teeth", "term_sign axes_apart", of_type("z1 + z2 + z3", "z2 - z1 + z3")),
    S("the driven wheel of the first pair alone", "term_lost first_wheel_forgotten", of_type("z2 - z3", "z2 + z3")),
    # the speed
    S("speed multiplied by the ratio", "upside_down speed_multiplied", {"n_out": "n_in*u"}),
    S(
        "speed without its sign",
        "opposite_sign sign_lost",
        lambda g: {"n_out": "n_in/abs(u)"} if sum(e for _, e in meshes(g)) % 2 else None,
    ),
    S("sign of the speed", "opposite_sign", {}, {"n_out": "-n_out"}),
    S("speed typed in rad/s", "turns_radians", {}, {"n_out": "n_out*pi/30"}),
    S("speed in turns a second", "turns_radians", {}, {"n_out": "n_out/60"}),
    S("speed in radians a minute", "turns_radians", {}, {"n_out": "n_out*2*pi"}),
    S("speed off by ten", "power_of_ten factor_of_ten", {}, {"n_out": "n_out*10"}),
    S("speed off by a hundred", "power_of_ten factor_of_ten", {}, {"n_out": "n_out/100"}),
    S("speed halved", "factor_two", {}, {"n_out": "n_out/2"}),
    S("speed doubled", "factor_two", {}, {"n_out": "n_out*2"}),
    S("speed of the input given", "factor_lost", {"n_out": "n_in"}),
    S("the torque's losses in the speed", "losses_in_speed", {"n_out": "n_in/u*eta"}),
    # the torque
    S("losses forgotten", "factor_lost losses_forgotten", {"M_out": "M_in*u"}),
    S("losses of one mesh only", "efficiency_once", lambda g: {"M_out": "M_in*u*eta"} if len(meshes(g)) > 1 else None),
    S("losses of one mesh too many", "power", losses("M_in*u*eta^{more}")),
    S(
        "losses multiplied by the number of meshes",
        "losses_summed",
        lambda g: {"M_out": f"M_in*u*(1 - {len(meshes(g))}*(1 - eta))"} if len(meshes(g)) > 1 else None,
    ),
    S("divided by the losses", "upside_down losses_divided", losses("M_in*u/eta^{n}")),
    S("torque reduced like the speed", "torque_divided", losses("M_in/u*eta^{n}")),
    S("ratio forgotten in the torque", "factor_lost", losses("M_in*eta^{n}")),
    S("sign of the torque", "opposite_sign", {}, {"M_out": "-M_out"}),
    S(
        "torque without the sign of u",
        "opposite_sign sign_lost",
        lambda g: {"M_out": f"M_in*abs(u)*eta^{len(meshes(g))}"} if sum(e for _, e in meshes(g)) % 2 else None,
    ),
    S("torque in kN m", "kilo_prefix factor_of_ten", {}, {"M_out": "M_out/1000"}),
    S("torque in N mm", "kilo_prefix factor_of_ten", {}, {"M_out": "M_out*1000"}),
    S("torque in N cm", "power_of_ten factor_of_ten", {}, {"M_out": "M_out*100"}),
    S("torque off by ten", "power_of_ten factor_of_ten", {}, {"M_out": "M_out/10"}),
    S("torque of half the shaft", "factor_two", {}, {"M_out": "M_out/2"}),
    S("torque doubled", "factor_two", {}, {"M_out": "2*M_out"}),
    # several at once
    S("sign lost in u and n_out", "opposite_sign", {}, {"u": "-u", "n_out": "-n_out"}),
    S("sign of all numbers", "opposite_sign", {}, {"u": "-u", "n_out": "-n_out", "M_out": "-M_out"}),
    S(
        "ratio of the number upside down, speed and torque after it",
        "inverted_ratio",
        {},
        {"u": "1/u", "n_out": "n_in*u", "M_out": "M_out/u^2"},
    ),
    S("ratio upside down and torque off by a thousand", "ratio_inverted", ratio(all_turned), {"M_out": "M_out*1000"}),
    S(
        "one mesh's losses and speed in rad/s",
        "efficiency_once",
        lambda g: {"M_out": "M_in*u*eta"} if len(meshes(g)) > 1 else None,
        {"n_out": "n_out*pi/30"},
    ),
    S("speed in rad/s and torque left empty", "turns_radians", {}, {"n_out": "n_out*pi/30"}, "M_out"),
    S("torque reduced, speed off by ten", "torque_divided", losses("M_in/u*eta^{n}"), {"n_out": "n_out*10"}),
    S(
        "formula with one mesh upside down, number right",
        "upside_down last_inverted",
        {},
        lambda g: {"u_formula": "=" + product(one_turned(-1)(meshes(g)) or [])} if len(meshes(g)) > 1 else None,
    ),
    S(
        "formula without its sign, number right",
        "opposite_sign term_sign",
        {},
        lambda g: (
            {"u_formula": "=" + product([(r, False) for r, _ in meshes(g)])}
            if sum(e for _, e in meshes(g)) % 2
            else None
        ),
    ),
    S(
        "formula upside down, number right",
        "inverted_ratio",
        {},
        lambda g: {"u_formula": "=" + product(all_turned(meshes(g)))},
    ),
    S("opposite sense chosen", "wrong", {}, shared("=opposite")),
    S("same sense chosen", "wrong", {}, shared("=same")),
)
