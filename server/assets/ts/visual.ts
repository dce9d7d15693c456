/* The visual formula editor: loaded when its button is pressed, beside the text that stays the answer. */
import type { MathfieldElement } from "mathlive";

import { answerName, announceInput, isTextField, type TextField } from "./fields.ts";
import { ask } from "./ask.ts";
import { turnstile } from "./preview.ts";

const HERE = import.meta.url;
const PAUSE = 300; // ms after the last key
const GREEK = new Set("alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi psi omega".split(" "));

/** The LaTeX of a declared name: `alpha1` is `\alpha_{1}`, `R_A` is `R_{A}`. */
export function latexOf(name: string): string {
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

async function load(label: string): Promise<MathfieldElement> {
  const { MathfieldElement: Field, version } = await import("mathlive");
  Field.fontsDirectory = [...HERE.split("/").slice(0, -1), `mathlive-${version.mathlive}`].join("/");
  Field.soundsDirectory = null;
  Field.createHTML = withoutStyles;
  const made = new Field();
  made.mathVirtualKeyboardPolicy = "manual";
  made.setAttribute("aria-label", label);
  const root = made.shadowRoot;
  if (root !== null) new MutationObserver(() => styleBack(root)).observe(root, { childList: true, subtree: true });
  return made;
}

function names(box: HTMLElement): string[] {
  const keys = box.closest(".answer")?.querySelectorAll<HTMLElement>(".keys [data-insert]") ?? [];
  return Array.from(keys, (key) => key.dataset["insert"] ?? "").filter((name) => /^[A-Za-z]+_?\w+$/.test(name));
}

/* Two views of one formula: each change of one is read by the preview and shown in the other. */
function join(field: TextField, visual: MathfieldElement, url: string): void {
  const answer = answerName(field.name) ?? "";
  const turns = turnstile();
  let [timer, writing] = [0, false];
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
    if (!turns.isLast(turn)) return;
    field.value = reply?.ok ? reply.text : latex;
    writing = true;
    announceInput(field);
    writing = false;
  };
  visual.addEventListener("input", (event) => {
    event.stopPropagation(); // the field announces what the formula became
    soon(put);
  });
  field.addEventListener("input", () => void (writing || soon(show)));
  void show(turns.next());
}

/** Offers the editor of a `data-visual="id of the field"` in a form with `data-preview`. */
export function offerVisual(box: HTMLElement): void {
  const field = document.getElementById(box.dataset["visual"] ?? "");
  const button = box.querySelector("button");
  const url = box.closest<HTMLElement>("form")?.dataset["preview"];
  if (!isTextField(field) || button === null || url === undefined) return;
  let visual: MathfieldElement | null = null;
  const open = async (): Promise<void> => {
    if (visual === null) {
      const made = await load(box.dataset["wordLabel"] ?? "");
      visual = made;
      box.append(made);
      made.shadowRoot?.querySelector("[part='keyboard-sink']")?.setAttribute("inputmode", "text"); // a phone's own keys
      made.menuItems = [];
      made.inlineShortcuts = { ...made.inlineShortcuts, ...Object.fromEntries(names(box).map((name) => [name, latexOf(name)])) };
      join(field, made, url);
    } else visual.hidden = !visual.hidden;
    button.setAttribute("aria-expanded", String(!visual.hidden));
    if (!visual.hidden) visual.focus();
  };
  button.addEventListener("click", () => {
    open().catch(() => {
      button.replaceWith(box.dataset["wordFailed"] ?? "");
    });
  });
  box.hidden = false;
}
