/* A vector polygon as text and as rows: the rows write exactly the lines that the polygon kind reads. */

export interface Vector {
  name: string;
  from: string;
  to: string;
  length: string;
  angle: string;
  sign: string; // + or - in the closure, empty where the vector is not in it
}

export interface Sheet {
  vectors: Vector[];
  x: string;
  y: string;
  unknowns: string;
  rest: string[]; // lines that the rows have no place for, kept as they were typed
}

export const PARTS = ["name", "from", "to", "length", "angle", "sign"] as const;
export const blank = (): Vector => ({ name: "", from: "", to: "", length: "", angle: "", sign: "+" });

const VECTOR = /^([^:]+):\s*([^>,\s]+)\s*>\s*([^>,\s]+)\s*,\s*length\s+([^,]+),\s*angle\s+(.+)$/;
const LABELLED = /^(x|y|unknowns|closure):\s*(.*)$/;

function filled(vector: Vector): boolean {
  return [vector.name, vector.from, vector.to, vector.length, vector.angle].some((part) => part.trim() !== "");
}

/** The closed walk as an equation: each vector with its sign, in order. */
export function closure(vectors: Vector[]): string {
  const terms = vectors.filter((vector) => filled(vector) && vector.sign !== "");
  const text = terms.map(({ name, sign }, at) => (at === 0 ? (sign === "-" ? "-" : "") : ` ${sign} `) + name.trim()).join("");
  return text === "" ? "" : `closure: ${text} = 0`;
}

export function write(sheet: Sheet): string {
  const lines = sheet.vectors.filter(filled).map(({ name, from, to, length, angle }) => {
    const [called, long, turned] = [name, length, angle].map((part) => part.trim());
    return `${called}: ${from} > ${to}, length ${long}, angle ${turned}`;
  });
  const equation = (label: string, text: string): string => (text.trim() === "" ? "" : `${label}: ${text.trim()}`);
  const ends = [closure(sheet.vectors), equation("x", sheet.x), equation("y", sheet.y), equation("unknowns", sheet.unknowns)];
  return [...lines, ...ends, ...sheet.rest].filter((line) => line !== "").join("\n");
}

function signs(text: string, vectors: Vector[]): boolean {
  const sides = text.split("=");
  if (sides.length !== 2 || sides[1]?.trim() !== "0") return false;
  const terms = new Map<string, string>();
  for (const term of (sides[0] ?? "").replace(/\s+/g, "").match(/[+-]?[^+-]+/g) ?? []) {
    terms.set(term.replace(/^[+-]/, ""), term.startsWith("-") ? "-" : "+");
  }
  const known = vectors.map((vector) => vector.name);
  if (!Array.from(terms.keys()).every((name) => known.includes(name))) return false;
  for (const vector of vectors) vector.sign = terms.get(vector.name) ?? "";
  return true;
}

/** The rows of a text; what they have no place for stays in `rest`, so nothing typed is lost. */
export function read(text: string, nodes: string[]): Sheet {
  const sheet: Sheet = { vectors: [], x: "", y: "", unknowns: "", rest: [] };
  const closures: string[] = [];
  for (const line of text.split("\n").map((one) => one.trim()).filter(Boolean)) {
    const vector = VECTOR.exec(line)?.slice(1).map((part) => part.trim());
    const labelled = LABELLED.exec(line);
    const [label, body] = [labelled?.[1], labelled?.[2] ?? ""];
    if (vector !== undefined && nodes.includes(vector[1] ?? "") && nodes.includes(vector[2] ?? "")) {
      const [name = "", from = "", to = "", length = "", angle = ""] = vector;
      sheet.vectors.push({ name, from, to, length, angle, sign: "" });
    } else if (label === "closure") closures.push(body);
    else if ((label === "x" || label === "y" || label === "unknowns") && sheet[label] === "") sheet[label] = body;
    else sheet.rest.push(line);
  }
  closures.forEach((body, at) => {
    if (at > 0 || !signs(body, sheet.vectors)) sheet.rest.push(`closure: ${body}`);
  });
  return sheet;
}
