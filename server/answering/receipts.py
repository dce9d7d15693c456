"""What is handed in, as it is stored: with a receipt, a time and a digest; and its grade beside it."""

from __future__ import annotations

import json
from datetime import datetime

from pydantic import TypeAdapter

from exercises.exercise import Grade
from server.storage import Answers, Handed, Marked
from server.web import ids

GRADE: TypeAdapter[Grade] = TypeAdapter(Grade)


def handed(
    variant: str, owner: str, answers: Answers, key: str | None, body: str, language: str, time: datetime
) -> Handed:
    """Give answers their receipt.

    Args:
        variant: The variant answered.
        owner: Who hands in.
        answers: The answers as typed.
        key: Idempotency key.
        body: Digest of the request.
        language: Language of the response.
        time: When the server received them.
    """
    receipt = ids.new()
    typed = json.dumps(answers, sort_keys=True).encode()
    digest = ids.digest(receipt.encode(), variant.encode(), time.isoformat().encode(), typed)
    return Handed(receipt, variant, owner, dict(answers), time, key, body, digest, language)


def marked(given: Handed, grade: Grade, code: str | None = None) -> Marked:
    """Put a grade beside what was handed in; a code says that the variant stands in a set."""
    return Marked(given, GRADE.dump_python(grade, mode="json"), grade.counted, grade.grader_version, code)


def whole(answers: Answers) -> dict[str, str]:
    """Give answers as texts; a list of lines is a text of lines."""
    return {name: text if isinstance(text, str) else "\n".join(text) for name, text in answers.items()}
