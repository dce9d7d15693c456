/* A table or a grid and its text: two views of one answer. The text is what is handed in. */
import { ask } from "./ask.ts";
import { answerName } from "./fields.ts";
import { cellsOf, joinerOf, joinTable, split } from "./answers.ts";
import { turnstile } from "./preview.ts";
import { written } from "./sketch_model.ts";

export const FILLED = "filled"; // the event on an answer whose cells were filled from the text
const PAUSE = 300; // ms after the last key

/* The parts of a list: a semicolon parts them where there is one outside brackets, else a comma. */
function parts(text: string): string[] {
  const found: Record<string, number[]> = { ";": [], ",": [] };
  let depth = 0;
  Array.from(text).forEach((char, at) => {
    if ("([".includes(char)) depth += 1;
    else if (")]".includes(char)) depth -= 1;
    else if (depth === 0) found[char]?.push(at);
  });
  const marks = found[";"]?.length ? found[";"] : (found[","] ?? []);
  return [...marks, text.length].map((at, index) => text.slice((marks[index - 1] ?? -1) + 1, at).trim());
}

const framed = (text: string): boolean => text.startsWith("[") && text.endsWith("]");
const bare = (text: string): string => (framed(text) ? text.slice(1, -1).trim() : text);

/** The entries of a matrix typed as `[[a, b], [c, d]]`, or of one row or column as `[a; b]`; null for any other text. */
export function entriesOf(text: string, rows: number, columns: number): string[][] | null {
  if (!framed(text.trim())) return null;
  const outer = parts(bare(text.trim()));
  const lines = outer.every(framed) ? outer.map((line) => parts(bare(line))) : columns === 1 ? outer.map((one) => [one]) : [outer];
  return lines.length === rows && lines.every((line) => line.length === columns) ? lines : null;
}

class Twin {
  private readonly answer: HTMLElement;
  private readonly text: HTMLTextAreaElement;
  private readonly cells: HTMLInputElement[][];
  private readonly join: (rows: string[][]) => string;
  private readonly turns = turnstile();
  private timer = 0;

  constructor(answer: HTMLElement, text: HTMLTextAreaElement, cells: HTMLInputElement[][]) {
    [this.answer, this.text, this.cells] = [answer, text, cells];
    this.join = joinerOf(cells);
    if (text.value.trim() === "") text.defaultValue = this.joined();
    else this.read(0, true);
  }

  private joined(): string {
    return this.join(this.cells.map((row) => row.map((cell) => cell.value)));
  }

  /** The cells were typed in: the text says the same. */
  write(): void {
    this.stop();
    this.text.value = this.joined();
  }

  private stop(): number {
    clearTimeout(this.timer);
    return this.turns.next();
  }

  /** The text was typed in: the cells say the same, or nothing where they cannot. */
  read(pause = PAUSE, first = false): void {
    const [turn, text] = [this.stop(), this.text.value];
    const columns = this.cells[0]?.length ?? 0;
    const isTable = this.join === joinTable;
    const rows = text.trim() === "" ? [] : isTable ? split(text, this.cells.length, columns, joinTable) : entriesOf(text, this.cells.length, columns);
    if (rows !== null || !isTable) return this.fill(rows, first);
    for (const cell of this.cells.flat()) cell.readOnly = true; // until it is known what the text says
    this.timer = window.setTimeout(() => void this.ask(turn, text, first), pause);
  }

  private async ask(turn: number, text: string, first: boolean): Promise<void> {
    const url = this.text.form?.dataset["preview"];
    const reply = url === undefined ? null : await ask(url, answerName(this.text.name) ?? "", text, true);
    if (!this.turns.isLast(turn)) return;
    const comma = document.documentElement.lang !== "en";
    const cell = (value: number | null): string => (value === null ? "" : written(value, comma));
    this.fill((reply?.ok ? reply.rows : null)?.map((row) => row.map(cell)) ?? null, first);
  }

  private fill(rows: string[][] | null, first: boolean): void {
    const shown = rows !== null && rows.length <= this.cells.length ? rows : null;
    this.cells.forEach((row, r) => {
      row.forEach((cell, c) => {
        cell.readOnly = shown === null;
        cell[first ? "defaultValue" : "value"] = shown?.[r]?.[c] ?? "";
      });
    });
    this.answer.querySelector("[data-twin-note]")?.toggleAttribute("hidden", shown !== null);
    this.answer.dispatchEvent(new Event(FILLED));
  }
}

/** Keeps a text with `data-twin` and the cells of its answer in step. */
export function keepInStep(text: HTMLTextAreaElement): void {
  const answer = text.closest<HTMLElement>(".answer");
  const cells = text.form === null ? [] : cellsOf(text.form, text);
  if (answer === null || cells.length === 0) return;
  const twin = new Twin(answer, text, cells);
  answer.addEventListener("input", ({ target }) => (target === text ? twin.read() : twin.write()));
}
