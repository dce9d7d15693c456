/* The builder of a vector polygon: rows of fields beside the text, which stays the answer. */
import { announceInput, isTextField, type TextField } from "./fields.ts";
import { blank, PARTS, read, write, type Sheet, type Vector } from "./polygon_text.ts";

type Control = HTMLInputElement | HTMLSelectElement;
type Sense = "leave" | "next" | "up" | "down" | "remove";

const STARTED = 3; // rows of an empty sheet
const FREE = ["x", "y", "unknowns"] as const;

function part(place: ParentNode, name: string): Control | null {
  return place.querySelector<Control>(`[data-part="${name}"]`);
}

function value(place: ParentNode, name: string): string {
  return part(place, name)?.value ?? "";
}

/** What a key means in a row of the builder; null for a key that the field itself takes. */
export function senseOf(key: string, ctrl: boolean, typing: boolean): Sense | null {
  if (ctrl) return key === "ArrowUp" ? "up" : key === "ArrowDown" ? "down" : null;
  if (key === "Escape") return "leave";
  if (typing) return key === "Enter" ? "next" : null;
  return key === "Delete" ? "remove" : null;
}

class Builder {
  private readonly box: HTMLElement;
  private readonly field: TextField;
  private readonly list: HTMLElement;
  private readonly row: Element;
  private readonly nodes: string[];
  private rest: string[] = [];
  private writing = false;

  constructor(box: HTMLElement, field: TextField, list: HTMLElement, row: Element) {
    [this.box, this.field, this.list, this.row] = [box, field, list, row];
    const options = row.querySelectorAll("[data-part='from'] option");
    this.nodes = Array.from(options, (option) => option.textContent ?? "").filter(Boolean);
    Array.from({ length: STARTED }, blank).forEach((vector) => this.add(vector));
    this.show();
  }

  private get items(): HTMLElement[] {
    return Array.from(this.list.children) as HTMLElement[];
  }

  private say(word: string, number: number): void {
    const spoken = this.box.querySelector("[data-spoken]");
    const text = (this.box.dataset[word] ?? "").replace("{number}", String(number)).replace("{left}", String(this.items.length));
    if (spoken !== null) spoken.textContent = text;
  }

  private add(vector: Vector): HTMLElement {
    const item = this.row.cloneNode(true) as HTMLElement;
    for (const name of PARTS) {
      const control = part(item, name);
      if (control !== null) control.value = vector[name];
    }
    this.list.append(item);
    this.number();
    return item;
  }

  private number(): void {
    const words = this.box.dataset["wordVector"] ?? "";
    this.items.forEach((item, at) => {
      item.querySelector("[role='group']")?.setAttribute("aria-label", words.replace("{number}", String(at + 1)));
    });
  }

  private sheet(): Sheet {
    return {
      vectors: this.items.map((item) => Object.fromEntries(PARTS.map((one) => [one, value(item, one)])) as unknown as Vector),
      x: value(this.box, "x"),
      y: value(this.box, "y"),
      unknowns: value(this.box, "unknowns"),
      rest: this.rest,
    };
  }

  /** Lays the text out in rows. */
  show(): void {
    if (this.writing || write(this.sheet()) === this.field.value) return;
    const found = read(this.field.value, this.nodes);
    this.rest = found.rest;
    const empty = Array.from({ length: found.vectors.length === 0 ? STARTED : 0 }, blank);
    this.list.replaceChildren();
    [...found.vectors, ...empty].forEach((vector) => this.add(vector));
    for (const free of FREE) {
      const control = part(this.box, free);
      if (control !== null) control.value = found[free];
    }
  }

  /** Writes the rows as text. */
  put(): void {
    this.field.value = write(this.sheet());
    this.writing = true;
    announceInput(this.field);
    this.writing = false;
  }

  /** Adds an empty vector and goes to one of its parts. */
  begin(name: string): void {
    part(this.add(blank()), name)?.focus();
    this.say("wordAdded", this.items.length);
  }

  /** Takes a vector away; the focus goes to the button of the one that follows. */
  remove(item: HTMLElement): void {
    const at = this.items.indexOf(item);
    item.remove();
    this.number();
    const next = this.items[Math.min(at, this.items.length - 1)]?.querySelector<HTMLElement>("[data-remove]");
    (next ?? this.box.querySelector<HTMLElement>("[data-add]"))?.focus();
    this.put();
    this.say("wordRemoved", at + 1);
  }

  key(event: KeyboardEvent): void {
    const { target } = event;
    if (!(target instanceof HTMLElement) || event.altKey || event.metaKey || event.isComposing) return;
    const sense = senseOf(event.key, event.ctrlKey, target instanceof HTMLInputElement);
    if (sense === null) return;
    event.preventDefault();
    const item = target.closest("li");
    if (sense === "leave") this.field.focus();
    else if (item !== null && sense === "remove") this.remove(item);
    else if (item !== null) this.go(item, target.dataset["part"], sense);
  }

  /* From a vector to the same part of the one before or behind it; Enter begins a new one behind the last. */
  private go(item: HTMLElement, name: string | undefined, sense: Sense): void {
    const next = this.items[this.items.indexOf(item) + (sense === "up" ? -1 : 1)];
    if (next === undefined) return sense === "next" && name !== undefined ? this.begin(name) : undefined;
    next.querySelector<HTMLElement>(name === undefined ? "[data-remove]" : `[data-part="${name}"]`)?.focus();
  }
}

/** Starts a builder with `data-polygon="id of the field"`. */
export function buildPolygon(box: HTMLElement): void {
  const field = document.getElementById(box.dataset["polygon"] ?? "");
  const list = box.querySelector<HTMLElement>("[data-vectors]");
  const row = box.querySelector("template")?.content.firstElementChild;
  if (!isTextField(field) || list === null || !row) return;
  const builder = new Builder(box, field, list, row);
  field.addEventListener("input", () => builder.show());
  box.addEventListener("input", () => builder.put());
  box.addEventListener("keydown", (event) => builder.key(event));
  box.addEventListener("click", ({ target }) => {
    if (!(target instanceof HTMLElement)) return;
    if (target.closest("[data-add]")) builder.begin("name");
    const removed = target.closest("[data-remove]")?.closest("li");
    if (removed) builder.remove(removed);
  });
  box.hidden = false;
}
