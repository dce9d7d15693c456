"""`grubler report tmm2`: the report of laboratory TMM-2 as a document, empty or with a student's answers."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path

from cli.draw import known, seed_of
from cli.problems import Unusable, language
from cli.reading import read_answers
from exercises.exercise import Submission, Variant
from exercises.grading import grade
from exercises.variants import deal
from reports import formats
from reports.tmm2 import HandedIn, NoReport, Person, tmm2


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("form", choices=("tmm2",), help="the form of the report")
    parser.add_argument("--exercise", required=True, metavar="ID", help="id of a laboratory exercise")
    parser.add_argument("--seed", required=True, metavar="N", help="seed of the variant")
    parser.add_argument("--answers", metavar="FILE", help="answers file; its item of this variant fills the sections")
    parser.add_argument("--name", default="", help="name of the student")
    parser.add_argument("--group", default="", help="group of the student")
    output_arguments(parser)


def output_arguments(parser: ArgumentParser) -> None:
    """Add format, file and language of a document."""
    parser.add_argument(
        "--format", choices=formats.FORMATS, default="pdf", help="format of the document (default: pdf)"
    )
    parser.add_argument("--output", required=True, metavar="FILE", help="file to write")
    language(parser)


def run(options: Namespace) -> int:
    """Write the report."""
    variant = deal(known(options.exercise), seed_of(options.seed))
    handed = _handed(variant, options.answers) if options.answers else None
    try:
        report = tmm2(variant, options.lang, Person(options.name, options.group), str(variant.seed), handed)
    except NoReport as error:
        raise Unusable("no_report", name=error) from None
    write(options.output, formats.written(report, options.format))
    return 0


def _handed(variant: Variant, file: str) -> HandedIn:
    """Grade the item of this variant in an answers file."""
    for item in read_answers(file):
        if (item.exercise, item.seed) == (variant.exercise, variant.seed):
            found = grade(Submission(variant, item.answers))
            outcomes = {name: str(verdict.outcome) for name, verdict in found.verdicts.items()}
            return HandedIn(item.answers, outcomes, score=found.score)
    raise Unusable("absent_item", file=file, name=variant.exercise, seed=variant.seed)


def write(file: str, content: bytes) -> None:
    """Write a file whole; raises Unusable."""
    try:
        Path(file).write_bytes(content)
    except OSError as error:
        raise Unusable("not_written", file=file, why=error.strerror or error) from None
