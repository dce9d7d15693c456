/* A draft stays in this browser until its answers have been graded. */
import { announceInput, answerFields, type Field } from "./fields.ts";

export interface Draft {
  time: number; // ms since the epoch
  values: Record<string, string[]>;
}

const PREFIX = "grubler.draft.";
const PAUSE = 300; // ms after the last change
const KEPT = 30 * 24 * 3600 * 1000; // ms; the server forgets an idle practice variant after the same 30 days

/** The draft in a stored text; null for what is old, foreign or damaged. */
export function readDraft(stored: string | null, now: number): Draft | null {
  try {
    const { time, values } = JSON.parse(stored ?? "null") as Draft;
    const whole = Object.values(values).every((list) => list.every((value) => typeof value === "string"));
    return whole && now - time < KEPT ? { time, values } : null;
  } catch {
    return null;
  }
}

const isTick = (field: Field): field is HTMLInputElement =>
  field instanceof HTMLInputElement && (field.type === "radio" || field.type === "checkbox");

function collect(form: HTMLFormElement): Draft {
  const values: Record<string, string[]> = {};
  for (const field of answerFields(form)) {
    const list = (values[field.name] ??= []);
    if (!isTick(field) || field.checked) list.push(field.value);
  }
  return { time: Date.now(), values };
}

function fill(field: Field, list: string[], at: number): void {
  if (isTick(field)) {
    field.checked = list.includes(field.value);
    return;
  }
  const value = list[at];
  if (value === undefined || value === field.value) return;
  field.value = value;
  announceInput(field);
}

function restore(form: HTMLFormElement, draft: Draft): void {
  const seen = new Map<string, number>();
  for (const field of answerFields(form)) {
    const at = seen.get(field.name) ?? 0;
    seen.set(field.name, at + 1);
    const list = draft.values[field.name];
    if (list !== undefined) fill(field, list, at);
  }
}

function forgetOld(store: Storage): void {
  for (const key of Object.keys(store)) {
    if (key.startsWith(PREFIX) && readDraft(store.getItem(key), Date.now()) === null) store.removeItem(key);
  }
}

/* Storage may be forbidden or full: the page then works as it does without script. */
function carefully(action: () => void): void {
  try {
    action();
  } catch (fault) {
    if (!(fault instanceof DOMException)) throw fault;
  }
}

function keep(form: HTMLFormElement, key: string): void {
  let timer = 0;
  const save = (): void => carefully(() => localStorage.setItem(key, JSON.stringify(collect(form))));
  form.addEventListener("input", () => {
    clearTimeout(timer);
    timer = window.setTimeout(save, PAUSE);
  });
  window.addEventListener("pagehide", () => {
    if (timer !== 0) save();
  });
}

/** Restores and keeps the draft of a form with `data-draft`; one with `data-graded` ends it. */
export function restoreDraft(form: HTMLFormElement): void {
  const name = form.dataset["draft"];
  if (name === undefined) return;
  const key = PREFIX + name;
  carefully(() => {
    forgetOld(localStorage);
    if (form.dataset["graded"] !== undefined) localStorage.removeItem(key);
    const draft = readDraft(localStorage.getItem(key), Date.now());
    if (draft !== null) restore(form, draft);
  });
  keep(form, key);
}
