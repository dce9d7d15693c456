/* Live echo: what was understood stands under the field before anything counts. */
import { answerOf } from "./answers.ts";
import { ask } from "./ask.ts";
import { isTextField, type TextField } from "./fields.ts";
import { readMathML } from "./mathml.ts";
import { turnstile, type Preview } from "./preview.ts";

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

/* One cell of a grid is not at fault alone: the words stand below the whole. */
function mark(field: TextField, bad: boolean): void {
  if (field.closest("[role='group'][data-echo], table[data-echo]") !== null) return;
  if (bad) field.setAttribute("aria-invalid", "true");
  else field.removeAttribute("aria-invalid");
}

/* A reading wider than its place is scrolled by keyboard too. */
function reach(place: HTMLElement): void {
  if (place.scrollWidth > place.clientWidth) place.tabIndex = 0;
  else place.removeAttribute("tabindex");
}

function show(field: TextField, place: HTMLElement, preview: Preview, words: DOMStringMap): void {
  place.classList.toggle("bad", !preview.ok);
  place.replaceChildren(...(preview.ok ? understood(preview, words) : [span(""), span(preview.message)]));
  mark(field, !preview.ok);
  reach(place);
}

function clear(field: TextField, place: HTMLElement, text = ""): void {
  place.classList.remove("bad");
  place.textContent = text;
  mark(field, false);
}

function listen(place: HTMLElement, form: HTMLFormElement, url: string): (field: TextField) => void {
  const turns = turnstile();
  let timer = 0;
  const refresh = async (turn: number, field: TextField, name: string, text: string): Promise<void> => {
    const preview = await ask(url, name, text);
    if (!turns.isLast(turn)) return;
    if (preview === null) clear(field, place, form.dataset["wordOffline"]);
    else show(field, place, preview, form.dataset);
  };
  return (field) => {
    const turn = turns.next();
    clearTimeout(timer);
    const answer = answerOf(form, field);
    if (answer === null || answer.text.trim() === "") clear(field, place);
    else timer = window.setTimeout(() => void refresh(turn, field, answer.name, answer.text), PAUSE);
  };
}

/** Starts the echo of every field of a form with `data-preview` that stands in a `[data-echo="id of its place"]`. */
export function listenForEcho(form: HTMLFormElement): void {
  const url = form.dataset["preview"];
  if (url === undefined) return;
  const places = new Map<HTMLElement, (field: TextField) => void>();
  form.addEventListener("input", ({ target }) => {
    const id = isTextField(target) ? target.closest<HTMLElement>("[data-echo]")?.dataset["echo"] : undefined;
    const place = id === undefined ? null : document.getElementById(id);
    if (place === null || !isTextField(target)) return;
    if (!places.has(place)) {
      places.set(place, listen(place, form, url));
      new ResizeObserver(() => reach(place)).observe(place);
    }
    places.get(place)?.(target);
  });
}
