/* The relations of the answers that drive the machine: asked from the preview on load and after each pause in typing. */
import { isTextField, type TextField } from "../fields.ts";
import { turnstile } from "../preview.ts";

const PAUSE = 600; // ms after the last key

/** Asks for the relations of one answer; undefined where there is no reply or nothing could be read. */
async function ask(url: string, answer: string, text: string): Promise<unknown> {
  const headers = { "Content-Type": "application/json", "Accept-Language": document.documentElement.lang };
  try {
    const reply = await fetch(url, { method: "POST", headers, body: JSON.stringify({ answer, text, relations: true }) });
    return reply.ok ? ((await reply.json()) as { relations?: unknown }).relations : undefined;
  } catch {
    return undefined; // no connection: the last readable relations stay
  }
}

/** Follows one field: calls back with its relations, or with null once it is empty. */
export function follow(form: HTMLFormElement, answer: string, heard: (relations: unknown) => void): void {
  const field = form.elements.namedItem(`answer.${answer}`);
  const url = form.dataset["preview"];
  if (!(field instanceof Element) || !isTextField(field) || url === undefined) return;
  listen(field, url, answer, heard);
}

function listen(field: TextField, url: string, answer: string, heard: (relations: unknown) => void): void {
  const turns = turnstile();
  let timer = 0;
  const refresh = async (turn: number): Promise<void> => {
    const found = field.value.trim() === "" ? null : await ask(url, answer, field.value);
    if (turns.isLast(turn) && found !== undefined) heard(found);
  };
  field.addEventListener("input", () => {
    clearTimeout(timer);
    const turn = turns.next();
    timer = window.setTimeout(() => void refresh(turn), PAUSE);
  });
  if (field.value.trim() !== "") void refresh(turns.next());
}
