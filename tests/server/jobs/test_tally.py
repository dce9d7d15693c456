"""A tally is read on one side while it is counted on the other, and tells the other when nobody listens."""

from __future__ import annotations

import asyncio
import pickle
import tempfile

import pytest

from server.jobs.tally import tallied
from server.judging.thread import JudgingThread
from server.storage.jobs import Fenced
from tests.server.jobs.counting import compute_in_parts


def test_what_is_told_on_one_side_is_read_on_the_other() -> None:
    with tallied() as tally:
        other = pickle.loads(pickle.dumps(tally))
        assert tally.read() == 0
        for reached in (1, 300, 70_000):
            other(reached)
            assert tally.read() == reached


def test_a_machine_without_a_folder_for_passing_files_counts_as_well(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tempfile, "_candidate_tempdir_list", lambda: ["/nowhere"])
    monkeypatch.setattr(tempfile, "tempdir", None)
    with pytest.raises(FileNotFoundError):
        tempfile.gettempdir()
    with tallied() as tally:
        tally(3)
        assert tally.read() == 3


def test_a_process_of_its_own_counts_for_the_one_that_waits() -> None:
    judging = JudgingThread(1)
    with tallied() as tally:
        asyncio.run(judging.apart(compute_in_parts, [(b"", 7, tally)]))
        assert tally.read() == 7
    judging.close()


def test_who_counts_for_nobody_gives_up() -> None:
    with tallied() as tally:
        tally.drop()
        with pytest.raises(Fenced, match="part 2"):
            tally(2)
    with tallied() as tally:
        other = tally
    with pytest.raises(Fenced):
        other(1)
