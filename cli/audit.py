"""`grubler audit`: checks that no line of the audit log was changed or removed."""

from __future__ import annotations

import re
from argparse import ArgumentParser, Namespace

from cli import store
from cli.problems import Unusable, language, say
from server import run as server
from server.storage.audit import End

PASSED, BROKEN = 0, 1
END = re.compile(r"([0-9]{1,18}) ([0-9a-f]{64})")


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    parser.add_argument("--end", metavar="END", help="what an earlier check printed: that line must still be there")
    store.arguments(parser)
    language(parser)


def run(options: Namespace) -> int:
    """Print the end of the log, number and digest, to be kept elsewhere; where a line does not fit, say which."""
    earlier = None if options.end is None else _end(options.end)
    with store.usable():
        checked = server.check_log(store.settings(options), earlier)
    if checked.broken is not None:
        print(say(options.lang, "audit_broken", number=checked.broken))
        return BROKEN
    print(checked.end)
    return PASSED


def _end(text: str) -> End:
    found = END.fullmatch(text.strip())
    if found is None:
        raise Unusable("audit_end")
    return End(int(found[1]), found[2])
