"""The forms of a marking that other platforms read: JUnit XML, the results of Gradescope, annotations of GitHub.

Nothing in them is a time, and no text of a student can end what it stands in.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from cli.formats import hint, notes, percent, safe
from cli.marking import Mark, Sheet
from cli.problems import say
from graders import Outcome
from graders.words import message

NO_XML = {code: "\ufffd" for code in (*range(32), *range(0xD800, 0xE000), 0xFFFE, 0xFFFF) if code not in (9, 10, 13)}
ESCAPED = str.maketrans(
    {"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "\t": "&#9;", "\n": "&#10;", "\r": "&#13;"} | NO_XML
)
DATA = str.maketrans({"%": "%25", "\r": "%0D", "\n": "%0A"})
PROPERTY = DATA | str.maketrans({":": "%3A", ",": "%2C"})


def junit(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Give the marking as JUnit XML: a suite for each file, a case for each answer."""
    suites = [_suite(sheet, lang) for sheet in sheets]
    return "\n".join(['<?xml version="1.0" encoding="UTF-8"?>', "<testsuites>", *suites, "</testsuites>"])


def _suite(sheet: Sheet, lang: str) -> str:
    cases = [case for item in sheet.marks for case in _cases(item, lang)]
    if sheet.problem:
        cases = [_case("answers", safe(sheet.file), "error", sheet.problem.key, sheet.problem.worded(lang))]
    counts = {
        "tests": len(cases),
        "failures": sum("<failure" in case for case in cases),
        "errors": sum("<error" in case for case in cases),
    }
    head = _attributes({"name": safe(sheet.file), **counts})
    return "\n".join([f"  <testsuite{head}>", *cases, "  </testsuite>"])


def _cases(item: Mark, lang: str) -> Iterator[str]:
    name = f"{item.exercise} {item.seed}"
    if item.lack:
        yield _case(item.exercise, name, "failure", item.lack, say(lang, item.lack))
    found = hint(item, lang)
    for answer, verdict in item.verdicts.items():
        kind = "" if verdict.outcome is Outcome.RIGHT else "failure"
        kind = "error" if verdict.outcome is Outcome.FAULT else kind
        said = " ".join(filter(None, (message(verdict, lang), found)))
        yield _case(item.exercise, f"{name} {answer}", kind, verdict.code.value, said)


def _case(group: str, name: str, kind: str, code: str, said: str) -> str:
    head = f"    <testcase{_attributes({'classname': group, 'name': name})}"
    if not kind:
        return f"{head}/>"
    return f"{head}>\n      <{kind}{_attributes({'type': code, 'message': said})}/>\n    </testcase>"


def _attributes(values: Mapping[str, object]) -> str:
    return "".join(f' {name}="{str(value).translate(ESCAPED)}"' for name, value in values.items())


def gradescope(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Give the marking as the results of Gradescope: a test for each task, worth one point; the mark passes none."""
    several = len(sheets) > 1
    tests = [_test(item, f"{safe(sheet.file)}: " if several else "", lang) for sheet in sheets for item in sheet.marks]
    document: dict[str, Any] = {"score": round(sum(test["score"] for test in tests), 6), "tests": tests}
    problems = [sheet.problem.worded(lang) for sheet in sheets if sheet.problem]
    return json.dumps(
        document | {"output": "\n".join(problems)} if problems else document, ensure_ascii=False, indent=2
    )


def _test(item: Mark, before: str, lang: str) -> dict[str, Any]:
    return {
        "name": f"{before}{item.exercise}, {say(lang, 'seed', seed=item.seed)}",
        "score": item.score,
        "max_score": 1,
        "status": "passed" if item.score == 1 else "failed",
        "output": "\n".join(notes(item, lang)),
        "output_format": "text",
    }


def github(sheets: Sequence[Sheet], mark: float, lang: str) -> str:
    """Give the marking as annotations of GitHub: an error for each file that is below the mark, notes at its tasks."""
    return "\n".join(line for sheet in sheets for line in _annotations(sheet, mark, lang))


def _annotations(sheet: Sheet, mark: float, lang: str) -> Iterator[str]:
    file = safe(sheet.file)
    if sheet.problem:
        yield _annotation("error", file, say(lang, "unused"), sheet.problem.worded(lang))
        return
    for item in sheet.marks:
        if item.score < 1:
            title = f"{item.exercise}, {say(lang, 'seed', seed=item.seed)}: {percent(item.score, lang)}"
            yield _annotation("warning", file, title, "\n".join(notes(item, lang)))
    kind, key = ("notice", "passed") if sheet.score >= mark else ("error", "below")
    yield _annotation(kind, file, say(lang, key), percent(sheet.score, lang))


def _annotation(kind: str, file: str, title: str, said: str) -> str:
    place = f"file={file.translate(PROPERTY)},title={title.translate(PROPERTY)}"
    return f"::{kind} {place}::{said.translate(DATA)}"
