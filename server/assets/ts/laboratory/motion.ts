/* A motion over time: the true one, the student's, and the numerical derivatives of the student's own curves. */
import { reach, trueNodes, valuesAt, type Machine, type Point } from "./machine.ts";
import { endAcceleration, endVelocity, solveRates } from "./rates.ts";
import type { Polygon, Rates } from "./relations.ts";
import { Student, type Stance } from "./student.ts";
import type { Formula, Values } from "./tree.ts";

export interface Own {
  polygon: Polygon | null;
  velocities: Rates | null;
  accelerations: Rates | null;
  formulas: Map<string, Formula>; // by the name of the rate: v_x, a_y
}

export interface Moment {
  t: number;
  truth: Point[];
  stance: Stance | null;
  velocity: Point | null;
  acceleration: Point | null;
}

export const NOTHING: Own = { polygon: null, velocities: null, accelerations: null, formulas: new Map() };
const SAMPLES = 60; // steps of the curves

export class Motion {
  readonly moments: Moment[];
  readonly machine: Machine;
  private readonly start: Values;
  private readonly own: Own;
  private readonly student: Student | null;

  constructor(machine: Machine, start: Values, own: Own) {
    this.machine = machine;
    this.start = start;
    this.own = own;
    const values = valuesAt(machine, start, 0);
    this.student = own.polygon === null ? null : new Student(machine, own.polygon, values);
    let guess = this.student?.begin(values, reach(machine, start))?.sought ?? null;
    this.moments = [];
    for (let k = 0; k <= SAMPLES; k++) {
      const moment = this.find((machine.span * k) / SAMPLES, guess);
      guess = moment.stance?.sought ?? guess;
      this.moments.push(moment);
    }
  }

  /** The motion at any time of the span. */
  at(t: number): Moment {
    const near = this.moments[Math.min(SAMPLES, Math.max(0, Math.round((t / this.machine.span) * SAMPLES)))]!;
    return this.find(t, near.stance?.sought ?? null);
  }

  /** The student's own curve, its values at the samples; NaN where there is none. */
  curve(kind: "position" | "velocity" | "acceleration", axis: "x" | "y"): number[] {
    return this.moments.map((moment) => valueOf(moment, kind, axis));
  }

  /** What the student's curve is laid over: the true position, or the derivative of the student's previous curve. */
  under(kind: "position" | "velocity" | "acceleration", axis: "x" | "y"): number[] {
    if (kind === "position") return this.moments.map(({ truth }) => truth.at(-1)![axis]);
    return derivative(this.curve(kind === "velocity" ? "position" : "velocity", axis), this.machine.span / SAMPLES);
  }

  private find(t: number, guess: readonly number[] | null): Moment {
    const values = valuesAt(this.machine, this.start, t);
    const truth = trueNodes(this.machine, values);
    const stance = guess === null ? null : (this.student?.solve(values, guess) ?? null);
    return { t, truth, stance, ...this.rates(values, stance) };
  }

  private rates(values: Values, stance: Stance | null): Pick<Moment, "velocity" | "acceleration"> {
    const all = stance === null ? values : this.student!.with(values, stance.sought);
    const { velocities, accelerations } = this.own;
    const first = stance && velocities ? solveRates(this.student!, velocities, all, 1) : null;
    const second = stance && accelerations && first ? solveRates(this.student!, accelerations, first.values, 2) : null;
    const speed = first && (this.named(first.values, "rate") ?? endVelocity(this.student!, values, stance!.sought, first.rates));
    const push = first && second &&
      (this.named(second.values, "surge") ?? endAcceleration(this.student!, values, stance!.sought, first.rates, second.rates));
    return { velocity: speed ?? this.written(all, "rate"), acceleration: push ?? this.written(all, "surge") };
  }

  /* The components of the last node, where the differentiated projections hold them under their own names. */
  private named(solved: Values, kind: "rate" | "surge"): Point | null {
    const value = (axis: "x" | "y"): number => solved.get(this.machine.plotted.find((one) => one.axis === axis)?.[kind] ?? "") ?? NaN;
    const point = { x: value("x"), y: value("y") };
    return Number.isFinite(point.x + point.y) ? point : null;
  }

  /* The formulas of section 12, where the differentiated projections are not there yet. */
  private written(values: Values, kind: "rate" | "surge"): Point | null {
    const point = { x: NaN, y: NaN };
    for (const plotted of this.machine.plotted) {
      point[plotted.axis] = this.own.formulas.get(plotted[kind])?.(values) ?? NaN;
    }
    return Number.isFinite(point.x) || Number.isFinite(point.y) ? point : null;
  }
}

export function valueOf(moment: Moment, kind: "position" | "velocity" | "acceleration", axis: "x" | "y"): number {
  if (kind === "position") return moment.stance?.nodes.at(-1)![axis] ?? NaN;
  return moment[kind]?.[axis] ?? NaN;
}

/** Speed of the last node: from the student's velocities, else from the student's own positions. */
export function speed(motion: Motion, t: number): number {
  const { velocity } = motion.at(t);
  if (velocity !== null && Number.isFinite(velocity.x + velocity.y)) return Math.hypot(velocity.x, velocity.y);
  const h = motion.machine.span * 1e-4;
  const [before, after] = [Math.max(0, t - h), Math.min(motion.machine.span, t + h)];
  const [a, b] = [motion.at(before), motion.at(after)];
  const gone = (axis: "x" | "y"): number => valueOf(b, "position", axis) - valueOf(a, "position", axis);
  return Math.hypot(gone("x"), gone("y")) / (after - before);
}

const INNER = [1, -8, 0, 8, -1].map((weight) => weight / 12);
const FIRST = [-25, 48, -36, 16, -3].map((weight) => weight / 12);
const NEXT = [-3, -10, 18, -6, 1].map((weight) => weight / 12);

/** Derivative of evenly spaced values by five points, of fourth order up to the ends. */
export function derivative(values: readonly number[], step: number): number[] {
  const count = values.length;
  const sum = (weights: readonly number[], from: number, way: 1 | -1): number =>
    (weights.reduce((all, weight, k) => all + (weight === 0 ? 0 : weight * values[from + way * k]!), 0) * way) / step;
  return values.map((_, at) => {
    if (at === 0) return sum(FIRST, 0, 1);
    if (at === 1) return sum(NEXT, 0, 1);
    if (at === count - 1) return sum(FIRST, count - 1, -1);
    if (at === count - 2) return sum(NEXT, count - 1, -1);
    return sum(INNER, at - 2, 1);
  });
}
