/* A table of samples from a file: chosen, or dropped on its field. */
import { announceInput, isTextField, type TextField } from "./fields.ts";

export const LARGEST = 48 * 1024; // bytes; a form of 64 kB must hold the other answers too

async function take(field: TextField, place: HTMLElement, spoken: Element | null, file: File | undefined): Promise<void> {
  if (file === undefined) return;
  if (file.size > LARGEST) {
    if (spoken !== null) spoken.textContent = place.dataset["wordLarge"] ?? "";
    return;
  }
  field.value = (await file.text()).replace(/^\ufeff/, "").replace(/\r\n?/g, "\n").trim();
  announceInput(field);
  if (spoken !== null) spoken.textContent = file.name;
}

/** Starts a line with `data-drop="id of the field"`. */
export function takeFiles(place: HTMLElement): void {
  const field = document.getElementById(place.dataset["drop"] ?? "");
  const chooser = place.querySelector<HTMLInputElement>("input[type='file']");
  if (!isTextField(field) || chooser === null) return;
  const spoken = place.querySelector("[role='status']");
  chooser.addEventListener("change", () => void take(field, place, spoken, chooser.files?.[0]));
  for (const target of [field, place]) {
    target.addEventListener("dragover", (event) => event.preventDefault());
    target.addEventListener("drop", (event) => {
      event.preventDefault();
      void take(field, place, spoken, event.dataTransfer?.files[0]);
    });
  }
  place.hidden = false;
}
