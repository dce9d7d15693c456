/* Formula lines: Enter adds a line only where there may be several, Ctrl+Enter checks, the field grows with its text.
   In a section of the report Enter checks that section: without a script it is the first of all that a browser takes. */

type Key = Pick<KeyboardEvent, "key" | "ctrlKey" | "metaKey" | "isComposing">;

/** What Enter means in a text field: check the answers, nothing at all (in a formula), or what the browser does. */
export function meaning(event: Key, inFormula: boolean): "check" | "nothing" | "default" {
  if (event.key !== "Enter" || event.isComposing) return "default";
  if (event.ctrlKey || event.metaKey) return "check";
  return inFormula ? "nothing" : "default";
}

function grow(area: HTMLTextAreaElement): void {
  area.style.height = "auto";
  area.style.height = `${area.scrollHeight + area.offsetHeight - area.clientHeight}px`;
}

/** Checks the answers of a form, as its main button does. */
export function check(form: HTMLFormElement): void {
  form.requestSubmit(form.querySelector<HTMLElement>('[type="submit"].main'));
}

function checkSection(form: HTMLFormElement, event: KeyboardEvent): void {
  const { target } = event;
  if (event.key !== "Enter" || event.defaultPrevented || !(target instanceof HTMLInputElement)) return;
  const button = target.closest("details")?.querySelector<HTMLElement>('button[name="section"]:enabled');
  if (!button) return;
  event.preventDefault();
  form.requestSubmit(button);
}

export function growFormulas(form: HTMLFormElement): void {
  form.addEventListener("keydown", (event) => {
    const { target } = event;
    const sense = meaning(event, target instanceof Element && target.matches("textarea.formula:not(.lines)"));
    if (sense === "default") return checkSection(form, event);
    event.preventDefault();
    if (sense === "check") check(form);
  });
  if (CSS.supports("field-sizing", "content")) return;
  for (const area of form.querySelectorAll<HTMLTextAreaElement>("textarea.formula")) {
    grow(area);
    area.addEventListener("input", () => grow(area));
  }
}
