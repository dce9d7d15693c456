/* A diagram as places with ordinates on both sides and half-way to the next place: the rows of its table. */

export interface Place {
  x: number;
  left: number;
  right: number | null; // null where the curve does not jump
  middle: number | null; // null where the curve runs straight to the next place
}

export type Side = "left" | "right" | "middle";

const QUANTUM = 1e6;

/** A number as typed, comma or point; null for anything else. */
export function numberOf(text: string): number | null {
  const plain = text.trim().replace("−", "-").replace(",", ".");
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : null;
}

export function written(value: number, comma: boolean): string {
  const text = String(Math.round(value * QUANTUM) / QUANTUM);
  return comma ? text.replace(".", ",") : text;
}

/** The places of the rows of a table; null where a cell holds something that is no number. */
export function placesOf(rows: string[][]): Place[] | null {
  const used = rows.filter((row) => row.some((cell) => cell.trim() !== ""));
  const places = used.map(([x = "", left = "", right = "", middle = ""]) => {
    const [at, before] = [numberOf(x), numberOf(left)];
    const [after, half] = [right, middle].map((cell) => (cell.trim() === "" ? null : numberOf(cell) ?? NaN));
    return { x: at ?? NaN, left: before ?? NaN, right: after ?? null, middle: half ?? null };
  });
  return places.every((one) => Object.values(one).every((value) => value === null || Number.isFinite(value))) ? places : null;
}

export function rowsOf(places: Place[], comma: boolean): string[][] {
  const cell = (value: number | null): string => (value === null ? "" : written(value, comma));
  return places.map(({ x, left, right, middle }) => [cell(x), cell(left), cell(right), cell(middle)]);
}

export const after = (place: Place): number => place.right ?? place.left;

/** The ordinate half-way between a place and the next. */
export function middleOf(place: Place, next: Place): number {
  return place.middle ?? (after(place) + next.left) / 2;
}

/** The parabola through the ends and the middle of a piece, at a share of its length from 0 to 1. */
export function ordinate(place: Place, next: Place, share: number): number {
  const [start, half, end] = [after(place), middleOf(place, next), next.left];
  return start * (1 - share) * (1 - 2 * share) + 4 * half * share * (1 - share) + end * share * (2 * share - 1);
}

const STEPS = [1, 2, 5, 10];
const HEIGHTS = [1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** The smallest of some round numbers (from 1 to 10, times a power of ten) that is not below a number. */
export function rounded(least: number, among: number[]): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return (among.find((step) => step * power >= least * (1 - 1e-9)) ?? 10) * power;
}

export interface Scale {
  first: number;
  last: number;
  highest: number; // of the axis, both ways
  xStep: number;
  step: number;
}

export function scaleOf(places: Place[], span: number): Scale {
  const values = places.flatMap(({ left, right, middle }) => [left, right ?? 0, middle ?? 0]).map(Math.abs);
  const first = Math.min(0, ...places.map(({ x }) => x));
  const last = Math.max(span, ...places.map(({ x }) => x));
  const highest = rounded(Math.max(1e-6, ...values) * 1.05, HEIGHTS);
  const axis = values.some(Boolean) ? highest : 10;
  return { first, last, highest: axis, xStep: rounded((last - first) / 100, STEPS), step: rounded(axis / 100, STEPS) };
}

const snapped = (value: number, step: number): number => Math.round(Math.round(value / step) * step * QUANTUM) / QUANTUM;

/** The places with one ordinate set, on the grid of the scale. */
export function withOrdinate(places: Place[], at: number, side: Side, value: number, scale: Scale): Place[] {
  return places.map((place, index) => (index === at ? { ...place, [side]: snapped(value, scale.step) } : place));
}

/** The places with one of them moved, between its neighbours. */
export function withPlace(places: Place[], at: number, x: number, scale: Scale): Place[] {
  const [low, high] = [places[at - 1]?.x ?? -Infinity, places[at + 1]?.x ?? Infinity];
  const to = snapped(x, scale.xStep);
  if (!(to > low && to < high)) return places;
  return places.map((place, index) => (index === at ? { ...place, x: to } : place));
}

/** What Insert does: a jump where there is none, else a place half-way to the next. */
export function inserted(places: Place[], at: number, side: Side, most: number): Place[] {
  const [place, next] = [places[at], places[at + 1]];
  if (place === undefined) return places;
  if (side === "left" && place.right === null) return places.map((one, index) => (index === at ? { ...one, right: one.left } : one));
  if (next === undefined || places.length >= most) return places;
  const fresh = { x: (place.x + next.x) / 2, left: middleOf(place, next), right: null, middle: null };
  return [...places.slice(0, at), { ...place, middle: null }, fresh, ...places.slice(at + 1)];
}

/** What Delete does: the bend, the jump, or the place goes; two places stay. */
export function removed(places: Place[], at: number, side: Side): Place[] {
  if (side !== "left") return places.map((place, index) => (index === at ? { ...place, [side]: null } : place));
  return places.length > 2 ? places.filter((_, index) => index !== at) : places;
}

export type Move = { x: number; value: number };

/** How far a key moves a handle, in steps; `downwards` tells that the axis of ordinates points down. */
export function moveOf(key: string, shift: boolean, downwards: boolean): Move | null {
  const far = shift ? 10 : 1;
  const up = downwards ? -far : far;
  switch (key) {
    case "ArrowUp":
      return { x: 0, value: up };
    case "ArrowDown":
      return { x: 0, value: -up };
    case "PageUp":
      return { x: 0, value: downwards ? -10 : 10 };
    case "PageDown":
      return { x: 0, value: downwards ? 10 : -10 };
    case "ArrowLeft":
      return { x: -far, value: 0 };
    case "ArrowRight":
      return { x: far, value: 0 };
    case "+":
      return { x: 0, value: far };
    case "-":
      return { x: 0, value: -far };
    default:
      return null;
  }
}
