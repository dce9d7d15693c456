"""`grubler catalogue`: lists the exercises."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from typing import Any

from cli.problems import LANGUAGES, language
from exercises import catalogue
from exercises.presenting import words_of
from exercises.variants import deal


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("--json", action="store_true", help="id, chapter, systems, answers and languages as JSON")
    language(parser)


def run(options: Namespace) -> int:
    """List the exercises by chapter."""
    if options.json:
        print(json.dumps([_described(name) for name in catalogue.ids()], ensure_ascii=False, indent=2))
        return 0
    width = max(map(len, catalogue.ids()))
    for name in catalogue.ids():
        print(f"{catalogue.chapter_of(name):13} {name:{width}}  {words_of(name, options.lang)['title']}")
    return 0


def _described(name: str) -> dict[str, Any]:
    exercise = catalogue.load(name).exercise
    return {
        "id": name,
        "chapter": catalogue.chapter_of(name),
        "systems": list(exercise.systems),
        "answers": list(exercise.answers_of(deal(name, 0).givens)),
        "languages": list(LANGUAGES),
    }
