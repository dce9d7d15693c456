"""Comparing two typed answers on request: what `grubler compare` and `POST /compare` read and answer."""

from graders.comparison.answering import answer
from graders.comparison.request import KINDS, BadRequest

__all__ = ["KINDS", "BadRequest", "answer"]
