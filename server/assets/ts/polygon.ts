/* The builder of a vector polygon: rows of fields beside the text, which stays the answer. */
import { announceInput, isTextField, type TextField } from "./fields.ts";
import { blank, PARTS, read, write, type Sheet, type Vector } from "./polygon_text.ts";

type Control = HTMLInputElement | HTMLSelectElement;

const STARTED = 3; // rows of an empty sheet
const FREE = ["x", "y", "unknowns"] as const;

function part(place: ParentNode, name: string): Control | null {
  return place.querySelector<Control>(`[data-part="${name}"]`);
}

function value(place: ParentNode, name: string): string {
  return part(place, name)?.value ?? "";
}

/** Starts a builder with `data-polygon="id of the field"`. */
export function buildPolygon(builder: HTMLElement): void {
  const field = document.getElementById(builder.dataset["polygon"] ?? "");
  const list = builder.querySelector<HTMLElement>("[data-vectors]");
  const row = builder.querySelector("template")?.content.firstElementChild;
  if (!isTextField(field) || list === null || !row) return;
  start(builder, field, list, row);
  builder.hidden = false;
}

function start(builder: HTMLElement, field: TextField, list: HTMLElement, row: Element): void {
  let rest: string[] = [];
  let writing = false;
  const nodes = Array.from(row.querySelectorAll("[data-part='from'] option"), (option) => option.textContent ?? "").filter(Boolean);

  const add = (vector: Vector): HTMLElement => {
    const item = row.cloneNode(true) as HTMLElement;
    for (const name of PARTS) {
      const control = part(item, name);
      if (control !== null) control.value = vector[name];
    }
    list.append(item);
    name(item);
    return item;
  };
  const name = (item: HTMLElement): void => {
    const number = String(Array.from(list.children).indexOf(item) + 1);
    item.querySelector("[role='group']")?.setAttribute("aria-label", (builder.dataset["wordVector"] ?? "").replace("{number}", number));
  };
  const sheet = (): Sheet => ({
    vectors: Array.from(list.children, (item) => {
      return Object.fromEntries(PARTS.map((one) => [one, value(item, one)])) as unknown as Vector;
    }),
    x: value(builder, "x"),
    y: value(builder, "y"),
    unknowns: value(builder, "unknowns"),
    rest,
  });
  const show = (): void => {
    if (writing || write(sheet()) === field.value) return;
    const found = read(field.value, nodes);
    rest = found.rest;
    const empty = Array.from({ length: found.vectors.length === 0 ? STARTED : 0 }, blank);
    list.replaceChildren();
    [...found.vectors, ...empty].forEach(add);
    for (const free of FREE) {
      const control = part(builder, free);
      if (control !== null) control.value = found[free];
    }
  };
  const put = (): void => {
    field.value = write(sheet());
    writing = true;
    announceInput(field);
    writing = false;
  };

  Array.from({ length: STARTED }, blank).forEach(add);
  show();
  field.addEventListener("input", show);
  builder.addEventListener("input", put);
  builder.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && event.target instanceof HTMLInputElement && !event.ctrlKey && !event.metaKey) event.preventDefault();
  });
  builder.addEventListener("click", ({ target }) => {
    if (!(target instanceof HTMLElement)) return;
    if (target.closest("[data-add]")) part(add(blank()), "name")?.focus();
    const removed = target.closest("[data-remove]")?.closest("li");
    if (!removed) return;
    removed.remove();
    Array.from(list.children).forEach((item) => name(item as HTMLElement));
    builder.querySelector<HTMLElement>("[data-add]")?.focus();
    put();
  });
}
