/* Name and group for the report: kept until this tab is closed, never longer. */

const KEY = "grubler.person";

/** Keeps the fields of a form with `data-person` while the tab is open. */
export function keepPerson(form: HTMLFormElement): void {
  const fields = ["name", "group"].flatMap((name) => {
    const field = form.elements.namedItem(name);
    return field instanceof HTMLInputElement ? [field] : [];
  });
  try {
    const kept = JSON.parse(sessionStorage.getItem(KEY) ?? "{}") as Record<string, unknown>;
    for (const field of fields) if (field.value === "") field.value = String(kept[field.name] ?? "");
    form.addEventListener("input", () => {
      sessionStorage.setItem(KEY, JSON.stringify(Object.fromEntries(fields.map(({ name, value }) => [name, value]))));
    });
  } catch (fault) {
    if (!(fault instanceof DOMException || fault instanceof SyntaxError)) throw fault;
  }
}
