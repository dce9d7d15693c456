/* Replays motions in Node for tests and measurements: cases as JSON on standard input, one result a case as JSON. */
import { readFileSync } from "node:fs";

import { distance } from "./check.ts";
import { valuesAt, type Machine } from "./machine.ts";
import { Motion, speed } from "./motion.ts";
import { readPolygon, readRates } from "./relations.ts";

interface Case {
  machine: Machine;
  polygon: unknown;
  velocities: unknown;
  accelerations: unknown;
  frames: number;
  doubled: string;
}

function replay({ machine, polygon, velocities, accelerations, frames, doubled }: Case): object {
  const given = new Map(Object.entries(machine.values));
  const own = {
    polygon: readPolygon(polygon),
    velocities: readRates(velocities),
    accelerations: readRates(accelerations),
    formulas: new Map(),
  };
  const motion = new Motion(machine, given, own);
  const residual = Math.max(...motion.moments.map((moment) => (moment.stance === null ? Infinity : distance(moment))));
  const times: number[] = [];
  for (let k = 0; k < frames; k++) {
    const [t, begun] = [(machine.span * k) / frames, performance.now()];
    motion.at(t);
    valuesAt(machine, given, t);
    times.push(performance.now() - begun);
  }
  times.sort((one, other) => one - other);
  const first = motion.moments[0]!;
  const longer = new Map(given).set(doubled, 2 * (given.get(doubled) ?? NaN));
  return {
    residual,
    p95: times[Math.floor(0.95 * frames)] ?? null,
    nodes: first.stance?.nodes,
    lengths: first.stance?.lengths,
    velocity: first.velocity,
    acceleration: first.acceleration,
    ratio: speed(new Motion(machine, longer, own), 0) / speed(motion, 0),
  };
}

console.log(JSON.stringify((JSON.parse(readFileSync(0, "utf8")) as Case[]).map(replay)));
