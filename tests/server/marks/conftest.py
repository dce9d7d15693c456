"""The school of the task sets, shared by the tests of marks."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from tests.conftest import Laid, laying
from tests.server.conftest import SECRET
from tests.server.sets.conftest import Course, made
from tests.server.stores import Postgres


@pytest.fixture(scope="package")
def laid_for_all(chosen: Postgres | None) -> Iterator[Laid]:
    """Makes the settings of a server, with an empty store that the tests of this package share."""
    yield from laying(chosen)


@pytest.fixture(scope="package")
def course(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[Course]:
    """A school with small decks."""
    yield from made(laid_for_all(tmp_path_factory.mktemp("school"), secret=SECRET, limited=False))
