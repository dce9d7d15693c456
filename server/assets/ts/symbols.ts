/* The symbol row: keys that type at the caret, one tab stop, arrows inside. */
import { announceInput, isTextField, type TextField } from "./fields.ts";

/** What a key types: a selection goes inside a key that steps back (`sqrt()` with 1), others replace it. */
export function keystroke(insert: string, back: number, selected: string): { text: string; back: number } {
  if (back === 0 || selected === "") return { text: insert, back };
  const at = insert.length - back;
  return { text: insert.slice(0, at) + selected + insert.slice(at), back: 0 };
}

/** The key that gets the focus after an arrow, Home or End; null when the pressed key is not ours. */
export function nextKey(key: string, index: number, count: number): number | null {
  switch (key) {
    case "ArrowRight":
    case "ArrowDown":
      return (index + 1) % count;
    case "ArrowLeft":
    case "ArrowUp":
      return (index + count - 1) % count;
    case "Home":
      return 0;
    case "End":
      return count - 1;
    default:
      return null;
  }
}

/* execCommand is the only way that keeps the browser's undo; setRangeText is its fallback. */
function type(field: TextField, text: string): void {
  if (document.execCommand("insertText", false, text)) return;
  field.setRangeText(text, field.selectionStart ?? 0, field.selectionEnd ?? 0, "end");
  announceInput(field);
}

function erase(field: TextField): void {
  if (document.execCommand("delete")) return;
  const end = field.selectionEnd ?? 0;
  const start = field.selectionStart === end ? Math.max(0, end - 1) : (field.selectionStart ?? 0);
  field.setRangeText("", start, end, "end");
  announceInput(field);
}

function press(key: HTMLElement, field: TextField): void {
  field.focus();
  if (key.dataset["key"] === "backspace") return erase(field);
  const [start, end] = [field.selectionStart ?? 0, field.selectionEnd ?? 0];
  const back = Number(key.dataset["back"] ?? 0);
  const stroke = keystroke(key.dataset["insert"] ?? "", back, field.value.slice(start, end));
  type(field, stroke.text);
  const caret = (field.selectionEnd ?? 0) - stroke.back;
  field.setSelectionRange(caret, caret);
}

/* The field named by `data-for`, else the last one that had the focus within the same answer, else its first. */
function target(row: HTMLElement): () => TextField | null {
  const named = document.getElementById(row.dataset["for"] ?? "");
  if (isTextField(named)) return () => named;
  const answer = row.closest<HTMLElement>(".answer") ?? row.parentElement;
  let last: TextField | null = null;
  answer?.addEventListener("focusin", ({ target }) => {
    if (isTextField(target)) last = target;
  });
  return () => last ?? Array.from(answer?.querySelectorAll("input, textarea") ?? []).find(isTextField) ?? null;
}

function rove(keys: HTMLElement[]): void {
  const stop = (at: number): void => keys.forEach((key, index) => (key.tabIndex = index === at ? 0 : -1));
  stop(0);
  keys.forEach((key, index) => {
    key.addEventListener("focus", () => stop(index));
    key.addEventListener("keydown", (event) => {
      const next = event.ctrlKey || event.altKey || event.metaKey ? null : nextKey(event.key, index, keys.length);
      if (next === null) return;
      event.preventDefault();
      keys[next]?.focus();
    });
  });
}

/** Shows a row that the server renders hidden, since its keys do nothing without script. */
export function showSymbols(row: HTMLElement): void {
  const keys = Array.from(row.querySelectorAll<HTMLElement>("button[data-insert], button[data-key]"));
  if (keys.length === 0) return;
  const field = target(row);
  rove(keys);
  for (const key of keys) {
    key.addEventListener("pointerdown", (event) => event.preventDefault()); // the phone's keyboard stays open
    key.addEventListener("mousedown", (event) => event.preventDefault());
    key.addEventListener("click", () => {
      const aim = field();
      if (aim !== null) press(key, aim);
    });
  }
  row.hidden = false;
}
