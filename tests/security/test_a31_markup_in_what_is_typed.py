"""A31: markup in an answer, a name or a search is inert in every page and document that shows it."""

from __future__ import annotations

import re
from html.parser import HTMLParser

import pytest
from starlette.testclient import TestClient

MARKUP = [
    "<script>alert(1)</script>", '"><img src=x onerror=alert(1)>', "<svg/onload=alert(1)>", "javascript:alert(1)",
    "\\href{javascript:alert(1)}{x}", "[x](javascript:alert(1))", "{{7*7}}", "${7*7}", "</textarea><script>1</script>",
    "<math><mtext></mtext><script>1</script></math>", "\u202e<b>x", "&lt;script&gt;",
]  # fmt: skip


class Elements(HTMLParser):
    """The elements and attributes that a browser would make of a page."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))


def hostile(page: str) -> list[str]:
    elements = Elements()
    elements.feed(page)
    scripts = [tag for tag, attributes in elements.found if tag == "script" and not attributes.get("src")]
    handlers = [name for _, attributes in elements.found for name in attributes if name.startswith("on")]
    links = [str(a.get(n)) for _, a in elements.found for n in ("href", "src", "action") if a.get(n)]
    return scripts + handlers + [link for link in links if link.lower().startswith(("javascript", "data:", "vbscript"))]


@pytest.mark.parametrize("text", MARKUP)
def test_typed_markup_is_inert_in_every_page(client: TestClient, text: str) -> None:
    number = client.headers["x-variant"]
    body = {"answers": {"l3": text, "omega2_formula": text}}
    receipt = client.post(f"/api/v1/variants/{number}/submissions", json=body).json()["receipt"]["id"]
    for path in (f"/variants/{number}", f"/variants/{number}?receipt={receipt}"):
        assert hostile(client.get(path).text) == []
    shown = client.post(
        f"/variants/{number}/preview", data={"answer.l3": text}, headers={"origin": "http://testserver"}
    )
    assert hostile(shown.text) == []
    assert hostile(client.get("/", params={"q": text, "chapter": text[:40]}).text) == []


@pytest.mark.parametrize("text", MARKUP)
def test_a_preview_gives_no_element_but_mathematics(client: TestClient, text: str) -> None:
    question = {"answer": "omega2_formula", "text": text}
    reply = client.post(f"/api/v1/variants/{client.headers['x-variant']}/preview", json=question).json()
    elements = Elements()
    elements.feed(reply["mathml"])
    assert all(tag.startswith("m") for tag, _ in elements.found)


@pytest.mark.parametrize("text", MARKUP)
def test_a_name_in_a_report_is_text(client: TestClient, text: str) -> None:
    number = client.post("/api/v1/exercises/tmm2_oop/variants", json={"seed": 1}).json()["id"]
    written = client.get(f"/api/v1/reports/tmm2/{number}.md", params={"name": text}).text
    assert not re.search(r"(?<!\\)<", written) and "](javascript" not in written
    assert client.get(f"/api/v1/reports/tmm2/{number}.typ", params={"name": text}).status_code == 200


def test_the_catch_would_see_an_attack() -> None:
    assert hostile('<img src="x" onerror="1"><a href="javascript:1">x</a><script>1</script>') == [
        "script", "onerror", "javascript:1",
    ]  # fmt: skip
