"""The catalogue over HTTP, in the reader's language and in parts."""

from __future__ import annotations

import pytest
from starlette.testclient import TestClient

from exercises import catalogue
from exercises.presenting import words_of


def test_the_catalogue_lists_every_exercise(client: TestClient) -> None:
    body = client.get("/api/v1/exercises").json()
    assert [one["id"] for one in body["exercises"]] == list(catalogue.ids())
    assert body["next"] is None
    crank = next(one for one in body["exercises"] if one["id"] == "slider_crank")
    assert crank["chapter"] == "linkages" and crank["systems"] == ["VP-2"]
    assert crank["answers"]["omega2_formula"] == {"kind": "expression"}
    assert crank["languages"] == ["pl", "en", "ru"]


@pytest.mark.parametrize("language", ["pl", "en", "ru"])
def test_an_exercise_is_described_in_the_reader_s_language(client: TestClient, language: str) -> None:
    body = client.get(f"/api/v1/exercises/slider_crank?lang={language}").json()
    assert body["title"] == words_of("slider_crank", language)["title"]


def test_the_parts_of_the_catalogue_are_the_catalogue(client: TestClient) -> None:
    path, found = "/api/v1/exercises?limit=1", []
    while path:
        body = client.get(path).json()
        found += [one["id"] for one in body["exercises"]]
        path = body["next"]
    assert found == list(catalogue.ids())


def test_a_chapter_lists_its_own(client: TestClient) -> None:
    found = client.get("/api/v1/exercises?chapter=linkages").json()["exercises"]
    assert {one["chapter"] for one in found} == {"linkages"}
    assert client.get("/api/v1/exercises?chapter=none").json() == {"exercises": [], "next": None}


@pytest.mark.parametrize("query", ["limit=0", "limit=101", "limit=x", "chapter=" + "x" * 41])
def test_a_bad_query_is_refused(client: TestClient, query: str) -> None:
    reply = client.get(f"/api/v1/exercises?{query}")
    assert reply.status_code == 422
    assert reply.json()["error"]["field"] == query.split("=")[0]


def test_the_interface_describes_itself_without_answers(client: TestClient) -> None:
    described = client.get("/api/v1/openapi.json").json()
    assert "/api/v1/variants/{variant}/submissions" in described["paths"]
    assert not [path for path in described["paths"] if path.startswith("/variants")]
