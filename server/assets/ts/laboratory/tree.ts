/* Formulas as the preview sends them: a number, a name, or an operation over formulas. No text is ever run. */

export type Tree = number | string | readonly [string, ...Tree[]];
export type Values = Map<string, number>;
export type Formula = (values: Values) => number;

const DEEPEST = 200;
const DEGREE = Math.PI / 180;

type Operation = (...of: number[]) => number;
const OPERATIONS = new Map<string, Operation>([
  ["+", (a, b) => a! + b!],
  ["-", (a, b) => a! - b!],
  ["*", (a, b) => a! * b!],
  ["/", (a, b) => a! / b!],
  ["^", (a, b) => Math.pow(a!, b!)],
  ["negate", (a) => -a!],
  ["degrees", (a) => a! * DEGREE],
  ["sin", (a) => Math.sin(a!)],
  ["cos", (a) => Math.cos(a!)],
  ["tan", (a) => Math.tan(a!)],
  ["cot", (a) => 1 / Math.tan(a!)],
  ["asin", (a) => Math.asin(a!)],
  ["acos", (a) => Math.acos(a!)],
  ["atan", (a) => Math.atan(a!)],
  ["acot", (a) => Math.PI / 2 - Math.atan(a!)],
  ["atan2", (a, b) => Math.atan2(a!, b!)],
  ["sinh", (a) => Math.sinh(a!)],
  ["cosh", (a) => Math.cosh(a!)],
  ["tanh", (a) => Math.tanh(a!)],
  ["exp", (a) => Math.exp(a!)],
  ["ln", (a) => Math.log(a!)],
  ["log", (a, base) => (base === undefined ? Math.log10(a!) : Math.log(a!) / Math.log(base))],
  ["sqrt", (a) => Math.sqrt(a!)],
  ["root", (a, n) => Math.pow(a!, 1 / n!)],
  ["abs", (a) => Math.abs(a!)],
  ["sign", (a) => Math.sign(a!)],
  ["min", (...all) => Math.min(...all)],
  ["max", (...all) => Math.max(...all)],
  ["macaulay", (a, n) => (a! < 0 ? 0 : Math.pow(a!, n!))],
]);

/** The formula in a reply; null for anything else. */
export function readTree(wire: unknown, depth = 0): Tree | null {
  if (typeof wire === "number" || typeof wire === "string") return wire;
  if (!Array.isArray(wire) || depth > DEEPEST || !OPERATIONS.has(wire[0] as string) || wire.length < 2) return null;
  const parts = wire.slice(1).map((part) => readTree(part, depth + 1));
  return parts.some((part) => part === null) ? null : [wire[0] as string, ...(parts as Tree[])];
}

/** The names in a formula, pi left out. */
export function namesOf(tree: Tree, found = new Set<string>()): Set<string> {
  if (typeof tree === "string" && tree !== "pi") found.add(tree);
  if (Array.isArray(tree)) for (const part of tree.slice(1)) namesOf(part as Tree, found);
  return found;
}

/** A function that computes the formula; a name without a value makes it NaN. */
export function compile(tree: Tree): Formula {
  if (typeof tree === "number") return () => tree;
  if (tree === "pi") return () => Math.PI;
  if (typeof tree === "string") return (values) => values.get(tree) ?? NaN;
  const operation = OPERATIONS.get(tree[0])!;
  const [first, second, ...more] = tree.slice(1).map((part) => compile(part as Tree));
  if (second === undefined) return (values) => operation(first!(values));
  if (more.length === 0) return (values) => operation(first!(values), second(values));
  return (values) => operation(first!(values), second(values), ...more.map((part) => part(values)));
}
