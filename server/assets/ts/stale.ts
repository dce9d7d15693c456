/* A verdict speaks of what was handed in: it steps back while the answer beside it is another one. */
import { answerFields, type Field } from "./fields.ts";

function changed(field: Field): boolean {
  if (field instanceof HTMLSelectElement) return Array.from(field.options).some((o) => o.selected !== o.defaultSelected);
  if (field instanceof HTMLTextAreaElement) return field.value !== field.defaultValue;
  const ticked = field.type === "radio" || field.type === "checkbox";
  return ticked ? field.checked !== field.defaultChecked : field.value !== field.defaultValue;
}

/** Hides the `.verdict` of an `.answer` whose fields differ from what was judged, and shows it again when they agree. */
export function hideStaleVerdicts(form: HTMLFormElement): void {
  form.addEventListener("input", (event) => {
    const answer = event.target instanceof Element ? event.target.closest(".answer") : null;
    const verdict = answer?.querySelector<HTMLElement>(".verdict");
    if (!answer || !verdict) return;
    verdict.hidden = answerFields(form).some((field) => answer.contains(field) && changed(field));
  });
}
