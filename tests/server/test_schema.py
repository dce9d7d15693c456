"""The interface against its own description: whatever fits the schema, or nearly, is answered as it says."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from schemathesis.core import NOT_SET
from starlette.testclient import TestClient

from server.app import create_app
from server.people import tokens
from server.policy import POLICIES
from server.settings import Settings
from tests.conftest import Laid
from tests.depth import amount

SECRET = b"the secret of the schema tests"
ROLES = ("student", "lecturer", "administrator")
EXAMPLES = amount(2, 3)  # of each route
OPEN = ("/api/v1/", "/health", "/ready", "/metrics")
DESCRIPTION = "/api/v1/openapi.json"
ROUTES = sorted(f"{method} {path}" for method, path in POLICIES if path.startswith(OPEN) and path != DESCRIPTION)
ALWAYS = {"401", "403", "404", "405", "413", "415", "422", "429"}  # what any route may answer to a stranger


@lru_cache(maxsize=1)
def described() -> dict[str, Any]:
    """Read every route of the description, by name."""
    with TemporaryDirectory() as folder:
        found = schemathesis.openapi.from_dict(create_app(Settings(Path(folder))).openapi())
    routes: list[Any] = list(found.get_all_operations())
    return {each.ok().label: each.ok() for each in routes}


@pytest.fixture(scope="module")
def client(tmp_path_factory: pytest.TempPathFactory, laid_for_all: Laid) -> Iterator[TestClient]:
    """A server of this module."""
    made = laid_for_all(tmp_path_factory.mktemp("schema"), secret=SECRET, limited=False)
    with TestClient(create_app(made), raise_server_exceptions=False) as found:
        yield found


def ask(client: TestClient, case: Any) -> Any:
    """Send a made-up request as one of the roles."""
    role = ROLES[len(str(case.query)) % len(ROLES)]
    headers = {str(k): str(v) for k, v in (case.headers or {}).items() if str(v).isascii()}
    headers |= {"authorization": f"Bearer {tokens.issue(role, SECRET)}"}
    body: dict[str, Any] = {"json": case.body}
    if case.body is NOT_SET or isinstance(case.body, bytes):
        body = {"content": b"" if case.body is NOT_SET else case.body}
    return client.request(case.method, case.formatted_path, params=case.query, headers=headers, **body)


def test_every_route_of_the_interface_is_described() -> None:
    assert sorted(described()) == ROUTES


@pytest.mark.parametrize("label", ROUTES)
def test_every_route_answers_as_it_is_described(client: TestClient, label: str) -> None:
    route = described()[label]
    documented = set(map(str, route.definition.raw["responses"])) | ALWAYS

    @given(st.one_of(route.as_strategy(), route.as_strategy(schemathesis.GenerationMode.NEGATIVE)))
    @settings(max_examples=EXAMPLES, deadline=None, suppress_health_check=list(HealthCheck), derandomize=True)
    def answered(case: Any) -> None:
        reply = ask(client, case)
        assert str(reply.status_code) in documented, (case.body, reply.text)
        if reply.status_code >= 400:
            assert set(reply.json()) == {"error"}

    answered()
