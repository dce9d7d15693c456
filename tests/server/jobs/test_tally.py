"""A tally is read on one side while it is counted on the other, and tells the other when nobody listens."""

from __future__ import annotations

import pickle

import pytest

from server.jobs.tally import tallied
from server.storage.jobs import Fenced


def test_what_is_told_on_one_side_is_read_on_the_other() -> None:
    with tallied() as tally:
        other = pickle.loads(pickle.dumps(tally))
        assert tally.read() == 0
        for reached in (1, 300, 70_000):
            other(reached)
            assert tally.read() == reached


def test_who_counts_for_nobody_gives_up() -> None:
    with tallied() as tally:
        tally.drop()
        with pytest.raises(Fenced, match="part 2"):
            tally(2)
    with tallied() as tally:
        other = tally
    with pytest.raises(Fenced):
        other(1)
