/* What the machine shows at a moment, in one sentence: broken links first, then a node that goes astray. */
import type { Machine } from "./machine.ts";
import type { Moment } from "./motion.ts";
import type { Values } from "./tree.ts";

const STRETCHED = 2e-3; // of its length: a link changes it
const ASTRAY = 2e-3; // of the longest link

export interface Broken {
  at: number;
  own: number;
  true: number;
}

export type Finding =
  | { kind: "nothing" | "unread" | "unsolved" | "agrees" | "held" }
  | { kind: "broken"; links: Broken[] }
  | { kind: "astray"; distance: number };

/** The links whose length the relations change. */
export function broken(machine: Machine, moment: Moment, values: Values): Broken[] {
  return (moment.stance?.lengths ?? []).flatMap((own, at) => {
    const length = Math.abs(values.get(machine.links[at]!.length)!);
    return Math.abs(own - length) > STRETCHED * length ? [{ at, own, true: length }] : [];
  });
}

/** How far the last node is from the true motion. */
export function distance(moment: Moment): number {
  const [own, truth] = [moment.stance?.nodes.at(-1), moment.truth.at(-1)];
  return own === undefined || truth === undefined ? NaN : Math.hypot(own.x - truth.x, own.y - truth.y);
}

/** Says what is to be told at a moment. */
export function finding(machine: Machine, moment: Moment, values: Values, typed: boolean): Finding {
  if (!typed) return { kind: "nothing" };
  if (moment.stance === null) return { kind: "unsolved" };
  const links = broken(machine, moment, values);
  if (links.length > 0) return { kind: "broken", links };
  const size = Math.max(...machine.links.map(({ length }) => Math.abs(values.get(length)!)));
  const far = distance(moment);
  return far > ASTRAY * size ? { kind: "astray", distance: far } : { kind: "agrees" };
}
