"""`grubler new`: starts an exercise from a small one that already passes the gate, to be rewritten line by line."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from importlib import invalidate_caches
from keyword import iskeyword
from pathlib import Path

from cli.problems import Unusable, language
from exercises import catalogue, verifying

TEMPLATE = Path(__file__).parent / "template"
LONGEST = 40
NO_DIGEST = "0" * 16


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("exercise", metavar="ID", help="id of the new exercise; it never changes")
    shelf = "chapter it stands in (default: strength)"
    parser.add_argument("--chapter", choices=catalogue.CHAPTERS, default="strength", help=shelf)
    language(parser)


def run(options: Namespace) -> int:
    """Make the folder and print its path."""
    folder = scaffold(catalogue.ROOT, options.chapter, options.exercise)
    _store_digest(folder)
    print(folder)
    return 0


def scaffold(root: Path, chapter: str, exercise: str) -> Path:
    """Write the files of a new exercise.

    Args:
        root: The room of the exercises.
        chapter: Its chapter; the folder is made where it is the first.
        exercise: Its id.

    Returns:
        The new folder.

    Raises:
        Unusable: The id is not a good name or is taken, or the folder cannot be made.
    """
    _check_id(root, exercise)
    folder = root / chapter / exercise
    try:
        folder.mkdir(parents=True)
        shelf = root / chapter / "__init__.py"
        if not shelf.exists():
            shelf.write_text(f'"""{chapter.capitalize()}."""\n', "utf-8")
        for source in sorted(TEMPLATE.iterdir()):
            (folder / source.name.removesuffix(".txt")).write_text(_filled(source, chapter, exercise), "utf-8")
    except OSError as error:
        raise Unusable("not_writable", str(folder), why=error.strerror or error) from None
    return folder


def _filled(source: Path, chapter: str, exercise: str) -> str:
    text = source.read_text("utf-8").replace("EXERCISE_ID", exercise).replace("CHAPTER", chapter)
    return text.replace("EXERCISE-ID", exercise.replace("_", "-").strip("-"))


def _check_id(root: Path, exercise: str) -> None:
    plain = exercise.isascii() and exercise.isidentifier() and exercise == exercise.lower()
    if not plain or exercise.startswith("_") or iskeyword(exercise) or len(exercise) > LONGEST:
        raise Unusable("bad_id", place=exercise)
    for chapter in sorted(root.iterdir()):
        if (chapter / exercise).is_dir():
            raise Unusable("taken", place=exercise, chapter=chapter.name)


def _store_digest(folder: Path) -> None:
    """Write the digest of the template's variants under the new name beside them."""
    invalidate_caches()
    cases = folder / "cases.toml"
    digest = verifying.digest(folder.name)
    cases.write_text(cases.read_text("utf-8").replace(NO_DIGEST, digest), "utf-8")
