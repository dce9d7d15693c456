"""The catalogue is narrowed by chapter, by words and by how one answers; the three go together."""

from __future__ import annotations

import re
from html import unescape

from starlette.testclient import TestClient

from exercises import catalogue
from exercises.solving import solved
from exercises.variants import deal
from graders import KINDS
from server.catalogue.shelf import WAYS


def listed(client: TestClient, query: str) -> set[str]:
    page = client.get(f"/?lang=en&{query}").text
    return set(re.findall(r'<h3><a href="/exercises/(\w+)">', page))


def asked(way: str) -> set[str]:
    """The exercises with an answer of a way, by their own list of answers."""
    answers = {one: solved(deal(one, 7)).answers for one in catalogue.ids()}
    return {one for one, judges in answers.items() if any(judge.kind in WAYS[way] for judge in judges.values())}


def test_every_kind_of_answer_is_of_one_way() -> None:
    assert sorted(kind for kinds in WAYS.values() for kind in kinds) == sorted(KINDS)


def test_one_way_or_another_is_enough(client: TestClient) -> None:
    assert listed(client, "answer=diagram") == asked("diagram") != set()
    both = listed(client, "answer=diagram&answer=polygon")
    assert both == asked("diagram") | asked("polygon")
    assert listed(client, "answer=nonsense") == set(catalogue.ids())


def test_chapter_words_and_ways_go_together_and_are_kept(client: TestClient) -> None:
    query = "chapter=linkages&q=slider&answer=polygon&answer=matrix"
    assert listed(client, query) == {"slider_crank_polygon"}
    page = unescape(client.get(f"/?{query}").text)
    assert page.count(" checked>") == 2 and 'value="slider"' in page
    assert 'href="/?q=slider&answer=polygon&answer=matrix&chapter=manipulators"' in page
    assert 'href="/?chapter=linkages&q=slider&answer=polygon&answer=matrix&lang=pl"' in page


def test_a_chapter_and_a_way_say_how_many_there_are(client: TestClient) -> None:
    page = client.get("/?lang=en&answer=diagram").text
    counts = dict(re.findall(r"[&?;]chapter=(\w+)\"[^>]*>[^<]*</a><span>(\d+)</span>", page))
    assert counts["strength"] == str(len(asked("diagram"))) and counts["manipulators"] == "0"
    ways = dict(re.findall(r'name="answer" value="(\w+)"[^>]*>[^<]*</label><span[^>]*>(\d+)<', page))
    assert ways["number"] == str(len(asked("number"))) and ways["diagram"] == counts["strength"]


def test_the_shortest_exercises_come_first_where_that_is_wished(client: TestClient) -> None:
    page = unescape(client.get("/?lang=en&chapter=strength&order=time").text)
    listed = re.findall(r'<h3><a href="/exercises/(\w+)">', page)
    minutes = [catalogue.load(one).exercise.minutes for one in listed]
    assert minutes == sorted(minutes) and len(set(minutes)) > 1
    assert set(listed) == {one for one in catalogue.ids() if catalogue.load(one).chapter == "strength"}
    assert 'name="order" value="time"' in page  # a search keeps the order
    assert 'href="/?lang=en&chapter=strength&order="' in page  # and the way back to the chapters' own


def test_the_order_of_the_chapters_is_kept_where_nothing_else_is_wished(client: TestClient) -> None:
    for query in ("", "&order=nonsense"):
        page = client.get(f"/?lang=en{query}").text
        assert re.findall(r'<h3><a href="/exercises/(\w+)">', page) == list(catalogue.ids())
