/* The student's own velocities and accelerations: the differentiated projections solved for the sought rates. */
import type { Point } from "./machine.ts";
import type { Rates } from "./relations.ts";
import { linear, owners, type Student } from "./student.ts";
import type { Values } from "./tree.ts";

const STEP = 1e-4;

export interface Solved {
  values: Values; // with the rates under the names that the student gave them and under the marked ones
  rates: number[]; // of the sought names, in their order
}

/** Solves differentiated projections for two new names; null where there are not two, or they cannot be found. */
export function solveRates(student: Student, rates: Rates, values: Values, order: 1 | 2): Solved | null {
  const fresh = rates.names.filter((name) => !values.has(name));
  if (fresh.length !== 2 || student.sought.length !== 2) return null;
  const all = new Map(values);
  const at = (one: number, other: number): [number, number] => {
    all.set(fresh[0]!, one);
    all.set(fresh[1]!, other);
    return [rates.x(all), rates.y(all)];
  };
  const rest = at(0, 0);
  const [a, b] = [minus(at(1, 0), rest), minus(at(0, 1), rest)];
  const found = linear(a, b, [-rest[0], -rest[1]]);
  if (found === null || !found.every(Number.isFinite)) return null;
  at(...found);
  const solved = [NaN, NaN];
  owners(student, fresh, rates.said).forEach((owner, k) => (solved[owner] = found[k]!));
  student.sought.forEach((name, k) => all.set(`${name}${order === 1 ? "_d" : "_dd"}`, solved[k]!));
  return { values: all, rates: solved };
}

const minus = (a: [number, number], b: [number, number]): [number, number] => [a[0] - b[0], a[1] - b[1]];

/** Velocity of the end of the closing vectors: how it moves when the sought names change at their rates. */
export function endVelocity(student: Student, values: Values, u: readonly number[], rates: readonly number[]): Point {
  const all = new Map(values);
  const at = (step: number): Point => student.end(all, u.map((value, k) => value + step * rates[k]!));
  const [up, down] = [at(STEP), at(-STEP)];
  return { x: (up.x - down.x) / (2 * STEP), y: (up.y - down.y) / (2 * STEP) };
}

/** Acceleration of the same end. */
export function endAcceleration(
  student: Student,
  values: Values,
  u: readonly number[],
  rates: readonly number[],
  surges: readonly number[],
): Point {
  const all = new Map(values);
  const at = (step: number): Point =>
    student.end(all, u.map((value, k) => value + step * rates[k]! + (step * step * surges[k]!) / 2));
  const [up, here, down] = [at(STEP), at(0), at(-STEP)];
  const second = (axis: "x" | "y"): number => (up[axis] - 2 * here[axis] + down[axis]) / STEP ** 2;
  return { x: second("x"), y: second("y") };
}
