"""The beam as drawn for one student, with the point whose deflection is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from exercises.strength._beam.figure import drawn_beam
from figures.picture import Picture

if TYPE_CHECKING:
    from exercises.strength.beam_deflection import Givens


def figure(givens: Givens, words: Mapping[str, Any], lang: str) -> Picture:
    """Draw the beam and the point K."""
    return drawn_beam("beam-deflection", givens, words, lang, (("K", givens.x),))
