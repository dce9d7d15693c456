"""A1: code, attributes and comprehensions in an answer are refused by the grammar, with their place."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from graders import Code, Verdict
from graders.verdict import Reading
from tests.security.conftest import Attack

CODE = [
    ("__import__('os')", 0), ("l1.__class__", 2), ("().__class__.__bases__[0]", 2), ("lambda: l1", 0),
    ("[x for x in l1]", 1), ("f'{l1}'", 2), ("{l1}", 0), ("eval(l1)", 0), ("exec('1')", 0), ("import os", 0),
    ("l1; import os", 2), ("l1 if l1 else l2", 3), ("(l1 := 2)", 5), ("@l1", 0), ("`ls`", 0), ("$(ls)", 0),
    ("{{7*7}}", 0), ("${7*7}", 0), ("<%= 7 %>", 1), ("l1\\n", 2), ("open('/etc/passwd')", 0), ("l1 # l2", 3),
    ("getattr(l1; 'x')", 0), ("l1[0]", 3), ("sys.exit()", 3), ("_", 0), ("os.system('ls')", 2), ("'ls'", 0),
    
    ("l1~l2", 2),
    ("l1 and l2", 3), ("not l1", 0), ("True", 0), ("None", 0), ("print(l1)", 0), ("globals()", 0), ("l1?l2", 2),
    ("sin.__globals__", 3), ("\\input{l1}", 0), ("l1\\write18{ls}", 2), ("\\def\\x{l1}", 0),
    ("\\sqrt{\\csname x\\endcsname}", 6), ("<script>alert(1)</script>", 1), ("' OR 1=1 --", 0),
]  # fmt: skip
ROOMS = ("cli", "server", "exercises", "graders", "mechanics", "figures")
DANGEROUS = {
    "eval",
    "exec",
    "compile",
    "__import__",
    "sympify",
    "parse_expr",
    "lambdify",
    "parse_latex",
}


@pytest.mark.parametrize(("text", "place"), CODE)
@pytest.mark.parametrize("answer", ["omega2_formula", "l3"])
def test_code_is_refused_with_its_place(attack: Attack, text: str, place: int, answer: str) -> None:
    verdict = attack(text, answer)
    assert verdict.code is Code.UNREADABLE
    if answer == "omega2_formula":
        assert _place(verdict) == place


def _place(verdict: Verdict) -> int:
    assert isinstance(verdict.details, Reading)
    return verdict.details.position


@pytest.mark.parametrize("room", ROOMS)
def test_no_room_calls_an_evaluator_of_text(room: str) -> None:
    files = list((Path(__file__).parents[2] / room).rglob("*.py"))
    assert files
    called = {
        (ast.unparse(node.func), file.name)
        for file in files
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and _names_evaluator(node.func)
    }
    assert called == set()


def _names_evaluator(function: ast.expr) -> bool:
    if isinstance(function, ast.Name):
        return function.id in DANGEROUS
    return isinstance(function, ast.Attribute) and function.attr in DANGEROUS - {"compile"}
