"""Judging in a process of its own: in order, whatever the judge dies of."""

from __future__ import annotations

import asyncio
import os
import signal
import subprocess
import sys
import time
from collections.abc import Awaitable, Callable, Sequence
from multiprocessing.context import SpawnProcess
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import httpx2
import pytest

from exercises import grading
from exercises.exercise import Submission
from exercises.grading import UnknownAnswer
from exercises.variants import deal
from server.judging import process
from server.judging.judging import JudgingEnded
from server.judging.process import JudgingProcess
from server.web import logs
from tests.server.conftest import Live
from tests.server.judging.killed import outlived
from tests.server.judging.tasks import (
    be_told_to_end,
    die,
    die_once,
    interrupt,
    make_unreadable,
    note,
    raise_stubborn,
)

T = TypeVar("T")


def with_judge(ask: Callable[[JudgingProcess], Awaitable[T]]) -> T:
    """Ask a judge something, and end it."""

    async def asked() -> T:
        judging = JudgingProcess(1)
        try:
            return await ask(judging)
        finally:
            judging.close()

    return asyncio.run(asked())


def test_all_is_computed_in_one_process_beside_this_one_in_the_order_asked() -> None:
    async def ask(judging: JudgingProcess) -> list[Any]:
        judging.begin()
        return await asyncio.gather(
            *(judging.run(pow, 2, n) for n in range(50)), judging.run(os.getpid), judging.run(os.getppid)
        )

    *powers, own, parent = with_judge(ask)
    assert powers == [2**n for n in range(50)] and own != parent == os.getpid()


def test_what_the_judge_raises_is_raised_here() -> None:
    variant = deal("slider_crank", 7)

    async def ask(judging: JudgingProcess) -> Sequence[Any]:
        unknown = judging.grade(Submission(variant, {"zz": "1"}), b"")
        return await asyncio.gather(
            unknown, judging.run(raise_stubborn), judging.run(pow, 2, 3), return_exceptions=True
        )

    unknown, stubborn, power = with_judge(ask)
    assert isinstance(unknown, UnknownAnswer) and str(unknown) == "zz"
    assert isinstance(stubborn, RuntimeError) and str(stubborn) == "Stubborn"
    assert power == 8


def test_a_grade_is_the_one_that_is_made_here() -> None:
    task = Submission(deal("slider_crank", 7), {"l3": "-1 mm", "v3": "1,2 m/", "omega2_formula": "omega1"})
    assert with_judge(lambda judging: judging.grade(task, b"secret")) == grading.grade(task, b"secret")


def test_a_task_over_which_a_judge_ends_is_told_to_another_with_all_that_waits(tmp_path: Path) -> None:
    async def ask(judging: JudgingProcess) -> list[Any]:
        first = await judging.run(os.getpid)
        waiting = (judging.run(pow, 3, n) for n in range(20))
        return [first, *await asyncio.gather(judging.run(die_once, str(tmp_path / "flag")), *waiting)]

    first, second, *powers = with_judge(ask)
    assert first != second and powers == [3**n for n in range(20)]


def test_a_task_that_ends_two_judges_is_given_up_alone(caplog: pytest.LogCaptureFixture) -> None:
    async def ask(judging: JudgingProcess) -> Sequence[Any]:
        return await asyncio.gather(judging.run(die), judging.run(pow, 3, 2), return_exceptions=True)

    ended, power = with_judge(ask)
    assert isinstance(ended, JudgingEnded) and power == 9
    assert [record.args for record in caplog.records if record.name == "grubler"] == [(1, 2), (2, 2)]


def test_a_grade_that_ends_judges_costs_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(process, "graded", die)
    task = Submission(deal("slider_crank", 7), {"l3": "1 m"})
    assert with_judge(lambda judging: judging.grade(task, b"")) == grading.failed(task)


def test_a_task_that_takes_too_long_is_ended() -> None:
    async def ask(judging: JudgingProcess) -> list[Any]:
        await judging.run(os.getpid)
        judging.longest = 0.2
        slow = asyncio.create_task(judging.run(time.sleep, 600))
        await asyncio.wait([slow])
        judging.longest = process.LONGEST
        return [slow.exception(), await judging.run(pow, 2, 2)]

    ended, power = with_judge(ask)
    assert isinstance(ended, JudgingEnded) and power == 4


def test_a_judge_that_ends_with_nothing_to_do_is_nobody_s_loss() -> None:
    async def ask(judging: JudgingProcess) -> list[int]:
        first = await judging.run(os.getpid)
        os.kill(first, signal.SIGKILL)
        return [first, *await asyncio.gather(*(judging.run(os.getpid) for _ in range(3)))]

    first, *others = with_judge(ask)
    assert len(set(others)) == 1 and first not in others


def test_somebody_who_no_longer_waits_holds_nobody_up() -> None:
    async def ask(judging: JudgingProcess) -> int:
        gone = asyncio.create_task(judging.run(pow, 2, 2))
        await asyncio.sleep(0)
        gone.cancel()
        return await judging.run(pow, 2, 3)

    assert with_judge(ask) == 8


