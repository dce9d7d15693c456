"""`grubler draw`: shows the variant of a seed, for people or as JSON, with the reference if asked for."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from collections.abc import Iterator
from typing import Any

from cli.problems import Unusable, language, say
from exercises import catalogue
from exercises.exercise import Variant
from exercises.grading import reference
from exercises.presenting import Field, Presented, presented
from exercises.variants import MAX_SEED, deal, dump


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("exercise", metavar="ID", help="id of the exercise")
    parser.add_argument("--seed", required=True, metavar="N", help=f"whole number from 0 to {MAX_SEED}")
    parser.add_argument("--json", action="store_true", help="the variant as JSON")
    parser.add_argument("--with-reference", action="store_true", help="add answers that are graded right")
    language(parser)


def run(options: Namespace) -> int:
    """Show the variant."""
    variant = deal(known(options.exercise), seed_of(options.seed))
    shown = presented(variant, options.lang)
    right = reference(variant) if options.with_reference else None
    if options.json:
        print(json.dumps(_document(variant, shown, options.lang, right), ensure_ascii=False, indent=2))
    else:
        print("\n".join(_lines(shown, options.lang, right)))
    return 0


def known(exercise: str) -> str:
    """Give an id back if there is such an exercise; raises Unusable."""
    if exercise not in catalogue.ids():
        raise Unusable("unknown_exercise", name=exercise)
    return exercise


def seed_of(text: str) -> int:
    """Read a seed; raises Unusable."""
    if text.isascii() and text.isdecimal() and len(text) <= len(str(MAX_SEED)) and int(text) <= MAX_SEED:
        return int(text)
    raise Unusable("seed_range", place="--seed", most=MAX_SEED)


def _document(variant: Variant, shown: Presented, lang: str, right: dict[str, str] | None) -> dict[str, Any]:
    picture = {"figure": shown.picture.svg} if shown.picture else {}
    return {
        **dump(variant),
        "language": lang,
        "title": shown.title,
        "statement": shown.statement_text,
        "answers": {name: _field(field) for name, field in shown.answers.items()},
        **picture,
        **({"reference": right} if right is not None else {}),
    }


def _field(field: Field) -> dict[str, Any]:
    return {
        "kind": field.kind,
        "prompt": field.prompt_text,
        "unit": field.unit,
        "symbols": list(field.symbols),
        "tolerance": field.tolerance_text,
        "rows": field.rows,
        "columns": field.columns,
        "options": [key for key, _ in field.options],
    }


def _lines(shown: Presented, lang: str, right: dict[str, str] | None) -> Iterator[str]:
    yield from (shown.title, "", shown.statement_text, "")
    for name, field in shown.answers.items():
        yield f"{name}: {field.prompt_text}"
        said = {
            "unit": field.unit_text,
            "tolerance": field.tolerance_text,
            "symbols": ", ".join(field.symbols),
            "options": ", ".join(f"{key} ({text})" if text != key else key for key, text in field.options_text),
        }
        notes = [say(lang, key, **{key: value}) for key, value in said.items() if value]
        if notes:
            yield f"    {'; '.join(notes)}"
        if right is not None:
            yield f"    {say(lang, 'reference', text=right[name])}"
