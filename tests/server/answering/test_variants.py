"""A variant belongs to the one it was dealt to, survives, and is previewed without telling anything."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import asdict
from datetime import UTC, datetime, timedelta
from typing import Any

import pytest
from sqlalchemy import update
from starlette.testclient import TestClient

from exercises import grading, presenting
from exercises.exercise import Variant
from exercises.variants import deal as dealt_by_hand
from server.answering.variants import PRESENTED
from server.app import create_app
from server.database.engine import engine
from server.settings import Settings
from server.tables import variants
from tests.server.stores import everything


def preview(client: TestClient, number: str, answer: str, text: str, language: str = "en") -> dict[str, Any]:
    question = {"answer": answer, "text": text}
    reply = client.post(f"/api/v1/variants/{number}/preview?lang={language}", json=question)
    assert reply.status_code == 200, reply.text
    body: dict[str, Any] = reply.json()
    return body


def change(settings: Settings, **values: Any) -> None:
    store = engine(settings.store_url, connections=1, begin="BEGIN IMMEDIATE")
    with store.begin() as connection:
        connection.execute(update(variants).values(**values))
    store.dispose()


def test_a_variant_shows_all_that_is_needed_to_answer(client: TestClient) -> None:
    reply = client.post("/api/v1/exercises/slider_crank/variants?lang=pl", json={"seed": 7})
    body = reply.json()
    assert reply.headers["location"] == f"/api/v1/variants/{body['id']}"
    assert (body["exercise"], body["version"], body["seed"]) == ("slider_crank", 1, 7)
    assert "<math>" in body["statement"] and "<" not in body["statement_text"]
    assert body["figure"].startswith("<svg") and body["figure_table"]["rows"]
    assert body["answers"]["l3"]["unit"] == "mm" and body["answers"]["l3"]["tolerance"] == "±0,5 %"
    assert "l1" in body["answers"]["omega2_formula"]["symbols"]
    assert [(one["name"], one["value"]) for one in body["data"]][:2] == [
        ("długość korby", "45\u202fmm"),
        ("długość łącznika", "220\u202fmm"),
    ]


def test_a_card_written_before_the_givens_had_names_is_still_shown() -> None:
    shown = asdict(presenting.presented(dealt_by_hand("slider_crank", 7), "en"))
    named, nameless = (PRESENTED.validate_python(card) for card in (dict(shown), shown | {"givens_named": ()}))
    del shown["givens_named"]
    assert PRESENTED.validate_python(shown) == nameless
    assert next(name for name, _, _ in named.data) == "length of the crank"
    assert [("", *given) for given in named.givens] == list(nameless.data)


def test_the_same_seed_gives_the_same_givens(client: TestClient) -> None:
    one, other = (client.post("/api/v1/exercises/slider_crank/variants", json={"seed": 9}).json() for _ in range(2))
    assert one["givens"] == other["givens"] and one["id"] != other["id"]


def test_a_variant_is_drawn_once_in_each_language(client: TestClient, monkeypatch: pytest.MonkeyPatch) -> None:
    drawn: list[str] = []
    draw = presenting.presented

    def noted(variant: Variant, language: str) -> presenting.Presented:
        drawn.append(language)
        return draw(variant, language)

    monkeypatch.setattr(presenting, "presented", noted)
    number = client.post("/api/v1/exercises/slider_crank/variants?lang=pl", json={"seed": 20261128}).json()["id"]
    looks = [client.get(f"/api/v1/variants/{number}?lang={lang}").json() for lang in ("pl", "en", "pl", "en")]
    assert drawn == ["pl", "en"]
    assert looks[0] == looks[2] != looks[1] == looks[3]


def test_without_a_seed_one_is_drawn(client: TestClient) -> None:
    seeds = {client.post("/api/v1/exercises/slider_crank/variants").json()["seed"] for _ in range(3)}
    assert len(seeds) == 3 and all(0 <= seed < 2**53 for seed in seeds)


def test_a_cookie_comes_once_and_owns_all_variants(client: TestClient) -> None:
    first = client.post("/api/v1/exercises/slider_crank/variants")
    second = client.post("/api/v1/exercises/slider_crank/variants")
    cookie = first.headers["set-cookie"]
    assert "HttpOnly" in cookie and "SameSite=lax" in cookie and "Secure" not in cookie
    assert "set-cookie" not in second.headers
    assert client.get(f"/api/v1/variants/{first.json()['id']}").json() == first.json()


def test_the_cookie_itself_is_not_in_the_store(client: TestClient, settings: Settings) -> None:
    client.post("/api/v1/exercises/slider_crank/variants")
    cookie = client.cookies["grubler_practice"]
    written = everything(settings.store_url)
    assert "slider_crank" in written and cookie not in written


def test_a_variant_survives_a_restart_with_its_cookie(settings: Settings) -> None:
    with TestClient(create_app(settings)) as before:
        body = before.post("/api/v1/exercises/slider_crank/variants").json()
        cookie = before.cookies["grubler_practice"]
    with TestClient(create_app(settings), cookies={"grubler_practice": cookie}) as after:
        assert after.get(f"/api/v1/variants/{body['id']}").json() == body


def test_the_stored_givens_rule_not_the_seed(client: TestClient, settings: Settings, deal: Callable[..., str]) -> None:
    number = deal(seed=7)
    change(settings, givens={"l1": 0.05, "l2": 0.2, "alpha1": 0.5, "omega1": 10.0})
    assert client.get(f"/api/v1/variants/{number}").json()["givens"]["l1"] == 0.05


@pytest.mark.parametrize("values", [{"givens": {"l9": 1}}, {"exercise": "gone"}])
def test_a_variant_that_no_longer_fits_its_exercise_says_so(
    client: TestClient, settings: Settings, deal: Callable[..., str], values: dict[str, Any]
) -> None:
    number = deal()
    change(settings, **values)
    for reply in (
        client.get(f"/api/v1/variants/{number}"),
        client.post(f"/api/v1/variants/{number}/submissions", json={"answers": {}}),
    ):
        assert (reply.status_code, reply.json()["error"]["code"]) == (410, "outdated_variant")


def test_looking_at_a_variant_keeps_it_from_expiring(
    client: TestClient, settings: Settings, deal: Callable[..., str]
) -> None:
    number = deal()
    change(settings, last_used=datetime.now(UTC) - timedelta(days=29))
    assert client.get(f"/api/v1/variants/{number}").status_code == 200
    storage = client.app.state.bench.storage  # type: ignore[attr-defined]
    assert asyncio.run(storage.purge(datetime.now(UTC) - timedelta(days=1))) == 0


def test_idle_practice_is_forgotten_at_the_start(settings: Settings) -> None:
    with TestClient(create_app(settings)) as client:
        number = client.post("/api/v1/exercises/slider_crank/variants").json()["id"]
        cookies = dict(client.cookies)
    change(settings, last_used=datetime.now(UTC) - timedelta(days=31))
    with TestClient(create_app(settings), cookies=cookies) as client:
        assert client.get(f"/api/v1/variants/{number}").status_code == 404


def test_a_preview_says_what_was_understood_with_its_unit(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    read = preview(client, number, "l3", "12,5")
    assert read["ok"] and read["unit"] == "mm" and "mm" in read["mathml"] and read["text"] == "12.5 mm"
    formula = preview(client, number, "omega2_formula", "l1*omega1")
    assert formula["ok"] and formula["mathml"].startswith("<math>") and formula["unit"] is None


def test_a_degree_stands_close_to_its_number_and_other_units_do_not(
    client: TestClient, deal: Callable[..., str]
) -> None:
    number = deal()
    assert preview(client, number, "alpha2", "-10 deg")["mathml"].endswith("</mrow><mtext>°</mtext></math>")
    assert '<mspace width=".2em"/><mtext>mm' in preview(client, number, "l3", "12 mm")["mathml"]


@pytest.mark.parametrize(("language", "word"), [("pl", "Nie odczytano"), ("en", "Not read"), ("ru", "Не прочитано")])
def test_a_preview_says_where_reading_ended(
    client: TestClient, deal: Callable[..., str], language: str, word: str
) -> None:
    read = preview(client, deal(), "omega2_formula", "l1*ac", language)
    assert (read["ok"], read["code"], read["position"]) == (False, "unreadable", 3)
    assert word in read["message"]


def test_a_preview_is_the_same_for_every_seed(client: TestClient, deal: Callable[..., str]) -> None:
    one, other = deal(seed=1), deal(seed=2)
    right = grading.reference(dealt_by_hand("slider_crank", 1))
    for answer, text in [*right.items(), ("l3", "3 kg"), ("v3", "1/"), ("omega2_formula", "x")]:
        assert preview(client, one, answer, text) == preview(client, other, answer, text)


def test_a_preview_gives_the_relations_it_is_asked_for(client: TestClient, deal: Callable[..., str]) -> None:
    question = {"answer": "omega2_formula", "text": "-l1*omega1"}
    path = f"/api/v1/variants/{deal()}/preview"
    assert client.post(path, json=question).json()["relations"] is None
    asked = client.post(path, json=question | {"relations": True}).json()
    assert asked["relations"] == {"formula": ["*", ["negate", "l1"], "omega1"]}


def test_a_preview_of_an_unknown_answer_is_refused(client: TestClient, deal: Callable[..., str]) -> None:
    reply = client.post(f"/api/v1/variants/{deal()}/preview", json={"answer": "zz", "text": "1"})
    assert (reply.status_code, reply.json()["error"]["field"]) == (422, "answer")


def test_the_solution_opens_with_the_first_submission_that_counts(client: TestClient, deal: Callable[..., str]) -> None:
    number = deal()
    path = f"/api/v1/variants/{number}"
    for answers in (None, {}, {"l3": " "}, {"l3": "???"}):
        if answers is not None:
            client.post(f"{path}/submissions", json={"answers": answers})
        reply = client.get(f"{path}/solution")
        assert (reply.status_code, reply.json()["error"]["code"]) == (403, "solution_closed")
    client.post(f"{path}/submissions", json={"answers": {"l3": "1 mm"}})
    client.post(f"{path}/submissions", json={"answers": {}})
    lines = client.get(f"{path}/solution").json()["lines"]
    assert lines and all(line["heading"] and line["value"] for line in lines)
