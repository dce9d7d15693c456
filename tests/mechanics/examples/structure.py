"""Structure and mobility (domain STR): each example computed from its inputs, on a drawing where it needs one."""

from __future__ import annotations

from math import cos, sin

from mechanics.assur import decompose
from mechanics.mobility import Joint, local_freedoms, plane, space
from mechanics.open_chain import Axis, spare_freedoms, tip_freedom
from mechanics.structure import Pair, count_loops, manoeuvrability, planar_mobility, spatial_mobility
from tests.mechanics.examples.reading import Inputs, Outputs, Solve

SIX_LINKS = ("01", "12", "23", "30", "34", "45", "50")  # a four-bar and a dyad, as in VP-5
ACROSS, UPRIGHT, AHEAD = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def two_spheres(given: Inputs) -> Outputs:
    joints = [
        Joint("R", ("0", "1"), (0, 0, 0), ACROSS),
        Joint("S", ("1", "2"), (0, 0.6, 0.8)),
        Joint("S", ("2", "3"), (2, 1, 1.5)),
        Joint("R", ("3", "0"), (2, 1, 0), UPRIGHT),
    ]
    found, spin = space("0123", joints), local_freedoms("0123", joints, in_space=True)
    counted = spatial_mobility(given["moving_links"], {klass: given[f"p{klass}"] for klass in range(1, 6)})
    freedoms = given["p5"] + 2 * given["p4"] + 3 * given["p3"] + 4 * given["p2"] + 5 * given["p1"]
    return {
        "F": counted,
        "local_coupler_spin": spin["2"],
        "useful_F": (found.true or 0) - spin["2"],
        "loops": found.loops,
        "F_by_loops": freedoms - 6 * found.loops,
    }


def six_links(given: Inputs) -> Outputs:
    loops = count_loops([Pair(*ends) for ends in SIX_LINKS])
    return {
        "F": planar_mobility(given["moving_links"], given["p5"], given["p4"]),
        "loops": loops,
        "F_by_loops": given["p5"] + 2 * given["p4"] - 3 * loops,
    }


def cam_with_a_roller(given: Inputs) -> Outputs:
    cam = [
        Joint("R", ("0", "1"), (0, 0)),
        Joint("H", ("1", "2"), (0.2, 1.0), (0.1, 1.0)),
        Joint("R", ("2", "3"), (0.25, 1.5)),
        Joint("P", ("3", "0"), (0.25, 2.0), (0, 1)),
    ]
    counts, moved = given["cam_follower"], plane("0123", cam)
    assert (moved.moving, moved.classes) == (counts["moving_links"], {5: counts["p5"], 4: counts["p4"]})
    return {
        "F": planar_mobility(given["moving_links"], given["p5_simple"]),
        "F_cam_with_roller": moved.true,
        "F_cam_locked_roller": (moved.true or 0) - local_freedoms("0123", cam)["2"],
    }


def third_crank(given: Inputs) -> Outputs:
    x, y = cos(1.0), sin(1.0)
    cranks = zip(((0, 0), (3, 0), (1.5, 0)), "134", strict=True)
    joints = [
        Joint("R", (link, end), (a + dx, b + dy))
        for (a, b), link in cranks
        for end, dx, dy in (("0", 0.0, 0.0), ("2", x, y))
    ]
    found = plane("01234", joints)
    assert (found.moving, found.classes[5], found.passive) == (
        given["moving_links"], given["p5"], given["passive_constraints"],
    )  # fmt: skip
    on_the_frame = 2 * 3  # equations of the three frame pivots: they leave one angle to each crank
    return {
        "F_formal": found.formula,
        "F_real": found.true,
        "rank_of_6_constraints": (found.rank or 0) - on_the_frame,
    }


def loops_of_a_graph(given: Inputs) -> Outputs:
    pairs = [Pair(*ends) for ends in SIX_LINKS]
    assert (len(pairs), len({link for ends in SIX_LINKS for link in ends})) == (
        given["pairs"], given["links_with_frame"],
    )  # fmt: skip
    loops = count_loops(pairs)
    return {"loops": loops, "sum_f": len(pairs), "F_planar": len(pairs) - 3 * loops}


def groups(given: Inputs) -> Outputs:
    pairs = [Pair(str(one), str(other)) for one, other in given["joints"]]
    found = decompose(pairs, [str(given["driver"])])
    moving = len({link for ends in given["joints"] for link in ends}) - 1
    return {
        "groups": [sorted(map(int, group.links)) for group in found.groups],
        "group_classes": [group.klass for group in found.groups],
        "mechanism_class": found.klass,
        "F": planar_mobility(moving, len(pairs)),
    }


def seven_revolutes(given: Inputs) -> Outputs:
    assert given["word"] == "7R, space"
    directions = (AHEAD, UPRIGHT, AHEAD, UPRIGHT, AHEAD, UPRIGHT, ACROSS)
    arm = [Axis("R", direction, (i * i / 3, i % 3 / 2, i / 3)) for i, direction in enumerate(directions)]
    assert spare_freedoms(arm) == manoeuvrability(len(arm))
    return {"W": len(arm), "tip_freedom": tip_freedom(arm), "manoeuvrability": manoeuvrability(len(arm))}


SOLVED: dict[str, Solve] = {
    "STR-2": two_spheres,
    "STR-3": six_links,
    "STR-4": cam_with_a_roller,
    "STR-5": third_crank,
    "STR-6": loops_of_a_graph,
    "STR-8": groups,
    "STR-9": seven_revolutes,
}
