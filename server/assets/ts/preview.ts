/* What the preview endpoint says about one typed line. */

export interface Understood {
  ok: true;
  mathml: string;
  text: string;
  latex: string;
  unit: string | null;
  note: string | null;
  rows: Rows | null;
}

/** The rows of a diagram's table: a place, the ordinates left and right of it, and that half-way to the next. */
export type Rows = (number | null)[][];

export interface NotRead {
  ok: false;
  message: string;
  position: number | null;
}

export type Preview = Understood | NotRead;

const textOr = <T>(value: unknown, other: T): string | T => (typeof value === "string" ? value : other);

function rowsOf(relations: unknown): Rows | null {
  const rows = typeof relations === "object" && relations !== null ? (relations as { rows?: unknown }).rows : null;
  const isCell = (cell: unknown): boolean => cell === null || typeof cell === "number";
  return Array.isArray(rows) && rows.every((row) => Array.isArray(row) && row.length === 4 && row.every(isCell)) ? (rows as Rows) : null;
}

/** The reply in its declared shape, or null when it is something else (an error page, another version). */
export function readPreview(reply: unknown): Preview | null {
  if (typeof reply !== "object" || reply === null) return null;
  const { ok, mathml, text, latex, unit, note, message, position, relations } = reply as Record<string, unknown>;
  if (ok === true && typeof mathml === "string") {
    const said = { text: textOr(text, ""), latex: textOr(latex, ""), unit: textOr(unit, null), note: textOr(note, null) };
    return { ok, mathml, ...said, rows: rowsOf(relations) };
  }
  if (ok === false && typeof message === "string") {
    return { ok, message, position: typeof position === "number" ? position : null };
  }
  return null;
}

/** Numbers the questions so that a late reply to an earlier one is recognised and dropped. */
export function turnstile(): { next(): number; isLast(turn: number): boolean } {
  let last = 0;
  return { next: () => ++last, isLast: (turn) => turn === last };
}
