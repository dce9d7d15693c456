/* What the preview says of a relation, read in its declared shape. */
import { compile, namesOf, readTree, type Formula, type Tree } from "./tree.ts";

export interface Vector {
  start: string;
  end: string;
  length: Tree;
  angle: Tree;
}

export interface Pairwise {
  x: Formula; // zero where the relation holds
  y: Formula;
  names: string[]; // in the order in which they come
}

export interface Polygon extends Pairwise {
  vectors: Vector[];
}

export interface Rates extends Pairwise {
  said: Map<string, string>;
}

type Fields = Record<string, unknown>;
const isFields = (wire: unknown): wire is Fields => typeof wire === "object" && wire !== null && !Array.isArray(wire);

function readPairwise(wire: unknown): Pairwise | null {
  if (!Array.isArray(wire)) return null;
  const trees = new Map<string, Tree>();
  for (const one of wire) {
    const tree = isFields(one) ? readTree(one["zero"]) : null;
    if (tree === null) return null;
    const axis = String((one as Fields)["axis"]) || (trees.has("x") ? "y" : "x");
    if (!trees.has(axis)) trees.set(axis, tree);
  }
  const [x, y] = [trees.get("x"), trees.get("y")];
  if (x === undefined || y === undefined) return null;
  return { x: compile(x), y: compile(y), names: [...namesOf(y, namesOf(x))] };
}

function readVector(wire: unknown): Vector | null {
  if (!isFields(wire)) return null;
  const [length, angle] = [readTree(wire["length"]), readTree(wire["angle"])];
  return length === null || angle === null
    ? null
    : { start: String(wire["start"]), end: String(wire["end"]), length, angle };
}

/** The polygon in a reply; null where it has not both projections. */
export function readPolygon(wire: unknown): Polygon | null {
  if (!isFields(wire) || !Array.isArray(wire["vectors"])) return null;
  const [pair, vectors] = [readPairwise(wire["equations"]), wire["vectors"].map(readVector)];
  if (pair === null || vectors.some((vector) => vector === null)) return null;
  return { ...pair, vectors: vectors as Vector[] };
}

/** The differentiated projections in a reply; null where one of them is missing. */
export function readRates(wire: unknown): Rates | null {
  const pair = isFields(wire) ? readPairwise(wire["equations"]) : null;
  if (pair === null) return null;
  const said = Array.isArray((wire as Fields)["said"]) ? ((wire as Fields)["said"] as [string, string][]) : [];
  return { ...pair, said: new Map(said) };
}

/** The one formula in a reply. */
export function readFormula(wire: unknown): Formula | null {
  const tree = isFields(wire) && wire["formula"] !== undefined ? readTree(wire["formula"]) : null;
  return tree === null ? null : compile(tree);
}