def test_an_interrupt_at_the_keyboard_is_the_server_s_to_heed() -> None:
    async def ask(judging: JudgingProcess) -> tuple[int, int]:
        return await judging.run(interrupt), await judging.run(os.getpid)

    before, after = with_judge(ask)
    assert before == after


def test_the_judge_of_a_group_that_is_told_to_end_goes_on_until_the_server_ends() -> None:
    async def ask(judging: JudgingProcess) -> tuple[int, int]:
        return await judging.run(be_told_to_end), await judging.run(os.getpid)

    before, after = with_judge(ask)
    assert before == after


def test_what_cannot_be_read_here_fails_for_the_one_who_asked() -> None:
    async def ask(judging: JudgingProcess) -> Sequence[Any]:
        both = asyncio.gather(judging.run(make_unreadable), judging.run(pow, 2, 3), return_exceptions=True)
        return await asyncio.wait_for(both, 30)

    unreadable, power = with_judge(ask)
    assert isinstance(unreadable, ValueError) and power == 8


def test_the_log_tells_where_the_judge_has_raised_and_not_its_words() -> None:
    async def ask(judging: JudgingProcess) -> Sequence[Any]:
        return await asyncio.gather(judging.run(int, "typed"), judging.run(raise_stubborn), return_exceptions=True)

    wrong, stubborn = (logs.place(error) for error in with_judge(ask))
    assert "judge.py" in wrong and wrong.endswith("\nValueError") and "typed" not in wrong
    assert "in raise_stubborn" in stubborn and stubborn.endswith("\nStubborn")


def test_what_the_judge_notes_names_the_request(capfd: pytest.CaptureFixture[str]) -> None:
    async def ask(judging: JudgingProcess) -> None:
        token = logs.REQUEST.set("request-7")
        await judging.run(note, "something odd")
        logs.REQUEST.reset(token)
        await judging.run(note, "something else")

    with_judge(ask)
    assert capfd.readouterr().err.splitlines() == ["request-7 something odd", "something else"]


def test_where_no_judge_can_be_started_all_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse() -> NoReturn:
        raise OSError("too many open files")

    async def ask(judging: JudgingProcess) -> list[Any]:
        monkeypatch.setattr(process, "socketpair", refuse)
        refused = await asyncio.gather(judging.run(pow, 2, 2), judging.run(pow, 2, 3), return_exceptions=True)
        monkeypatch.undo()
        return [*refused, await judging.run(pow, 2, 4)]

    *refused, power = with_judge(ask)
    assert [type(error) for error in refused] == [JudgingEnded, JudgingEnded] and power == 16


def test_a_server_whose_judge_no_process_could_be_made_for_still_closes(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(process: object) -> NoReturn:
        raise BlockingIOError("no more processes")

    async def ask(judging: JudgingProcess) -> Sequence[Any]:
        return await asyncio.gather(judging.run(pow, 2, 2), return_exceptions=True)

    monkeypatch.setattr(SpawnProcess, "start", refuse)
    (refused,) = with_judge(ask)
    assert isinstance(refused, JudgingEnded)


def test_what_waits_when_the_server_ends_is_let_go() -> None:
    async def ask(judging: JudgingProcess) -> bool:
        await judging.run(os.getpid)
        waiting = asyncio.create_task(judging.run(time.sleep, 600))
        await asyncio.sleep(0)
        judging.close()
        await asyncio.wait([waiting])
        return waiting.cancelled()

    assert with_judge(ask)


PROGRAM = """
import asyncio, os, sys, time
from server.judging.process import JudgingProcess

async def main():
    judging = JudgingProcess(1)
    print(await judging.run(os.getpid), flush=True)
    await judging.run(time.sleep, 600)

if __name__ == "__main__":
    asyncio.run(main())
"""


def test_a_judge_ends_with_a_server_that_is_killed_whatever_it_computes() -> None:
    assert outlived(PROGRAM) == b""


LEAVING = """
import asyncio, os, time
from server.judging.process import JudgingProcess

async def main():
    judging = JudgingProcess(1)
    await judging.run(os.getpid)
    waiting = asyncio.create_task(judging.run(time.sleep, 600))
    await asyncio.sleep(0.2)

if __name__ == "__main__":
    asyncio.run(main())
"""


def test_a_server_that_leaves_without_closing_waits_for_no_judge() -> None:
    assert subprocess.run([sys.executable, "-c", LEAVING], timeout=60).returncode == 0


def children(parent: int) -> list[int]:
    """Give the numbers of the processes that a process has started."""
    return [int(number) for number in Path(f"/proc/{parent}/task/{parent}/children").read_text().split()]


def test_a_student_does_not_notice_that_the_judge_of_a_server_is_killed(live: Live) -> None:
    answers = grading.reference(deal("slider_crank", 7))
    scores = []
    with httpx2.Client(base_url=live.url, timeout=60) as student:
        for _ in range(3):
            dealt = student.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7}).json()
            assert live.process is not None
            for child in children(live.process.pid):
                os.kill(child, signal.SIGKILL)
            reply = student.post(f"/api/v1/variants/{dealt['id']}/submissions", json={"answers": answers})
            scores.append((reply.status_code, reply.json()["score"]))
    assert scores == [(201, 1.0)] * 3
