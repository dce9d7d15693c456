"""Reading answer files and task files: strict JSON, every refusal with its file, item and field."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeVar

from cli.problems import Unusable
from exercises import catalogue
from exercises.variants import MAX_SEED

LARGEST = 1_000_000  # bytes of a file
LONGEST = 10_000  # characters of an answer; the answer language reads fewer and says so beside the field
DIGITS = 20  # of a whole number: longer ones are out of every range

WANTED: Mapping[type, str] = {dict: "wants_object", list: "wants_list", str: "wants_text", int: "wants_whole"}
UNREADABLE: Mapping[type, str] = {
    FileNotFoundError: "no_file", IsADirectoryError: "is_folder", PermissionError: "not_allowed",
}  # fmt: skip

T = TypeVar("T")


@dataclass(frozen=True, slots=True)
class Item:
    """One item of an answer file: the task as the student names it, and the answers as typed."""

    exercise: str
    seed: int
    answers: Mapping[str, str]
    place: str


@dataclass(frozen=True, slots=True)
class Task:
    """One item of a task file: what was dealt."""

    exercise: str
    version: int
    seed: int


@dataclass(frozen=True, slots=True)
class Odd:
    """What JSON text can hold and we refuse; it stands where it was found, so that its place can be told."""

    key: str
    name: str = ""


def read_answers(file: str) -> tuple[Item, ...]:
    """Read an answer file.

    Raises:
        Unusable: With the place of the first thing that is wrong.
    """
    return Reader(file).items(("exercise", "seed", "answers"), _item)


def read_tasks(file: str) -> tuple[Task, ...]:
    """Read a task file; raises Unusable likewise, also for a version of an exercise that is not installed."""
    return Reader(file).items(("exercise", "version", "seed"), _task)


def _item(reader: Reader, item: Mapping[str, Any], place: str) -> Item:
    exercise, seed = reader.exercise(item, place), reader.seed(item, place)
    answers = reader.object(item["answers"], f"{place}.answers")
    texts = {name: reader.answer(text, f"{place}.answers.{name}") for name, text in answers.items()}
    return Item(exercise, seed, texts, place)


def _task(reader: Reader, item: Mapping[str, Any], place: str) -> Task:
    exercise, seed = reader.exercise(item, place), reader.seed(item, place)
    dealt, known = reader.whole(item["version"], f"{place}.version"), catalogue.load(exercise).exercise.version
    if dealt != known:
        raise Unusable("other_version", reader.file, f"{place}.version", dealt=dealt, known=known)
    return Task(exercise, dealt, seed)


class Reader:
    """Reads one file and knows its name for the refusals."""

    def __init__(self, file: str) -> None:
        self.file = file

    def items(self, fields: tuple[str, ...], read: Callable[[Reader, Mapping[str, Any], str], T]) -> tuple[T, ...]:
        """Read the list under `items`, each an object with exactly these fields."""
        document = self.fields(self.json(), "", ("items",))
        entries = self.typed(document["items"], "items", list)
        if not entries:
            raise Unusable("nothing", self.file, "items")
        places = [(entry, f"items[{at}]") for at, entry in enumerate(entries)]
        return tuple(read(self, self.fields(entry, place, fields), place) for entry, place in places)

    def json(self) -> Any:
        """Read the file as JSON; what is odd in it stays where it stands, as an `Odd`."""
        text = self.text()
        try:
            return json.loads(text, object_pairs_hook=_pairs, parse_constant=_constant, parse_int=_whole)
        except json.JSONDecodeError as error:
            raise Unusable("not_json", self.file, line=error.lineno, column=error.colno) from None
        except RecursionError:
            raise Unusable("too_deep", self.file) from None

    def text(self) -> str:
        """Read the file as UTF-8; a byte-order mark at its beginning is passed over."""
        try:
            with Path(self.file).open("rb") as stream:
                raw = stream.read(LARGEST + 1)
        except (OSError, ValueError) as error:
            why = (error.strerror if isinstance(error, OSError) else None) or str(error)
            raise Unusable(UNREADABLE.get(type(error), "unreadable_file"), self.file, why=why) from None
        if len(raw) > LARGEST:
            raise Unusable("too_large", self.file, limit=LARGEST)
        try:
            return raw.decode("utf-8").removeprefix("\ufeff")
        except UnicodeDecodeError as error:
            raise Unusable("not_utf8", self.file, byte=error.start) from None

    def fields(self, value: Any, place: str, names: tuple[str, ...]) -> Mapping[str, Any]:
        """Check that a value is an object with these fields and no others."""
        found = self.object(value, place)
        for name in found:
            if name not in names:
                raise Unusable("extra", self.file, _below(place, name), names=", ".join(names))
        for name in names:
            if name not in found:
                raise Unusable("missing", self.file, _below(place, name))
        return found

    def object(self, value: Any, place: str) -> Mapping[str, Any]:
        """Check that a value is an object."""
        if isinstance(value, Odd) and value.key == "repeated":
            raise Unusable("repeated", self.file, place, name=value.name)
        found: dict[str, Any] = self.typed(value, place, dict)
        return found

    def typed(self, value: Any, place: str, kind: type[T]) -> T:
        """Check the type of a value; true and false are no whole numbers."""
        if not isinstance(value, kind) or isinstance(value, bool):
            raise Unusable(WANTED[kind], self.file, place)
        return value

    def exercise(self, item: Mapping[str, Any], place: str) -> str:
        """Check the id of an exercise."""
        name = self.typed(item["exercise"], f"{place}.exercise", str)
        if name not in catalogue.ids():
            raise Unusable("unknown_exercise", self.file, f"{place}.exercise", name=name)
        return name

    def seed(self, item: Mapping[str, Any], place: str) -> int:
        """Check a seed."""
        seed = self.whole(item["seed"], f"{place}.seed")
        if not 0 <= seed <= MAX_SEED:
            raise Unusable("seed_range", self.file, f"{place}.seed", most=MAX_SEED)
        return seed

    def whole(self, value: Any, place: str) -> int:
        """Check a whole number."""
        if isinstance(value, Odd) and value.key == "digits":
            raise Unusable("seed_range", self.file, place, most=MAX_SEED)
        return self.typed(value, place, int)

    def answer(self, value: Any, place: str) -> str:
        """Check an answer: a text, or a list of texts, which are its lines."""
        lines = value if isinstance(value, list) else [value]
        for line in lines:
            if not isinstance(line, str):
                raise Unusable("wants_answer", self.file, place)
        text = "\n".join(lines)
        if len(text) > LONGEST:
            raise Unusable("too_long", self.file, place, limit=LONGEST)
        if any("\ud800" <= sign <= "\udfff" for sign in text):
            raise Unusable("bad_text", self.file, place)
        return text


def _below(place: str, name: str) -> str:
    return f"{place}.{name}" if place else name


def _pairs(pairs: list[tuple[str, Any]]) -> dict[str, Any] | Odd:
    found: dict[str, Any] = {}
    for name, value in pairs:
        if name in found:
            return Odd("repeated", name)
        found[name] = value
    return found


def _constant(text: str) -> Odd:
    return Odd("constant", text)


def _whole(text: str) -> int | Odd:
    return int(text) if len(text) <= DIGITS else Odd("digits")
