/* How far the class is, on the results of a set: asked again while the page is looked at. */

const PAUSE = 20_000; // ms between two questions
const COUNTS = ["opened", "handed_in"] as const;

type Counts = Record<string, unknown>;

/** Writes the counts where the page shows them; true when one of them is a new one. */
function write(block: HTMLElement, counts: Counts): boolean {
  const words = block.dataset["words"] ?? "";
  return COUNTS.map((name) => {
    const place = block.querySelector<HTMLElement>(`[data-count="${name}"]`);
    const said = words.replace("{number}", String(counts[name])).replace("{all}", String(counts["students"]));
    const changed = place !== null && place.textContent !== said;
    if (changed) place.textContent = said;
    return changed;
  }).some(Boolean);
}

/** Keeps the counts of `[data-progress]` fresh and shows `[data-newer]` once the table below is older than they are. */
export function followProgress(block: HTMLElement): void {
  const newer = document.querySelector<HTMLElement>("[data-newer]");
  const look = async (): Promise<void> => {
    if (document.hidden) return;
    try {
      const reply = await fetch(block.dataset["progress"] ?? "");
      if (reply.ok && write(block, (await reply.json()) as Counts) && newer !== null) newer.hidden = false;
    } catch {
      return; // no connection: the next question comes anyway
    }
  };
  window.setInterval(() => void look(), PAUSE);
  document.addEventListener("visibilitychange", () => void look());
}
