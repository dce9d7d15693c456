/* What every island needs to know about an answer field. */

export type TextField = HTMLInputElement | HTMLTextAreaElement;
export type Field = TextField | HTMLSelectElement;

const PREFIX = "answer.";

/** The answer a field belongs to: `answer.omega2` gives `omega2`; other fields give null. */
export function answerName(fieldName: string): string | null {
  return fieldName.startsWith(PREFIX) && fieldName.length > PREFIX.length ? fieldName.slice(PREFIX.length) : null;
}

export function answerFields(form: HTMLFormElement): Field[] {
  return Array.from(form.querySelectorAll<Field>(`[name^="${PREFIX}"]`));
}

export function isTextField(node: EventTarget | null): node is TextField {
  if (node instanceof HTMLTextAreaElement) return true;
  return node instanceof HTMLInputElement && (node.type === "text" || node.type === "search");
}

/** A change made by an island must reach the other islands as if it had been typed. */
export function announceInput(field: Field): void {
  field.dispatchEvent(new Event("input", { bubbles: true }));
}
