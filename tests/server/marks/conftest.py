"""The school of the task sets, shared by the tests of marks."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from server.settings import Settings
from tests.server.conftest import SECRET
from tests.server.sets.conftest import Course, made
from tests.server.stores import lay


@pytest.fixture(scope="package")
def course(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Course]:
    """A school with small decks."""
    settings = Settings(tmp_path_factory.mktemp("school"), secret=SECRET, limited=False)
    lay(settings)
    yield from made(settings)
