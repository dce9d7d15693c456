"""One variant to attack, the time an attack takes, and a server of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from starlette.testclient import TestClient

from exercises.exercise import Submission
from exercises.grading import grade
from exercises.variants import deal
from graders import Verdict
from server.app import create_app
from tests.conftest import Laid
from tests.graders.effort import effort
from tests.server.school import School, opened
from tests.server.sets.conftest import Course, made

Attack = Callable[..., Verdict]
VARIANT = deal("slider_crank", 7)
SECRET = b"only the server knows it"
LONGEST = 0.5  # s of computing an attack may cost; ten times the promise, for a machine that does other work as well


@pytest.fixture
def attack() -> Attack:
    """Hand in one text for one answer; gives its verdict, and fails when it costs too much."""

    def handed_in(text: str, answer: str = "omega2_formula") -> Verdict:
        verdicts: list[Verdict] = []
        cost = effort(lambda: verdicts.append(grade(Submission(VARIANT, {answer: text}), SECRET).verdicts[answer]), 1)
        assert cost < LONGEST
        return verdicts[0]

    return handed_in


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[Course]:
    """A course whose lecturer builds sets."""
    yield from made(laid_for_all(tmp_path_factory.mktemp("school"), secret=SECRET, limited=False))


@pytest.fixture
def client(tmp_path: Path, laid: Laid) -> Iterator[TestClient]:
    """A client of a server in this process that knows one variant."""
    settings = laid(tmp_path, secret=SECRET)
    with TestClient(create_app(settings), raise_server_exceptions=False) as found:
        reply = found.post("/api/v1/exercises/slider_crank/variants", json={"seed": 7})
        found.headers["x-variant"] = reply.json()["id"]
        yield found


@pytest.fixture
def school(tmp_path: Path, laid: Laid) -> Iterator[School]:
    """A server with a course and somebody of every role."""
    with opened(laid(tmp_path, secret=b"a secret of the tests")) as found:
        yield found
