"""`solve mobility`: counts of a mechanism, and its true mobility where it is drawn (`mechanics.mobility`)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from mechanics.mobility import PLANAR, Joint, Mobility, plane, space
from mechanics.structure import CLASSES, spatial_mobility
from mechanics.wire.fields import Choice, ListOf, Number, Record, Tagged, Text, Whole
from mechanics.wire.refusal import Refusal

FARTHEST = 1e6  # m
PLANAR_LINKS, SPATIAL_LINKS = 24, 12  # with the frame
PAIRS = 2 * PLANAR_LINKS


def _vector(doc: str, unit: str, size: int) -> ListOf:
    number = Number("", unit, least=-FARTHEST, most=FARTHEST)
    return ListOf(doc, number, default=None, least=size, most=size)


REQUEST = Tagged(
    'The link "0" is the frame. Where every joint has its place, the drawn position also answers how it moves.',
    "kind",
    {
        "planar": Record(
            "F = 3n - 2 p5 - p4",
            {
                "links": ListOf('all links, the frame "0" among them', Text(""), least=1, most=PLANAR_LINKS),
                "joints": ListOf(
                    f"joints; one that names n links counts n - 1 pairs, of which there are at most {PAIRS}",
                    Record(
                        "",
                        {
                            "type": Choice("R turning, P sliding, H higher pair of curvature zero", tuple(PLANAR)),
                            "links": ListOf("links that meet", Text(""), least=2, most=PLANAR_LINKS),
                            "at": _vector("place; of a higher pair the point of contact", "m", 2),
                            "dir": _vector("guide of P, common normal of H", "", 2),
                        },
                    ),
                    most=PAIRS,
                ),
            },
        ),
        "spatial": Record(
            "F = 6n - 5 p5 - 4 p4 - 3 p3 - 2 p2 - p1; the chain is connected",
            {
                "N_moving": Whole("moving links n", 1, 1000),
                "joints": ListOf(
                    "pairs: R turning, P sliding, H screw, C cylindrical, U universal, S spherical, E plane on plane, "
                    "L cylinder on plane, B ball on plane",
                    Choice("", tuple(CLASSES)),
                    most=1000,
                ),
                "axes": ListOf(
                    "where the pairs are, in the order of joints",
                    Record(
                        "",
                        {
                            "links": ListOf('the two links, named "0" (frame) to the number of moving links', Text(""),
                                            least=2, most=2),
                            "at": _vector("a point of the axis; the centre of U, S, B", "m", 3),
                            "dir": _vector("axis; normal of the plane for E, L, B", "", 3),
                            "dir2": _vector("axis of U on the second link; else one across dir", "", 3),
                            "pitch": Number("advance of H in a turn", "m", default=0.0, least=-FARTHEST, most=FARTHEST),
                        },
                    ),
                    default=None,
                    most=2 * SPATIAL_LINKS,
                ),
            },
        ),
    },
)  # fmt: skip

ANSWER = {
    "N_moving": "moving links",
    **{f"p{klass}": f"pairs of class {klass}, which remove {klass} of the six freedoms; only where there are any"
       for klass in (5, 4, 3, 2, 1)},
    "F_formula": "mobility by the formula",
    "independent_loops": "pairs - all links + 1",
    "instantaneous_dof": "free directions at the drawn position",
    "true_dof": "freedoms after finite steps along them",
    "passive_constraints": "true_dof - F_formula",
}  # fmt: skip

EXAMPLE = {
    "kind": "planar",
    "links": ["0", "1", "2", "3", "4"],
    "joints": [
        {"type": "R", "links": ["0", "1"], "at": [0, 0]},
        {"type": "R", "links": ["1", "2"], "at": [0.3, 0.4]},
        {"type": "R", "links": ["2", "3"], "at": [1.5, 0.4]},
        {"type": "R", "links": ["3", "0"], "at": [1.2, 0]},
        {"type": "R", "links": ["0", "4"], "at": [0.6, 0]},
        {"type": "R", "links": ["4", "2"], "at": [0.9, 0.4]},
    ],
}


def solve(request: Mapping[str, Any]) -> dict[str, Any]:
    """Count the mobility; raises ValueError."""
    if request["kind"] == "planar":
        _require_few(request["joints"])
        joints = [Joint(one["type"], one["links"], one["at"], one["dir"]) for one in request["joints"]]
        return _answer(plane(request["links"], joints))
    moving, kinds = request["N_moving"], request["joints"]
    if len(kinds) < moving:
        said = f"{len(kinds)} joints do not connect {moving} moving links to the frame"
        raise Refusal("out_of_range", said, "joints")
    if request["axes"] is None:
        classes = {klass: count for klass in CLASSES.values() if (count := sum(CLASSES[k] == klass for k in kinds))}
        return _answer(Mobility(moving, classes, spatial_mobility(moving, classes), len(kinds) - moving))
    return _answer(_drawn(moving, kinds, request["axes"]))


def _require_few(joints: tuple[Mapping[str, Any], ...]) -> None:
    pairs = sum(len(one["links"]) - 1 for one in joints)
    if pairs > PAIRS:
        raise Refusal("out_of_range", f"the joints count {pairs} pairs; there are at most {PAIRS}", "joints")


def _drawn(moving: int, kinds: tuple[str, ...], axes: tuple[Mapping[str, Any], ...]) -> Mobility:
    if len(axes) != len(kinds):
        raise Refusal("contradictory", f"{len(axes)} axes for {len(kinds)} joints", "axes")
    if moving >= SPATIAL_LINKS:
        said = f"N_moving = {moving}: with axes there are at most {SPATIAL_LINKS - 1} moving links"
        raise Refusal("out_of_range", said, "N_moving")
    joints = [
        Joint(kind, one["links"], one["at"], one["dir"], one["dir2"], one["pitch"])
        for kind, one in zip(kinds, axes, strict=True)
    ]
    return space([str(link) for link in range(moving + 1)], joints)


def _answer(found: Mobility) -> dict[str, Any]:
    counted = {
        "N_moving": found.moving,
        **{f"p{klass}": found.classes[klass] for klass in sorted(found.classes, reverse=True)},
        "F_formula": found.formula,
        "independent_loops": found.loops,
    }
    if found.true is None:
        return counted
    moved = {"instantaneous_dof": found.instantaneous, "true_dof": found.true}
    return {**counted, **moved, "passive_constraints": found.passive}
