"""Equations, systems and inequalities of a request."""

from __future__ import annotations

from dataclasses import replace

from graders.comparison.outcome import Answer, Why, different, of_solutions
from graders.comparison.request import Request
from graders.comparison.texts import trees
from graders.language.tree import Relation
from graders.solutions.equations import compare_equations
from graders.solutions.inequalities import compare_inequalities, is_inequality
from graders.solutions.reduction import is_equation
from graders.solutions.scene import Scene, scene_of
from graders.solutions.systems import compare_systems


def scene(request: Request, secret: bytes) -> Scene:
    """Give the box of a request with points in it."""
    made = scene_of(tuple(request.box), tuple(request.box.values()), secret)
    return replace(made, lines=tuple(request.fixed.items())) if request.fixed else made


def compare_equation(request: Request, secret: bytes) -> Answer:
    """Compare the solutions of two equations."""
    (a,), (b,) = trees(request)
    if not (isinstance(a, Relation) and isinstance(b, Relation) and is_equation(a) and is_equation(b)):
        return different(Why.SHAPE)
    return of_solutions(compare_equations(b, a, scene(request, secret), request.solve_for[0]))


def compare_system(request: Request, secret: bytes) -> Answer:
    """Compare the solutions of two systems of equations."""
    sides = [[tree for tree in side if isinstance(tree, Relation) and is_equation(tree)] for side in trees(request)]
    if [len(side) for side in sides] != [len(request.a), len(request.b)]:
        return different(Why.SHAPE)
    if len(sides[0]) != len(sides[1]):
        return different(Why.COUNT)
    if not sides[0]:
        return different(Why.SHAPE)
    return of_solutions(compare_systems(sides[1], sides[0], scene(request, secret), request.solve_for))


def compare_inequality(request: Request, secret: bytes) -> Answer:
    """Compare where two inequalities hold."""
    (a,), (b,) = trees(request)
    if not (isinstance(a, Relation) and isinstance(b, Relation) and is_inequality(a) and is_inequality(b)):
        return different(Why.SHAPE)
    return of_solutions(compare_inequalities(b, a, scene(request, secret)))
