"""A35, A36: templates, format strings, log lines and documents treat texts as texts; nothing is loaded as code."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from exercises.exercise import Submission
from exercises.grading import grade
from exercises.variants import deal
from graders.words import LANGUAGES, message
from reports.document import Document, Paragraph
from reports.formulas.typst import quoted
from reports.pdf import pdf
from reports.typst import source

ROOT = Path(__file__).parents[2]
ROOMS = ("cli", "server", "reports", "exercises", "graders", "mechanics", "figures")
LOADERS = {"pickle", "marshal", "shelve", "dill", "yaml", "jsonpickle", "cloudpickle"}
BETWEEN_OUR_PROCESSES = {ROOT / "server/judging/judge.py"}  # a pair of sockets that nobody else has an end of
IMPORTED = re.compile(r"^ *(?:import|from) (\w+)", re.M)
TYPST = [
    '#read("/etc/passwd")', '"] #import "@preview/x:0.1.0": * #["', "$ #sys.version $", '\\" #eval("1+1") \\"',
    "#include \"/etc/passwd\"", "`#plugin(\"x\")`", "= Heading", "@ref", "<label>",
]  # fmt: skip


def test_no_room_loads_objects_from_bytes() -> None:
    for room in ROOMS:
        for file in {*(ROOT / room).rglob("*.py")} - BETWEEN_OUR_PROCESSES:
            assert not set(IMPORTED.findall(file.read_text("utf-8"))) & LOADERS, file


@pytest.mark.parametrize("text", TYPST)
def test_a_text_in_a_document_is_no_code(text: str) -> None:
    document = Document(text, text, "pl", (Paragraph((text,)),), text)
    content = pdf(document)
    assert content.startswith(b"%PDF-") and b"root:x" not in content
    written = source(document)
    assert written.count(quoted(text)) >= 3 and text not in written.replace(quoted(text), "")


@pytest.mark.parametrize("text", ["{0.__class__}", "%s%n", "{{7*7}}", "{secret}"])
@pytest.mark.parametrize("language", LANGUAGES)
def test_a_format_string_that_is_typed_is_only_shown(text: str, language: str) -> None:
    verdict = grade(Submission(deal("slider_crank", 7), {"l3": text})).verdicts["l3"]
    said = message(verdict, language)
    assert "class" not in said.replace(text[:20], "") and "49" not in said
