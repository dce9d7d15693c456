/* The visual formula editor: loaded when its button is pressed, beside the text that stays the answer. */
import type { MathfieldElement } from "mathlive";

import { answerName, announceInput, isTextField, type TextField } from "./fields.ts";
import { ask } from "./ask.ts";
import { check, meaning } from "./formula.ts";
import { turnstile } from "./preview.ts";
import { type Phrases, speakIn } from "./spoken.ts";

const HERE = import.meta.url;
const OPERATIONS = [..."+-*/=()^,;·"];
const PAUSE = 300; // ms after the last key
const GREEK = new Set("alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi psi omega".split(" "));

const RATES: [string, string][] = [["_dd", "\\ddot"], ["_d", "\\dot"]];
const SIGNS = new Map([
  ["/", "\\frac{#@}{#?}"], ["*", "\\cdot "], ["^", "#@^{#?}"], ["sqrt()", "\\sqrt{#0}"],
  ...["sin", "cos"].map((name): [string, string] => [`${name}()`, `\\${name}\\left(#0\\right)`]),
]);

/** The LaTeX of a declared name: `alpha1` is `\alpha_{1}`, `R_A` is `R_{A}`, `h3_d` is `\dot{h}_{3}`. */
export function latexOf(name: string): string {
  const [marked, over] = RATES.find(([mark]) => name.endsWith(mark)) ?? [];
  if (marked !== undefined) return latexOf(name.slice(0, -marked.length)).replace(/^\\?[A-Za-z]+/, `${over}{$&}`);
  const [, letters = "", below = ""] = /^([A-Za-z]+?)_?(\d\w*|(?<=_)\w+)?$/.exec(name) ?? [null, name];
  const base = GREEK.has(letters.toLowerCase()) ? `\\${letters}` : letters;
  return below === "" ? base : `${base}_{${below}}`;
}

/* The editor writes style attributes, which the security policy stops: they travel under another name and are set by
   script, which it allows. */
function withoutStyles(html: string): string {
  return html.replaceAll(' style="', ' data-style="');
}

function styleBack(root: ParentNode): void {
  for (const node of root.querySelectorAll<HTMLElement>("[data-style]")) {
    if (!node.part.contains("container")) node.style.cssText = node.dataset["style"] ?? ""; // it shows itself
    node.removeAttribute("data-style");
  }
}

/* The editor looks for old marks of a selection in what it has just drawn, then measures it for new ones: the styles
   are to be back by then, not a moment later. */
function styledBeforeMeasured(drawn: Element): void {
  const look = drawn.querySelectorAll.bind(drawn) as (selector: string) => NodeListOf<HTMLElement>;
  const styled = (selector: string): NodeListOf<HTMLElement> => {
    styleBack({ querySelectorAll: look } as ParentNode);
    return look(selector);
  };
  Object.defineProperty(drawn, "querySelectorAll", { value: styled });
}

async function load(words: DOMStringMap): Promise<MathfieldElement> {
  const { MathfieldElement: Field, version } = await import("mathlive");
  Field.fontsDirectory = [...HERE.split("/").slice(0, -1), `mathlive-${version.mathlive}`].join("/");
  Field.soundsDirectory = null;
  Field.locale = document.documentElement.lang;
  Field.createHTML = withoutStyles;
  const made = new Field();
  made.mathVirtualKeyboardPolicy = "manual";
  made.setAttribute("aria-label", words["wordLabel"] ?? "");
  const root = made.shadowRoot;
  if (root !== null) new MutationObserver(() => styleBack(root)).observe(root, { childList: true, subtree: true });
  return made;
}

function names(box: HTMLElement): string[] {
  const keys = box.closest(".answer")?.querySelectorAll<HTMLElement>(".keys [data-insert]") ?? [];
  return Array.from(keys, (key) => key.dataset["insert"] ?? "").filter((name) => /^[A-Za-z]+_?\w+$/.test(name));
}

/** Makes the editor one stop of the Tab key, with the words on how to leave it and those it speaks, and a phone's own keys. */
function asOneStop(visual: MathfieldElement, help: string, phrases: Phrases): void {
  const typed = visual.shadowRoot?.querySelector("[part='keyboard-sink']");
  typed?.setAttribute("inputmode", "text");
  typed?.setAttribute("aria-description", help);
  const live = visual.shadowRoot?.querySelector("[aria-live]");
  if (live && typed) speakIn(phrases, live, typed, visual.getAttribute("aria-label") ?? "");
  const drawn = visual.shadowRoot?.querySelector("[part='content']");
  if (drawn) styledBeforeMeasured(drawn);
  visual.removeAttribute("tabindex"); // the element and what stands in it would be two stops
  visual.menuItems = [];
}

/* The editor's own Tab goes from gap to gap, its Escape into LaTeX, its Enter to a second line: here Tab leaves it,
   Escape leads to the text, and Enter means what it means there. */
function letOut(visual: MathfieldElement, field: TextField): void {
  const keep = (event: KeyboardEvent): void => {
    const inside = visual.mode === "latex" && !event.ctrlKey && !event.metaKey; // there both end the command
    if (event.key !== "Tab" && (inside || !["Escape", "Enter"].includes(event.key))) return;
    event.stopPropagation();
    if (event.key !== "Tab") event.preventDefault();
    if (event.key === "Escape") field.focus();
    else if (field.form !== null && meaning(event, true) === "check") check(field.form);
  };
  visual.addEventListener("keydown", keep, { capture: true });
}

