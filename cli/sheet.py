"""`grubler sheet`: printable tasks for a class, and the key in a file of its own."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, ArgumentTypeError, Namespace

from cli.draw import known, seed_of
from cli.report import output_arguments, write
from exercises.variants import MAX_SEED, deal
from reports import formats, sheets

MOST = 500
STEP = 20  # sheets between two words of progress


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("exercise", metavar="ID", help="id of the exercise")
    parser.add_argument(
        "--count", type=_count, default=1, metavar="N", help=f"number of sheets, at most {MOST} (default: 1)"
    )
    parser.add_argument(
        "--seed", default="0", metavar="N", help="seed of the first sheet; the next ones follow (default: 0)"
    )
    parser.add_argument("--key", metavar="FILE", help="also write the answers of all sheets, for the lecturer")
    output_arguments(parser)


def run(options: Namespace) -> int:
    """Write the sheets, then the key; progress goes to standard error."""
    exercise, first = known(options.exercise), seed_of(options.seed)
    dealt = []
    for number in range(options.count):
        seed = (first + number) % (MAX_SEED + 1)
        dealt.append(sheets.sheet(str(seed), deal(exercise, seed), options.lang))
        if (number + 1) % STEP == 0:
            print(f"{number + 1}/{options.count}", file=sys.stderr, flush=True)
    write(options.output, formats.written(sheets.sheets(dealt, options.lang), options.format))
    if options.key:
        write(options.key, formats.written(sheets.key(dealt, options.lang), options.format))
    return 0


def _count(text: str) -> int:
    if not (text.isascii() and text.isdecimal() and 0 < int(text) <= MOST):
        raise ArgumentTypeError(f"{text!r} is not a whole number from 1 to {MOST}")
    return int(text)
