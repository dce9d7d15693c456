/* Samples of a motion as CSV: written for a spreadsheet, and read from a program that the student wrote elsewhere. */

export interface Row {
  t: number;
  x: number;
  v: number;
  a: number;
}

/** The largest difference in a column, the moment it comes, and the largest value of ours beside which it is told. */
export interface Difference {
  column: "x" | "v" | "a";
  most: number;
  t: number;
  size: number;
}

const COLUMNS = ["t", "x", "v", "a"] as const;
const UNKNOWN = /^\s*(nan)?\s*$/i; // how programs leave a value out
const UNIT = /^([mcd]?)(?:[ms]|m\/s(?:\^?2|²|\^\{2\})?)$/; // of SI, with a prefix where there is one
const PARTS: Record<string, number> = { "": 1, m: 1e-3, c: 1e-2, d: 1e-1 };
const MOST_ROWS = 5000;
const LONGEST = 500_000; // characters

/** Writes rows with a header; what is not known is left empty. Semicolons part, so that a comma may be decimal. */
export function written(rows: readonly Row[], comma: boolean): string {
  const number = (value: number): string => {
    const text = Number.isFinite(value) ? String(Number(value.toPrecision(10))) : "";
    return comma ? text.replace(".", ",") : text;
  };
  return [COLUMNS.join(";"), ...rows.map((row) => COLUMNS.map((name) => number(row[name])).join(";"))].join("\r\n") + "\r\n";
}

/** Tells what stands in a column: `x_D [mm]` is x in thousandths; null for a unit that is none of these. */
export function columnOf(head: string): { name: string; scale: number } | null {
  const [, name = "", unit = ""] = /^([^[(,]*)(?:[[(,]\s*([^\])]*)[\])]?)?$/.exec(head.trim().toLowerCase()) ?? [];
  const part = unit === "" ? [""] : UNIT.exec(unit.trim().replaceAll("\u043c", "m").replaceAll("\u0441", "s"));
  const stem = name.trim().replace(/[_ ].*$/, "");
  return part === null ? null : { name: stem === "y" ? "x" : stem, scale: PARTS[part[1] ?? ""] ?? 1 };
}

/** Reads a table with a header that names t and at least one of x, v, a; the number of the first bad line otherwise. */
export function read(text: string): Row[] | { line: number } {
  const lines = text.slice(0, LONGEST).replace(/^\ufeff/, "").replaceAll('"', "").split(/\r\n|\n|\r/);
  const head = lines[0] ?? "";
  const mark = [";", "\t", ","].find((sign) => head.includes(sign)) ?? ";";
  const columns = head.split(mark).map(columnOf);
  const names = columns.map((column) => column?.name ?? "");
  if (columns.includes(null) || !names.includes("t") || !["x", "v", "a"].some((name) => names.includes(name))) return { line: 1 };
  const rows: Row[] = [];
  for (const [at, line] of lines.entries()) {
    if (at === 0 || line.trim() === "") continue;
    const cells = line.split(mark);
    const cell = (name: string): string => (names.includes(name) ? (cells[names.indexOf(name)] ?? "") : "");
    const value = (name: string): number => number(cell(name)) * (columns[names.indexOf(name)]?.scale ?? 1);
    const row = { t: value("t"), x: value("x"), v: value("v"), a: value("a") };
    const known = (name: (typeof COLUMNS)[number]): boolean => Number.isFinite(row[name]) || UNKNOWN.test(cell(name));
    if (!Number.isFinite(row.t) || !COLUMNS.every(known) || rows.length === MOST_ROWS) return { line: at + 1 };
    rows.push(row);
  }
  return rows.length === 0 ? { line: 2 } : rows;
}

function number(text: string): number {
  const plain = text.trim().replace(",", ".").replace("\u2212", "-");
  return plain === "" || plain.length > 40 ? NaN : Number(plain);
}

/** The largest difference of each column that both have, and when it comes. */
export function differences(rows: readonly Row[], ours: (t: number) => Row): Difference[] {
  const found = new Map<Difference["column"], Difference>();
  for (const row of rows) {
    const own = ours(row.t);
    for (const column of ["x", "v", "a"] as const) {
      const most = Math.abs(row[column] - own[column]);
      if (!Number.isFinite(most)) continue;
      const last = found.get(column) ?? { column, most: 0, t: row.t, size: 0 };
      const size = Math.max(last.size, Math.abs(own[column]));
      found.set(column, most >= last.most ? { column, most, t: row.t, size } : { ...last, size });
    }
  }
  return (["x", "v", "a"] as const).flatMap((column) => found.get(column) ?? []);
}
