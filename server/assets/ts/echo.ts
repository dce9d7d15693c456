/* Live echo: what was understood stands under the field before anything counts. */
import { answerName, isTextField, type TextField } from "./fields.ts";
import { readMathML } from "./mathml.ts";
import { readPreview, turnstile, type Preview } from "./preview.ts";

const PAUSE = 400; // ms after the last key

function span(text: string, className = ""): HTMLElement {
  const node = document.createElement("span");
  node.className = className;
  node.textContent = text;
  return node;
}

function understood(preview: Preview & { ok: true }, words: DOMStringMap): Node[] {
  const formula = span("", "echo");
  formula.append(...readMathML(preview.mathml));
  if (!formula.hasChildNodes()) formula.textContent = preview.text;
  const note = preview.note === null ? [] : [span(preview.note)];
  return [span(words["wordRead"] ?? ""), formula, ...note];
}

function show(field: TextField, place: HTMLElement, preview: Preview, words: DOMStringMap): void {
  place.classList.toggle("bad", !preview.ok);
  place.replaceChildren(...(preview.ok ? understood(preview, words) : [span(""), span(preview.message)]));
  if (preview.ok) field.removeAttribute("aria-invalid");
  else field.setAttribute("aria-invalid", "true");
}

function clear(field: TextField, place: HTMLElement, text = ""): void {
  place.classList.remove("bad");
  place.textContent = text;
  field.removeAttribute("aria-invalid");
}

/** The sentence of a refusal, such as too many requests; null when the reply holds none. */
async function refusal(reply: Response): Promise<Preview | null> {
  const said = ((await reply.json()) as { error?: { message?: unknown } }).error?.message;
  return typeof said === "string" ? { ok: false, message: said, position: null } : null;
}

async function ask(url: string, answer: string, text: string): Promise<Preview | null> {
  const headers = { "Content-Type": "application/json", "Accept-Language": document.documentElement.lang };
  try {
    const reply = await fetch(url, { method: "POST", headers, body: JSON.stringify({ answer, text }) });
    if (reply.status === 429) return await refusal(reply);
    return reply.ok ? readPreview(await reply.json()) : null;
  } catch {
    return null; // no connection, or no JSON: both mean that there is no preview now
  }
}

function listen(field: TextField, answer: string, place: HTMLElement, form: HTMLFormElement, url: string): void {
  const turns = turnstile();
  let timer = 0;
  const refresh = async (turn: number): Promise<void> => {
    const preview = await ask(url, answer, field.value);
    if (!turns.isLast(turn)) return;
    if (preview === null) clear(field, place, form.dataset["wordOffline"]);
    else show(field, place, preview, form.dataset);
  };
  field.addEventListener("input", () => {
    const turn = turns.next();
    clearTimeout(timer);
    if (field.value.trim() === "") clear(field, place);
    else timer = window.setTimeout(() => void refresh(turn), PAUSE);
  });
}

/** Starts the echo of every `[data-echo="id of its place"]` field of a form with `data-preview`. */
export function listenForEcho(form: HTMLFormElement): void {
  const url = form.dataset["preview"];
  if (url === undefined) return;
  for (const field of form.querySelectorAll<HTMLElement>("[data-echo]")) {
    if (!isTextField(field)) continue;
    const answer = answerName(field.name);
    const place = document.getElementById(field.dataset["echo"] ?? "");
    if (answer !== null && place !== null) listen(field, answer, place, form, url);
  }
}
