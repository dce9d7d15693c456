"""Hands in answers to a variant: the right ones, but for those that are given."""

from __future__ import annotations

from exercises.exercise import Grade, Submission, Variant
from exercises.grading import grade, reference


def handed_in(variant: Variant, **changed: str) -> Grade:
    """Grade the right answers with some changed."""
    return grade(Submission(variant, {**reference(variant), **changed}))
