/* The machine built joint by joint from the student's own relations, accepted or not.

The projections are zero on true states. What is left of them when all lengths but one are taken away is the share of
that link, so each link stands as the relations put it; the sought names are found by Newton's method. */
import { trueNodes, type Machine, type Point } from "./machine.ts";
import type { Polygon, Vector } from "./relations.ts";
import { compile, namesOf, type Formula, type Values } from "./tree.ts";

export interface Stance {
  nodes: Point[];
  lengths: number[]; // of the links, as the relations make them
  sought: number[];
}

interface Closing {
  sign: number; // towards the last node, or back
  length: Formula;
  angle: Formula;
}

const ROUNDS = 40;
const ENOUGH = 1e-13; // m
const STEP = 1e-6;

export class Student {
  readonly sought: string[];
  private readonly angles: Set<string>;
  private readonly closing: Closing[];
  private readonly lengths: string[]; // all that is taken away to see the share of one link
  private readonly turned: { x: number; y: number };
  private readonly machine: Machine;
  private readonly polygon: Polygon;

  constructor(machine: Machine, polygon: Polygon, known: Values) {
    this.machine = machine;
    this.polygon = polygon;
    const isNew = (name: string): boolean => !known.has(name);
    const vectors = placed(machine, polygon, isNew);
    const closing = vectors.filter(({ length }) => [...namesOf(length)].some(isNew));
    this.angles = new Set(vectors.flatMap(({ angle }) => [...namesOf(angle)].filter(isNew)));
    const named = closing.flatMap(({ length }) => [...namesOf(length)].filter(isNew));
    this.sought = [...new Set([...polygon.names.filter(isNew), ...named])];
    this.lengths = [...machine.links.map(({ length }) => length), ...named];
    this.closing = closing.map((vector) => ({ ...compiled(vector), sign: sense(machine, vector) }));
    this.turned = { x: this.normal("x", known), y: this.normal("y", known) };
  }

  /** Whether a sought name is an angle. */
  isAngle(name: string): boolean {
    return this.angles.has(name);
  }

  /** The values with those of the sought names. */
  with(values: Values, sought: readonly number[]): Values {
    const all = new Map(values);
    this.sought.forEach((name, at) => all.set(name, sought[at] ?? NaN));
    return all;
  }

  /** Solves the relations near a guess; null where they have no solution there. */
  solve(values: Values, guess: readonly number[]): Stance | null {
    const sought = this.newton(values, [...guess]);
    return sought === null ? null : this.stand(values, sought);
  }

  /** Solves the relations at the start from many guesses; the assembly nearest to the true one is kept. */
  begin(values: Values, size: number): Stance | null {
    const truth = trueNodes(this.machine, values);
    const far = ({ nodes }: Stance): number =>
      nodes.reduce((sum, node, at) => sum + Math.hypot(node.x - truth[at]!.x, node.y - truth[at]!.y), 0);
    const found = this.guesses(size).flatMap((guess) => this.solve(values, guess) ?? []);
    return found.sort((one, other) => far(one) - far(other))[0] ?? null;
  }

  /** Where the closing vectors end, for values of the sought names, which are left in the map. */
  end(all: Values, sought: readonly number[]): Point {
    this.sought.forEach((name, at) => all.set(name, sought[at]!));
    const point = { x: 0, y: 0 };
    for (const { sign, length, angle } of this.closing) {
      const [l, a] = [sign * length(all), angle(all)];
      point.x += l * Math.cos(a);
      point.y += l * Math.sin(a);
    }
    return point;
  }

  private guesses(size: number): number[][] {
    const starts = this.sought.map((name) => (this.isAngle(name) ? [-2.6, -1.4, -0.3, 0.3, 1.4, 2.6] : [size / 2]));
    return starts.reduce<number[][]>((all, one) => all.flatMap((begun) => one.map((next) => [...begun, next])), [[]]);
  }

  private stand(values: Values, sought: number[]): Stance {
    const all = this.with(values, sought);
    const real = new Map(this.lengths.map((name) => [name, all.get(name) ?? 0]));
    for (const name of this.lengths) all.set(name, 0);
    const [restX, restY] = [this.polygon.x(all), this.polygon.y(all)];
    const nodes: Point[] = [{ x: 0, y: 0 }];
    const lengths: number[] = [];
    for (const { length } of this.machine.links) {
      all.set(length, real.get(length)!);
      const [x, y] = [this.turned.x * (this.polygon.x(all) - restX), this.turned.y * (this.polygon.y(all) - restY)];
      all.set(length, 0);
      const last = nodes.at(-1)!;
      nodes.push({ x: last.x + x, y: last.y + y });
      lengths.push(Math.hypot(x, y));
    }
    return { nodes, lengths, sought };
  }

