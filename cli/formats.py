"""The forms of a marking: text for people, JSON for programs. Nothing in them is a time."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from typing import Any

from cli.marking import Mark, Sheet
from cli.problems import say
from exercises.grading import GRADER_VERSION
from graders.words import decimal, message


def text(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Word the marking for people."""
    lines: list[str] = []
    for sheet in sheets:
        lines.append(f"{safe(sheet.file)}: {_verdict(sheet, mark, lang)}")
        for item in sheet.marks:
            seed = say(lang, "seed", seed=item.seed)
            lines.append(f"  {item.exercise}, {seed}: {percent(item.score, lang)}")
            lines += [f"    {line}" for line in notes(item, lang)]
    return "\n".join(lines)


def _verdict(sheet: Sheet, mark: float, lang: str) -> str:
    if sheet.problem:
        return say(lang, "unused")
    return f"{percent(sheet.score, lang)}, {say(lang, 'passed' if sheet.score >= mark else 'below')}"


def notes(item: Mark, lang: str) -> Iterator[str]:
    """Say what is to be said of a task, a line each."""
    if item.lack:
        yield say(lang, item.lack)
    for name, verdict in item.verdicts.items():
        yield f"{name}: {message(verdict, lang)}"
    found = hint(item, lang)
    if found:
        yield say(lang, "hint", hint=found)
    if item.grade and item.grade.provisional:
        yield say(lang, "provisional")


def as_json(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Give the marking as one JSON object."""
    files = [_file(sheet, mark, lang) for sheet in sheets]
    passed = all(entry["passed"] for entry in files)
    document = {"grader_version": GRADER_VERSION, "pass": mark, "passed": passed, "files": files}
    return json.dumps(document, ensure_ascii=False, indent=2)


def _file(sheet: Sheet, mark: float, lang: str) -> dict[str, Any]:
    problem = sheet.problem
    error = {"code": problem.key, "field": problem.place, "message": problem.worded(lang)} if problem else None
    return {
        "file": safe(sheet.file),
        "score": sheet.score,
        "passed": problem is None and sheet.score >= mark,
        "error": error,
        "items": [_item(item, lang) for item in sheet.marks],
    }


def _item(item: Mark, lang: str) -> dict[str, Any]:
    return {
        "exercise": item.exercise,
        "version": item.version,
        "seed": item.seed,
        "score": item.score,
        "provisional": bool(item.grade and item.grade.provisional),
        "note": say(lang, item.lack) if item.lack else None,
        "hint": hint(item, lang) or None,
        "verdicts": {
            name: {
                "outcome": verdict.outcome.value,
                "code": verdict.code.value,
                "score": verdict.score,
                "message": message(verdict, lang),
            }
            for name, verdict in item.verdicts.items()
        },
    }


def hint(item: Mark, lang: str) -> str:
    """Word the hint of a task; empty where nothing was recognised."""
    if not (item.grade and (item.grade.mistake or item.grade.slip) and item.variant):
        return ""
    from exercises.presenting import hints_text

    return hints_text(item.variant, item.grade, lang)


def percent(score: float, lang: str) -> str:
    """Write a share as the language does."""
    return f"{decimal(100 * score, lang)} %"


def safe(name: str) -> str:
    """Give the name of a file as text on one line, whatever its bytes."""
    return "".join(sign if sign.isprintable() else "\ufffd" for sign in name)
