"""`grubler regrade`: judges again what was handed in to a task set."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from typing import Any

from cli import store
from cli.problems import language, say
from server import run as server

PASSED, OUR_FAULT = 0, 3
COUNTS = ("judged", "same", "raised", "lowered", "withheld", "reworded", "stale")


def arguments(parser: ArgumentParser) -> None:
    """Add the arguments of the command."""
    store.arguments(parser)
    parser.add_argument("--task-set", metavar="ID", required=True, help="the set, by its number")
    parser.add_argument("--dry-run", action="store_true", help="only tell what would change")
    parser.add_argument("--allow-lower", action="store_true", help="let a lower score replace a higher one")
    parser.add_argument("--recompute-references", action="store_true", help="solve the dealt givens anew where the "
                        "installed exercise does not lead to what was kept")  # fmt: skip
    parser.add_argument("--format", choices=("text", "json"), default="text", help="how to print (default: text)")
    language(parser)


def run(options: Namespace) -> int:
    """Print every change in a line, then how many there are of each kind."""
    told = _as_json if options.format == "json" else _as_text(options.lang)
    with store.usable():
        wish = {name: getattr(options, name) for name in ("dry_run", "allow_lower", "recompute_references")}
        job = server.regrade(store.settings(options), options.task_set, told, **wish)
    if job.state != "done":
        print(say(options.lang, "regrade_failed", number=job.id))
        return OUR_FAULT
    if options.format == "json":
        print(json.dumps({"job": job.id, "dry_run": job.payload["dry_run"], "counts": job.result}))
    else:
        print(say(options.lang, "regraded", **{name: job.result[name] for name in COUNTS}))
        if options.recompute_references:
            print(say(options.lang, "recomputed", number=job.result["recomputed"]))
    return PASSED


def _as_json(change: Mapping[str, Any]) -> None:
    print(json.dumps(change, ensure_ascii=False, sort_keys=True))


def _as_text(lang: str) -> Any:
    def told(change: Mapping[str, Any]) -> None:
        if "steps" in change:
            values = (f"{one['name']}: {one['old']} -> {one['new']}" for one in (*change["steps"], *change["texts"]))
            print("; ".join([change["code"], *values]))
            return
        scores = f"{change['old']:.3g} -> {change['new']:.3g}"
        answers = (f"{one['name']}: {_code(one['old'])} -> {_code(one['new'])}" for one in change["answers"])
        stale = [say(lang, "needs_regrade")] if change["stale"] else []
        print("; ".join([f"{change['receipt']} {change['effect']} {scores}", *answers, *stale]))

    return told


def _code(said: Mapping[str, Any] | None) -> str:
    return said["code"] if said else "-"
