"""The forms of a marking: text for people, JSON for programs, JUnit XML for a pipeline. Nothing in them is a time."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from cli.marking import Mark, Sheet
from cli.problems import say
from exercises.grading import GRADER_VERSION
from graders import Outcome
from graders.words import decimal, message

NO_XML = {code: "\ufffd" for code in (*range(32), *range(0xD800, 0xE000), 0xFFFE, 0xFFFF) if code not in (9, 10, 13)}
ESCAPED = str.maketrans(
    {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\t": "&#9;", "\n": "&#10;", "\r": "&#13;"} | NO_XML
)


def text(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Word the marking for people."""
    lines: list[str] = []
    for sheet in sheets:
        lines.append(f"{_safe(sheet.file)}: {_verdict(sheet, mark, lang)}")
        for item in sheet.marks:
            seed = say(lang, "seed", seed=item.seed)
            lines.append(f"  {item.exercise}, {seed}: {_percent(item.score, lang)}")
            lines += [f"    {line}" for line in _notes(item, lang)]
    return "\n".join(lines)


def _verdict(sheet: Sheet, mark: float, lang: str) -> str:
    if sheet.problem:
        return say(lang, "unused")
    return f"{_percent(sheet.score, lang)}, {say(lang, 'passed' if sheet.score >= mark else 'below')}"


def _notes(item: Mark, lang: str) -> Iterator[str]:
    if item.lack:
        yield say(lang, item.lack)
    for name, verdict in item.verdicts.items():
        yield f"{name}: {message(verdict, lang)}"
    hint = _hint(item, lang)
    if hint:
        yield say(lang, "hint", hint=hint)
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
        "file": _safe(sheet.file),
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
        "hint": _hint(item, lang) or None,
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


def junit(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Give the marking as JUnit XML: a suite for each file, a case for each answer."""
    suites = [_suite(sheet, lang) for sheet in sheets]
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', "<testsuites>", *suites, "</testsuites>"])


def _suite(sheet: Sheet, lang: str) -> str:
    cases = [case for item in sheet.marks for case in _cases(item, lang)]
    if sheet.problem:
        cases = [_case("answers", _safe(sheet.file), "error", sheet.problem.key, sheet.problem.worded(lang))]
    counts = {
        "tests": len(cases),
        "failures": sum("<failure" in case for case in cases),
        "errors": sum("<error" in case for case in cases),
    }
    head = _attributes({"name": _safe(sheet.file), **counts})
    return "\n".join([f"  <testsuite{head}>", *cases, "  </testsuite>"])


def _cases(item: Mark, lang: str) -> Iterator[str]:
    name = f"{item.exercise} {item.seed}"
    if item.lack:
        yield _case(item.exercise, name, "failure", item.lack, say(lang, item.lack))
    hint = _hint(item, lang)
    for answer, verdict in item.verdicts.items():
        kind = "" if verdict.outcome is Outcome.RIGHT else "failure"
        kind = "error" if verdict.outcome is Outcome.FAULT else kind
        said = " ".join(filter(None, (message(verdict, lang), hint)))
        yield _case(item.exercise, f"{name} {answer}", kind, verdict.code.value, said)


def _case(group: str, name: str, kind: str, code: str, said: str) -> str:
    head = f"    <testcase{_attributes({'classname': group, 'name': name})}"
    if not kind:
        return f"{head}/>"
    return f"{head}>\n      <{kind}{_attributes({'type': code, 'message': said})}/>\n    </testcase>"


def _attributes(values: Mapping[str, object]) -> str:
    return "".join(f' {name}="{str(value).translate(ESCAPED)}"' for name, value in values.items())


def _hint(item: Mark, lang: str) -> str:
    if not (item.grade and (item.grade.mistake or item.grade.slip) and item.variant):
        return ""
    from exercises.presenting import hints_text

    return hints_text(item.variant, item.grade, lang)


def _percent(score: float, lang: str) -> str:
    return f"{decimal(100 * score, lang)} %"


def _safe(name: str) -> str:
    """A file name can hold bytes that are no text."""
    return name.encode("utf-8", "replace").decode()


FORMATS: Mapping[str, Callable[[Sequence[Sheet], float, str], str]] = {"text": text, "json": as_json, "junit": junit}