/* A name has no sign of an operation in it: one typed in a subscript that `_` began stands behind the name. What
   stands in the subscript stays there: `Theta1` and `_d` is the rate of Theta1. */
function leaveSubscripts(visual: MathfieldElement): void {
  let [inside, begun] = [false, false];
  const collapse = (): void => {
    if (!visual.selectionIsCollapsed) visual.position = Math.max(...visual.selection.ranges.flat());
  };
  const follow = ({ key }: KeyboardEvent): void => {
    if (begun) collapse();
    begun = key === "_";
    if (inside && OPERATIONS.includes(key)) visual.executeCommand("moveAfterParent");
    if (begun) setTimeout(collapse);
    inside = key === "_" || (inside && (/^[\w]$/.test(key) || key === "Shift"));
  };
  visual.addEventListener("keydown", follow, { capture: true });
  for (const other of ["pointerdown", "focusout"]) visual.addEventListener(other, () => (inside = false));
}

/* The keys of the row type into the editor while it has the focus, as they do into the text. */
function takeKeys(visual: MathfieldElement, row: Element | null | undefined): void {
  const type = (event: Event): void => {
    const key = event.target instanceof Element ? event.target.closest<HTMLElement>("button") : null;
    if (key === null || !visual.hasFocus()) return;
    event.stopPropagation();
    const insert = key.dataset["insert"] ?? "";
    if (key.dataset["key"] === "backspace") visual.executeCommand("deleteBackward");
    else if (/^[A-Za-z]\w*$/.test(insert)) visual.insert(latexOf(insert), { format: "latex" });
    else if (SIGNS.has(insert)) visual.insert(SIGNS.get(insert)!, { format: "latex" });
    else visual.executeCommand(["typedText", insert]);
  };
  row?.addEventListener("click", type, { capture: true });
}

/* Two views of one formula: each change of one is read by the preview and shown in the other. */
function join(field: TextField, visual: MathfieldElement, url: string): void {
  const answer = answerName(field.name) ?? "";
  const turns = turnstile();
  let [timer, writing, ahead] = [0, false, false]; // ahead: the formula says what the text does not say yet
  const soon = (refresh: (turn: number) => Promise<void>): void => {
    const turn = turns.next();
    clearTimeout(timer);
    timer = window.setTimeout(() => void refresh(turn), PAUSE);
  };
  const show = async (turn: number): Promise<void> => {
    const reply = field.value.trim() === "" ? null : await ask(url, answer, field.value);
    if (!turns.isLast(turn)) return;
    if (reply?.ok) visual.setValue(reply.latex, { silenceNotifications: true });
    else if (field.value.trim() === "") visual.setValue("", { silenceNotifications: true });
  };
  const put = async (turn: number): Promise<void> => {
    const latex = visual.getValue("latex");
    const reply = latex.trim() === "" ? null : await ask(url, answer, latex);
    if (turns.isLast(turn)) write(reply?.ok ? reply.text : latex);
  };
  const write = (text: string): void => {
    field.value = text;
    [writing, ahead] = [true, false];
    announceInput(field);
    writing = false;
  };
  const handIn = (): void => {
    if (!ahead) return;
    turns.next();
    write(visual.getValue("latex"));
  };
  visual.addEventListener("input", (event) => {
    event.stopPropagation(); // the field announces what the formula became
    ahead = true;
    soon(put);
  });
  field.form?.addEventListener("submit", handIn, { capture: true });
  field.addEventListener("input", () => void (writing || soon(show)));
  void show(turns.next());
}

function phrasesOf(box: HTMLElement): Phrases {
  return JSON.parse(box.closest("form")?.dataset["phrases"] ?? "{}") as Phrases; // of our own page
}

/** Offers the editor of a `data-visual="id of the field"` in a form with `data-preview`. */
export function offerVisual(box: HTMLElement): void {
  const field = document.getElementById(box.dataset["visual"] ?? "");
  const [button, help] = [box.querySelector("button"), box.querySelector<HTMLElement>(".help")];
  const url = box.closest<HTMLElement>("form")?.dataset["preview"];
  if (!isTextField(field) || button === null || help === null || url === undefined) return;
  let visual: MathfieldElement | null = null;
  const open = async (): Promise<void> => {
    if (visual === null) {
      const made = await load(box.dataset);
      visual = made;
      help.before(made);
      asOneStop(made, help.textContent ?? "", phrasesOf(box));
      letOut(made, field);
      leaveSubscripts(made);
      takeKeys(made, box.closest(".answer")?.querySelector(".keys"));
      made.inlineShortcuts = { ...made.inlineShortcuts, ...Object.fromEntries(names(box).map((name) => [name, latexOf(name)])) };
      join(field, made, url);
    } else visual.hidden = !visual.hidden;
    button.setAttribute("aria-expanded", String(!visual.hidden));
    help.hidden = visual.hidden;
    if (!visual.hidden) visual.focus();
  };
  button.addEventListener("click", () => {
    open().catch(() => {
      button.replaceWith(box.dataset["wordFailed"] ?? "");
    });
  });
  box.hidden = false;
}
