/* A table copied from a sheet or a document fills the cells of a grid, from the cell it is pasted into. */
import { announceInput } from "./fields.ts";

const CELL = /^(.+)\.(\d+)\.(\d+)$/; // `answer.T.2.3`

/** The cells of a copied table: one row a line, parted by tabs, else by semicolons or blanks; null for a single cell. */
export function tableOf(text: string): string[][] | null {
  const lines = text.replace(/\r\n?/g, "\n").replace(/\n+$/, "").split("\n");
  const mark = ["\t", ";"].find((one) => text.includes(one)) ?? (lines.length > 1 ? / +/ : null);
  if (mark === null) return null;
  return lines.map((line) => (mark === "\t" ? line : line.trim()).split(mark).map((cell) => cell.trim()));
}

function cellsFrom(form: HTMLFormElement, name: string, rows: string[][], row: number, column: number): HTMLInputElement[][] | null {
  const cells = rows.map((line, r) => line.map((_, c) => form.elements.namedItem(`${name}.${row + r}.${column + c}`)));
  const there = (cell: unknown): cell is HTMLInputElement => cell instanceof HTMLInputElement && !cell.readOnly;
  return cells.flat().every(there) ? (cells as HTMLInputElement[][]) : null;
}

export function pasteInGrid(form: HTMLFormElement): void {
  form.addEventListener("paste", (event) => {
    const { target, clipboardData } = event;
    const at = target instanceof HTMLInputElement ? CELL.exec(target.name) : null;
    const rows = at === null ? null : tableOf(clipboardData?.getData("text/plain") ?? "");
    if (at === null || rows === null) return;
    const name = at[1] ?? "";
    const cells = cellsFrom(form, name, rows, Number(at[2]), Number(at[3])) ?? cellsFrom(form, name, rows, 1, 1);
    if (cells === null) return;
    event.preventDefault();
    cells.forEach((line, r) => line.forEach((cell, c) => {
      cell.value = rows[r]?.[c] ?? "";
      announceInput(cell);
    }));
  });
}
