"""What the sets of a course add up to: a set and its second chance count once, weighed."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from server.marks.gradebook import Gradebook, Row
from server.sets.handing import rules_of


@dataclass(frozen=True, slots=True)
class Total:
    """A student in all sets of a course; `weighed` is what second chances change of the points of the first ones."""

    rows: tuple[Row, ...]
    points: float
    weighed: float


@dataclass(frozen=True, slots=True)
class Totals:
    """The students of a course in the order of its gradebooks, and the points that can be reached.

    `firsts` are the places of the sets that are no second chance to another; `chances` tells whether there are others.
    """

    firsts: tuple[int, ...]
    worth: float
    chances: bool
    students: tuple[Total, ...]


def totals(books: Sequence[Gradebook]) -> Totals:
    """Add up the gradebooks of a course, which list the same students in the same order."""
    chances = _chances(books)
    again = {number for numbers in chances.values() for number in numbers}
    firsts = tuple(number for number in range(len(books)) if number not in again)
    worth = sum(books[number].worth for number in firsts)
    rows = zip(*(book.rows for book in books), strict=True)
    return Totals(firsts, worth, bool(again), tuple(_total(books, firsts, chances, own) for own in rows))


def _chances(books: Sequence[Gradebook]) -> dict[int, list[int]]:
    """Give the places of the second chances to each set that is there."""
    places = {book.task_set.id: number for number, book in enumerate(books)}
    found: dict[int, list[int]] = {}
    for number, book in enumerate(books):
        first = places.get(rules_of(book.task_set).second_chance_of or "")
        if first is not None:
            found.setdefault(first, []).append(number)
    return found


def _total(
    books: Sequence[Gradebook], firsts: Sequence[int], chances: dict[int, list[int]], own: tuple[Row, ...]
) -> Total:
    plain = sum(own[number].points for number in firsts)
    points = sum(_points(books[one], own[one], [own[n] for n in chances.get(one, ())]) for one in firsts)
    return Total(own, round(points, 3), round(points - plain, 3))


def _points(book: Gradebook, row: Row, chances: Sequence[Row]) -> float:
    """Give the points of a set with the best second chance that was taken; its share is weighed already."""
    shares = [chance.share for chance in chances if chance.taken]
    return max(shares) * book.worth if shares else row.points
