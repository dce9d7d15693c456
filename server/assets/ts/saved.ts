/* The words of the draft: saved, saving, not saved; spoken only when the state changes. */

export type State = "saved" | "saving" | "unsaved" | "ended"; // ended: the server knows this reader no more

export interface Cell {
  show(state: State, time?: Date): void;
}

function clock(time: Date): string {
  return [time.getHours(), time.getMinutes()].map((part) => String(part).padStart(2, "0")).join(":");
}

function put(place: HTMLElement | null, text = ""): void {
  if (place !== null && place.textContent !== text) place.textContent = text;
}

/** The cell of the page; `isLocal` tells whether this browser keeps the answers meanwhile. */
export function draftCell(form: HTMLFormElement, isLocal: () => boolean): Cell {
  const words = form.querySelector<HTMLElement>("[data-draft-words]")?.dataset ?? {};
  const find = (name: string): HTMLElement | null => document.querySelector(`[data-draft-${name}]`);
  const [seen, place, spoken] = [find("state"), find("place"), find("spoken")];
  let told: State = "saved";
  put(place, words["places"]);
  const unsaved = (state: State, kept: string): string | undefined =>
    words[isLocal() ? (state === "ended" ? "ended" : kept) : "lost"];
  const speak = (state: State): void => {
    if (state === "saving" || state === told) return;
    told = state;
    put(spoken, state === "saved" ? words["spoken"] : unsaved(state, "notSaved"));
  };
  return {
    show(state, time = new Date()) {
      const lost = state === "unsaved" || state === "ended";
      put(seen, state === "saved" ? words["saved"]?.replace("{time}", clock(time)) : words[lost ? "unsaved" : state]);
      put(place, lost ? unsaved(state, "here") : words["places"]);
      speak(state);
    },
  };
}
