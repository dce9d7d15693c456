"""The beam as drawn for one student."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from exercises.strength._beam.figure import drawn_beam
from figures.picture import Picture

if TYPE_CHECKING:
    from exercises.strength.beam_diagrams import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the beam with its supports, loads and lengths."""
    return drawn_beam("beam-diagrams", givens, words, lang)
