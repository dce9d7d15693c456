"""Random gear trains and drawn structures, many of them inconsistent, loose or nearly singular."""

from __future__ import annotations

from math import cos, pi, sin
from random import Random

from mechanics.bevel_differential import Differential
from mechanics.gear_pair import MeshType
from mechanics.gear_train import Mesh, Train
from mechanics.mobility import Joint

KINDS: tuple[MeshType, MeshType] = ("external", "internal")
NEAR = (0.0, 1e-12, 1e-9, 1e-6, 1e-3)  # m, by which a special position is missed


def train(chance: Random) -> Train:
    """Draw any train: wheels, carriers and differentials at random."""
    members = tuple(str(i) for i in range(chance.randint(2, 8)))
    meshes = tuple(_mesh(chance, members) for _ in range(chance.randint(0, len(members))))
    both = [chance.sample(members, 3) for _ in range(chance.randint(0, 1))] if len(members) > 2 else []
    return Train(
        members=members,
        meshes=meshes,
        fixed=tuple(chance.sample(members, chance.randint(0, 1))),
        input_omega={
            member: chance.choice((0, 1, 100, -7.5, 0.1)) for member in chance.sample(members, chance.randint(1, 2))
        },
        output=chance.choice((*members, None)),
        differentials=tuple(Differential(*three) for three in both),
    )


def _mesh(chance: Random, members: tuple[str, ...]) -> Mesh:
    one, other, *rest = chance.sample(members, min(3, len(members)))
    carrier = chance.choice((None, *rest))
    return Mesh(one, other, chance.randint(8, 200), chance.randint(8, 200), chance.choice(KINDS), carrier)


def structure(chance: Random) -> tuple[list[str], list[Joint]]:
    """Draw a crank with dyads hung on it and perhaps a bar too many, some of it in line or parallel, or nearly so."""
    links, joints, free = ["0", "1"], [_pin(chance, "0", "1", (0.0, 0.0))], [("1", _place(chance))]
    for _ in range(chance.randint(1, 3)):
        one, other = str(len(links)), str(len(links) + 1)
        (on, at), corner, end = chance.choice(free), _place(chance), _place(chance)
        if chance.random() < 0.4:  # in line: a dead position
            end = (2 * corner[0] - at[0] + chance.choice(NEAR), 2 * corner[1] - at[1])
        joints += [_pin(chance, on, one, at), _pin(chance, one, other, corner), _last(chance, other, end)]
        links += [one, other]
        free += [(one, _place(chance)), (other, _place(chance))]
    if chance.random() < 0.3:
        links.append(str(len(links)))
        joints += [_pin(chance, links[-1], on, place) for on, place in chance.sample([("0", _place(chance)), *free], 2)]
    return links, joints


def _place(chance: Random) -> tuple[float, float]:
    angle, far = (
        chance.choice((0.0, pi / 2, chance.uniform(-pi, pi))),
        chance.choice((0.5, 1.0, chance.uniform(0.1, 3))),
    )
    return far * cos(angle), far * sin(angle)


def _pin(chance: Random, one: str, other: str, at: tuple[float, float]) -> Joint:
    return Joint("R", (one, other), at)


def _last(chance: Random, link: str, at: tuple[float, float]) -> Joint:
    kind = chance.choice("RRRPH")
    return Joint(kind, (link, "0"), at, (1.0, chance.choice((0.0, 1.0, chance.uniform(-1, 1)))))