  /* With which factor a projection gives the chain: minus one over that of the closing vectors. */
  private normal(axis: "x" | "y", known: Values): number {
    const sought = this.sought.map((name) => (this.isAngle(name) ? (axis === "x" ? 0 : Math.PI / 2) : 1));
    const all = this.with(known, sought);
    for (const { length } of this.machine.links) all.set(length, 0);
    const factor = this.polygon[axis](all) / this.end(all, sought)[axis];
    return Number.isFinite(factor) && Math.abs(factor) > 1e-9 ? -1 / factor : 1;
  }

  private newton(values: Values, u: number[]): number[] | null {
    const all = this.with(values, u);
    const residual = (): [number, number] => [this.polygon.x(all), this.polygon.y(all)];
    if (u.length > 2) return null;
    for (let round = 0; round < ROUNDS; round++) {
      this.sought.forEach((name, at) => all.set(name, u[at]!));
      const f = residual();
      if (!f.every(Number.isFinite)) return null;
      if (Math.hypot(...f) < ENOUGH) return u;
      const columns = this.sought.map((name, at) => {
        all.set(name, u[at]! + STEP);
        const up = residual();
        all.set(name, u[at]! - STEP);
        const down = residual();
        all.set(name, u[at]!);
        return [(up[0] - down[0]) / (2 * STEP), (up[1] - down[1]) / (2 * STEP)] as const;
      });
      const step = columns.length === 2 ? linear(columns[0]!, columns[1]!, f) : [];
      if (step === null) return null;
      if (step.length === 0) return u;
      u = u.map((value, at) => value - step[at]!);
      if (step.every((part) => Math.abs(part) < 1e-12) && Math.hypot(...f) < 1e-9) return u;
    }
    return null;
  }
}

/** Solves a*u + b*v = f for u and v; null where a and b are parallel. */
export function linear(
  a: readonly [number, number],
  b: readonly [number, number],
  f: readonly [number, number],
): [number, number] | null {
  const determinant = a[0] * b[1] - b[0] * a[1];
  if (!(Math.abs(determinant) > 1e-12 * Math.hypot(...a) * Math.hypot(...b))) return null;
  return [(f[0] * b[1] - b[0] * f[1]) / determinant, (a[0] * f[1] - f[0] * a[1]) / determinant];
}

function compiled({ length, angle }: Vector): Omit<Closing, "sign"> {
  return { length: compile(length), angle: compile(angle) };
}

/* A vector to the last node that is projected as the coordinates of this node stands as the two of them. */
function placed(machine: Machine, { vectors, names }: Polygon, isNew: (name: string) => boolean): Vector[] {
  const [start, end] = [machine.links[0]!.start, machine.links.at(-1)!.end];
  const own = new Set(vectors.flatMap(({ length, angle }) => [...namesOf(angle, namesOf(length))]));
  const along = machine.plotted.filter(({ name }) => isNew(name) && names.includes(name) && !own.has(name));
  if (along.length < 2) return vectors;
  const unused = (vector: Vector): boolean => [...namesOf(vector.length)].some((name) => isNew(name) && !names.includes(name));
  const coordinates = along.map(({ axis, name }) => ({ start, end, length: name, angle: axis === "x" ? 0 : Math.PI / 2 }));
  return [...vectors.filter((vector) => !unused(vector)), ...coordinates];
}

/* Nodes in the order of the alphabet lead away from the frame, but the foot of the last node stands before it. */
function sense(machine: Machine, { start, end }: Vector): number {
  const last = machine.links.at(-1)!.end;
  const place = (node: string): number => (node === last ? 100 : node.charCodeAt(0) - 65);
  return place(end) >= place(start) ? 1 : -1;
}

const FAMILIES = new Map([
  ["omega", "angle"], ["w", "angle"], ["epsilon", "angle"], ["eps", "angle"], ["v", "length"], ["a", "length"], ["p", "length"],
]);

/** Which sought name each name of a rate belongs to: as said, by its mark, by its letter, by its axis, else in order. */
export function owners(student: Student, rates: readonly string[], said: Map<string, string>): number[] {
  const free = new Set(student.sought.keys());
  const claim = (fits: (name: string, at: number) => boolean): number => {
    const at = [...free].find((one) => fits(student.sought[one]!, one)) ?? -1;
    free.delete(at);
    return at;
  };
  const first = rates.map((rate) => {
    const marked = said.get(rate) ?? rate;
    return claim((name) => marked === `${name}_d` || marked === `${name}_dd`);
  });
  return first.map((at, k) => {
    if (at >= 0) return at;
    const [, letter = "", rest = ""] = /^([A-Za-z]+?)_?([0-9xyA-Z]*)(?:_d{1,2})?$/.exec(rates[k]!) ?? [];
    const kind = FAMILIES.get(letter);
    const axis = rest.slice(0, 1).toLowerCase();
    const alike = (name: string): boolean => kind === undefined || (kind === "angle") === student.isAngle(name);
    const near = claim((name) => alike(name) && axis !== "" && name.toLowerCase().includes(axis));
    const kin = near >= 0 ? near : claim(alike);
    return kin >= 0 ? kin : claim(() => true);
  });
}
