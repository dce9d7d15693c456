/* The true motion: coordinates by constant acceleration, bodies by nested turns and shifts of the givens. */
import type { Values } from "./tree.ts";

export interface Pair {
  kind: "turn" | "slide";
  coordinate: string;
  behind: string;
  datum: number; // number of the body from which a turn is measured, 0 for the frame
  turn: number; // rad, of the guide in the body before
}

export interface Link {
  length: string;
  start: string;
  end: string;
  slides: boolean;
  called: [string, string, string]; // what the task calls its direction and the rates of that
}

export interface Machine {
  drives: { name: string; rate: string; surge: string }[];
  pairs: Pair[];
  links: Link[];
  plotted: { axis: "x" | "y"; name: string; rate: string; surge: string }[];
  span: number; // s
  tip: string;
  rod: string;
  values: Record<string, number>;
}

export interface Point {
  x: number;
  y: number;
}

interface Body extends Point {
  angle: number;
  spin: number;
  surge: number;
}

const FRAME: Body = { x: 0, y: 0, angle: 0, spin: 0, surge: 0 };

/** A place at a distance from another, in a direction. */
export function shifted(from: Point, length: number, angle: number): Point {
  return { x: from.x + length * Math.cos(angle), y: from.y + length * Math.sin(angle) };
}

/** Everything the task names, t seconds after the moment of the givens: q + q' t + q'' t^2 / 2. */
export function valuesAt(machine: Machine, start: Values, t: number): Values {
  const values = new Map(start);
  for (const { name, rate, surge } of machine.drives) {
    const [q, v, a] = [start.get(name)!, start.get(rate) ?? 0, start.get(surge) ?? 0];
    values.set(name, q + v * t + (a * t * t) / 2);
    values.set(rate, v + a * t);
  }
  bodies(machine, values).forEach((body, at) => {
    const called = machine.links[at]?.called ?? ["", "", ""];
    [body.angle, body.spin, body.surge].forEach((value, k) => {
      if (called[k] !== undefined && called[k] !== "") values.set(called[k], value);
    });
  });
  return values;
}

/* Body i stands behind pair i; its origin is the pair, its axis the direction of what follows. */
function bodies(machine: Machine, values: Values): Body[] {
  const all: Body[] = [FRAME];
  for (const pair of machine.pairs) {
    const before = all.at(-1)!;
    const base = shifted(before, values.get(pair.behind) ?? 0, before.angle);
    const drive = machine.drives.find(({ name }) => name === pair.coordinate)!;
    const q = values.get(drive.name)!;
    if (pair.kind === "turn") {
      const datum = all[pair.datum]!;
      const spin = datum.spin + (values.get(drive.rate) ?? 0);
      all.push({ ...base, angle: datum.angle + q, spin, surge: datum.surge + (values.get(drive.surge) ?? 0) });
    } else {
      const angle = before.angle + pair.turn;
      all.push({ ...shifted(base, q, angle), angle, spin: before.spin, surge: before.surge });
    }
  }
  return all.slice(1);
}

/** The true places of the nodes, in the order of the links; NaN where a rod cannot reach its guide. */
export function trueNodes(machine: Machine, values: Values): Point[] {
  const all = bodies(machine, values);
  const nodes: Point[] = [FRAME];
  machine.pairs.slice(1).forEach((pair, at) => {
    const body = all[at]!;
    nodes.push(shifted(body, values.get(pair.behind) ?? 0, body.angle));
  });
  const last = all.at(-1)!;
  nodes.push(shifted(last, values.get(machine.tip) ?? 0, last.angle));
  if (machine.rod !== "") {
    const pin = nodes.at(-1)!;
    nodes.push({ x: pin.x + Math.sqrt(values.get(machine.rod)! ** 2 - pin.y ** 2), y: 0 });
  }
  return nodes.map(({ x, y }) => ({ x, y }));
}

/** The longest the chain can become: all lengths in a line. */
export function reach(machine: Machine, start: Values): number {
  return machine.links.reduce((sum, link) => sum + Math.abs(start.get(link.length) ?? 0), 0);
}
