"""The worked examples of the domain: what is given, what is printed, and when a result reproduces it.

Keys that end in ``_deg`` are degrees and are compared modulo a full turn; numbers to ten printed digits.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeAlias

import pytest

Inputs: TypeAlias = Mapping[str, Any]
Outputs: TypeAlias = Mapping[str, Any]
Solve: TypeAlias = Callable[[Inputs], Outputs]

PRINTED = 1e-9  # ten significant digits, relative

_READ = json.loads((Path(__file__).parents[1] / "examples.json").read_text("utf-8"))
EXAMPLES: Mapping[str, Mapping[str, Mapping[str, Any]]] = {example["id"]: example for example in _READ["examples"]}


def inputs(name: str) -> Inputs:
    """Give what an example is given, for examples that lean on the geometry of another."""
    return EXAMPLES[name]["inputs"]


def unlike(name: str, found: Outputs) -> list[str]:
    """Give the printed outputs of an example that a solver did not find, and what it found besides."""
    printed = EXAMPLES[name]["outputs"]
    return [
        *(f"{key} stands on one side only" for key in sorted(found.keys() ^ printed.keys())),
        *(
            f"{key} = {found[key]}, printed {value}"
            for key, value in printed.items()
            if key in found and not _same(found[key], value, key.endswith("_deg"))
        ),
    ]


def _same(found: Any, printed: Any, angle: bool, largest: float = 0.0) -> bool:
    if isinstance(printed, list):
        largest = max([largest, *(abs(value) for value in printed if isinstance(value, (int, float)))])
        pairs = zip(found, printed, strict=True)
        return all(_same(one, other, angle, largest) for one, other in pairs)
    if not isinstance(printed, (int, float)):
        return bool(found == printed)
    if angle:
        found = printed + (found - printed + 180) % 360 - 180
    return bool(found == pytest.approx(printed, rel=PRINTED, abs=max(1e-12, PRINTED * largest)))
