"""The catalogue: exercises are found as folders `exercises/<chapter>/<id>/`; an incomplete folder is refused loudly."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from exercises.exercise import AnyExercise, Exercise
from graders.words import LANGUAGES

if TYPE_CHECKING:
    from exercises.words import Words
    from figures.picture import Picture

ROOT = Path(__file__).parent
FILES = ("__init__.py", *(f"{language}.toml" for language in LANGUAGES), "cases.toml")
CHAPTERS = (
    "linkages", "manipulators", "structure", "velocities", "laws", "transmissions", "accuracy", "dynamics", "balancing",
    "strength",
)  # fmt: skip


class UnknownExercise(KeyError):
    """No exercise has this id."""


class IncompleteExercise(ValueError):
    """An exercise folder lacks a file or its definition."""


class Spoken(Mapping[str, "Words"]):
    """The words of an exercise by language, each file read when it is first spoken."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._read: dict[str, Words] = {}

    def __getitem__(self, language: str) -> Words:
        if language not in LANGUAGES:
            raise KeyError(language)
        if language not in self._read:
            from exercises.words import read_words  # grading by numbers needs no words

            self._read[language] = read_words(self._folder / f"{language}.toml")
        return self._read[language]

    def __iter__(self) -> Iterator[str]:
        return iter(LANGUAGES)

    def __len__(self) -> int:
        return len(LANGUAGES)


@dataclass(frozen=True, slots=True)
class Entry:
    """An exercise with its place on the shelf and its words."""

    id: str
    chapter: str
    exercise: AnyExercise
    words: Mapping[str, Words]
    folder: Path

    def picture(self, givens: Any, lang: str) -> Picture | None:
        """Draw the figure of a variant by the function `figure` in the folder's `figure.py`, if there is one."""
        if not (self.folder / "figure.py").is_file():
            return None
        drawn: Picture = import_module(f"exercises.{self.chapter}.{self.id}.figure").figure(
            givens, self.words[lang]["figure"], lang
        )
        return drawn

    def polygon(self, givens: Any, title: str, vectors: Sequence[tuple[str, str, str]]) -> Picture | None:
        """Draw a student's vectors by the function `polygon` in the folder's `figure.py`, if there is one."""
        module = import_module(f"exercises.{self.chapter}.{self.id}.figure")
        drawn: Picture | None = module.polygon(givens, title, vectors) if hasattr(module, "polygon") else None
        return drawn


@lru_cache(maxsize=1)
def _shelf() -> dict[str, str]:
    """Find the folders; the order is that of the chapters, then of the ids.

    A folder whose name begins with an underscore is no exercise: some exercises of the chapter share it.
    """
    found: dict[str, str] = {}
    for chapter in CHAPTERS:
        for folder in sorted((ROOT / chapter).glob("*/")):
            if folder.name.startswith(("_", ".")):
                continue
            missing = [name for name in FILES if not (folder / name).is_file()]
            if missing:
                raise IncompleteExercise(f"exercise folder {chapter}/{folder.name} lacks {', '.join(missing)}")
            if folder.name in found:
                raise IncompleteExercise(f"exercise id {folder.name} stands in {found[folder.name]} and in {chapter}")
            found[folder.name] = chapter
    return found


def ids() -> tuple[str, ...]:
    """Give all exercise ids, by chapter, without importing them."""
    return tuple(_shelf())


def chapter_of(exercise_id: str) -> str:
    """Give the chapter of an exercise; raises UnknownExercise."""
    try:
        return _shelf()[exercise_id]
    except KeyError:
        raise UnknownExercise(exercise_id) from None


@lru_cache(maxsize=512)
def load(exercise_id: str) -> Entry:
    """Import one exercise with its words.

    Raises:
        UnknownExercise: No folder has this name.
        IncompleteExercise: The folder defines no EXERCISE.
    """
    chapter = chapter_of(exercise_id)
    exercise = getattr(import_module(f"exercises.{chapter}.{exercise_id}"), "EXERCISE", None)
    if not isinstance(exercise, Exercise):
        raise IncompleteExercise(f"exercise folder {chapter}/{exercise_id} defines no EXERCISE")
    folder = ROOT / chapter / exercise_id
    return Entry(exercise_id, chapter, exercise, Spoken(folder), folder)


def check() -> None:
    """Import every exercise, so that an incomplete folder stops the start."""
    for exercise_id in ids():
        entry = load(exercise_id)
        for language in LANGUAGES:
            entry.words[language]
