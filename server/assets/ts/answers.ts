/* The answers of a form as the server reads them: one text each, whatever fields it is typed in. */
import { answerFields, announceInput, type Field } from "./fields.ts";

export type Answers = Record<string, string>;

const CELL = /^answer\.(.+)\.(\d+)\.(\d+)$/;

/** The text of a matrix grid; a grid that is empty has none. */
export function joinGrid(rows: string[][]): string {
  const cells = rows.map((row) => row.map((cell) => cell.trim()));
  if (!cells.flat().some(Boolean)) return "";
  if (cells[0]?.length === 1) return `[${cells.flat().join("; ")}]`;
  return `[${cells.map((row) => `[${row.join("; ")}]`).join(", ")}]`;
}

/** The text of a table of a diagram: a line for each row that holds something, empty cells at its end left out. */
export function joinTable(rows: string[][]): string {
  const cells = rows.map((row) => row.map((cell) => cell.trim())).filter((row) => row.some(Boolean));
  return cells
    .map((row) => {
      const used = row.findLastIndex(Boolean) + 1;
      return row.slice(0, Math.max(2, used)).join("; ");
    })
    .join("\n");
}

function padded(row: string[], columns: number): string[] {
  return [...row, ...Array<string>(Math.max(0, columns - row.length)).fill("")];
}

/** The cells that give exactly this text; null for a text that was written otherwise. */
export function split(text: string, rows: number, columns: number, join: (rows: string[][]) => string): string[][] | null {
  const inner = text.trim().replace(/^\[|\]$/g, "");
  const lines =
    join === joinTable
      ? text.split("\n")
      : columns === 1
        ? inner.split(";")
        : inner.replace(/^\s*\[|\]\s*$/g, "").split("], [");
  const cells = lines.map((line) => padded(line.split(";").map((cell) => cell.trim()), columns));
  const filled = [...cells, ...Array.from({ length: rows - cells.length }, () => padded([], columns))];
  return filled.length === rows && filled.every((row) => row.length === columns) && join(filled) === text ? filled : null;
}

interface Slot {
  plain: Field[];
  cells: HTMLInputElement[][];
}

function slots(form: HTMLFormElement): Map<string, Slot> {
  const found = new Map<string, Slot>();
  for (const field of answerFields(form)) {
    const cell = CELL.exec(field.name);
    const name = cell?.[1] ?? field.name.slice("answer.".length);
    const slot = found.get(name) ?? { plain: [], cells: [] };
    found.set(name, slot);
    if (cell === null) slot.plain.push(field);
    else if (field instanceof HTMLInputElement) (slot.cells[Number(cell[2]) - 1] ??= []).push(field);
  }
  return found;
}

const isTick = (field: Field): field is HTMLInputElement =>
  field instanceof HTMLInputElement && (field.type === "radio" || field.type === "checkbox");

/** How the cells of a table or of a grid are written as one text. */
export function joinerOf(cells: HTMLInputElement[][]): (rows: string[][]) => string {
  return cells[0]?.[0]?.closest("[data-join='table']") ? joinTable : joinGrid;
}

/** The cells of the answer that a field belongs to, row by row. */
export function cellsOf(form: HTMLFormElement, field: Field): HTMLInputElement[][] {
  return Array.from(slots(form).values()).find((slot) => slot.plain.includes(field))?.cells ?? [];
}

function textOf(slot: Slot): string {
  const ticked = slot.plain.filter((field) => !isTick(field) || field.checked);
  const text = ticked.map((field) => field.value).join("; ");
  if (text.trim() !== "" || slot.cells.length === 0) return text;
  return joinerOf(slot.cells)(slot.cells.map((row) => row.map((cell) => cell.value)));
}

export function readAnswers(form: HTMLFormElement): Answers {
  return Object.fromEntries(Array.from(slots(form), ([name, slot]) => [name, textOf(slot)]));
}

function set(field: Field, value: string): void {
  if (field.value === value) return;
  field.value = value;
  announceInput(field);
}

function tick(fields: HTMLInputElement[], text: string): void {
  const wanted = text.split(";").map((item) => item.trim());
  for (const field of fields) {
    const checked = wanted.includes(field.value);
    if (field.checked === checked) continue;
    field.checked = checked;
    announceInput(field);
  }
}

/** Puts an answer into its fields as if it had been typed there. */
export function writeAnswer(form: HTMLFormElement, name: string, text: string): void {
  const slot = slots(form).get(name);
  if (slot === undefined) return;
  const ticks = slot.plain.filter(isTick);
  if (ticks.length > 0) return tick(ticks, text);
  for (const field of slot.plain) set(field, text); // cells beside it follow
  if (slot.plain.length > 0) return;
  const apart = text === "" ? null : split(text, slot.cells.length, slot.cells[0]?.length ?? 0, joinerOf(slot.cells));
  slot.cells.forEach((row, r) => row.forEach((cell, c) => set(cell, apart?.[r]?.[c] ?? "")));
}

/** The name and the whole text of the answer that a field belongs to. */
export function answerOf(form: HTMLFormElement, field: Field): { name: string; text: string } | null {
  for (const [name, slot] of slots(form)) {
    if (slot.plain.includes(field) || slot.cells.some((row) => row.some((cell) => cell === field))) {
      return { name, text: textOf(slot) };
    }
  }
  return null;
}
