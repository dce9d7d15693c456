/* Ordering: buttons move an item up and down; the letters in order are the answer. */
import { announceInput, isTextField, type TextField } from "./fields.ts";

/** The list with one item moved a place up (-1) or down (1). */
export function moved<T>(items: T[], at: number, by: -1 | 1): T[] {
  const to = at + by;
  if (to < 0 || to >= items.length) return items;
  const changed = [...items];
  [changed[at], changed[to]] = [changed[to] as T, changed[at] as T];
  return changed;
}

/** The letters of a typed order, when they are those of the list; null for any other text. */
export function lettersOf(text: string, letters: string[]): string[] | null {
  const found = text.toLowerCase().match(/[a-z]+/g)?.join("").split("") ?? [];
  return found.length === letters.length && letters.every((letter) => found.includes(letter)) ? found : null;
}

const letterOf = (item: HTMLElement): string => item.dataset["letter"] ?? "";
const itemsOf = (list: HTMLElement): HTMLElement[] => Array.from(list.querySelectorAll<HTMLElement>("li"));

function button(list: HTMLElement, item: HTMLElement, by: -1 | 1): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = "button";
  made.className = "btn sq";
  made.dataset["by"] = String(by);
  made.textContent = by < 0 ? "↑" : "↓";
  const words = list.dataset[by < 0 ? "wordUp" : "wordDown"] ?? "";
  made.setAttribute("aria-label", words.replace("{item}", item.textContent?.trim() ?? ""));
  return made;
}

function arrange(list: HTMLElement, letters: string[]): void {
  const items = itemsOf(list);
  for (const letter of letters) {
    const item = items.find((one) => letterOf(one) === letter);
    if (item !== undefined) list.append(item);
  }
}

function step(list: HTMLElement, field: TextField, pressed: HTMLElement, spoken: HTMLElement): void {
  const item = pressed.closest("li");
  if (item === null) return;
  const items = itemsOf(list);
  const letters = moved(items.map(letterOf), items.indexOf(item), pressed.dataset["by"] === "-1" ? -1 : 1);
  arrange(list, letters);
  pressed.focus();
  field.value = letters.join("; ");
  announceInput(field);
  const place = String(itemsOf(list).indexOf(item) + 1);
  const name = item.querySelector("span:last-of-type")?.textContent ?? "";
  spoken.textContent = (list.dataset["wordPlace"] ?? "").replace("{item}", name).replace("{place}", place);
}

/** Starts a list with `data-order="id of the field"`. */
export function orderList(list: HTMLElement): void {
  const field = document.getElementById(list.dataset["order"] ?? "");
  if (!isTextField(field)) return;
  const spoken = document.createElement("p");
  spoken.className = "vh";
  spoken.setAttribute("role", "status");
  list.after(spoken);
  for (const item of itemsOf(list)) item.append(button(list, item, -1), button(list, item, 1));
  const follow = (): void => {
    const letters = lettersOf(field.value, itemsOf(list).map(letterOf).sort());
    if (letters !== null) arrange(list, letters);
  };
  follow();
  field.addEventListener("input", follow);
  list.addEventListener("click", ({ target }) => {
    const pressed = target instanceof HTMLElement ? target.closest<HTMLElement>("[data-by]") : null;
    if (pressed !== null) step(list, field, pressed, spoken);
  });
}
