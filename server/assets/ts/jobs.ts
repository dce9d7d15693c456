/* A job as it goes on: the server sends its progress, and how it ended is read from the page once more. */

const MOST_FAILURES = 6; // in a row; then the reader is told
const PAUSE = 500; // ms, doubled by each failure, before the stream is asked for again

interface Part { done: number; total: number }
interface Item extends Part { number: number; refused: boolean }
export interface Progress extends Part { state: string; items: Item[] }

function isPart(told: Record<string, unknown>): boolean {
  return typeof told["done"] === "number" && typeof told["total"] === "number";
}

function isItem(item: Item | null): boolean {
  return typeof item?.number === "number" && typeof item.refused === "boolean" && isPart({ ...item });
}

/** Reads an event in its declared shape; null for anything else. */
export function readProgress(text: string): Progress | null {
  const told = JSON.parse(text) as Progress | null;
  if (typeof told?.state !== "string" || !isPart({ ...told }) || !Array.isArray(told.items)) return null;
  return told.items.every(isItem) ? told : null;
}

/** How far all is: by the cards of the tasks where they are told, else by batches. */
export function overall({ done, total, items }: Progress): Part {
  if (items.length === 0) return { done, total };
  const sum = (numbers: number[]): number => numbers.reduce((one, other) => one + other, 0);
  return { done: sum(items.map((item) => item.done)), total: sum(items.map((item) => item.total)) };
}

function word(place: HTMLElement | null, { done, total }: Part): void {
  const words = place?.dataset["jobWords"] ?? "";
  if (place !== null) place.textContent = words.replace("{done}", String(done)).replace("{total}", String(total));
}

class Watch {
  private readonly block: HTMLElement;
  private readonly state: HTMLElement | null;
  private source: EventSource | null = null;
  private failures = 0;

  constructor(block: HTMLElement) {
    this.block = block;
    this.state = document.querySelector("[data-job-state]");
  }

  open(): void {
    this.source?.close();
    this.source = new EventSource(this.block.dataset["job"] ?? "");
    this.source.addEventListener("progress", (event: MessageEvent<string>) => this.told(readProgress(event.data)));
    this.source.addEventListener("error", () => this.failed());
  }

  private told(progress: Progress | null): void {
    if (progress === null) return;
    this.failures = 0;
    this.show(progress);
    if (progress.state !== "waiting" && progress.state !== "running") void this.end();
  }

  private show(progress: Progress): void {
    const all = overall(progress);
    const bar = this.block.querySelector("progress");
    if (bar !== null) [bar.max, bar.value] = [all.total, all.done];
    word(this.block.querySelector("label[data-job-words]"), all);
    for (const item of progress.items) this.tell(item);
    const said = this.state?.dataset[progress.state] ?? "";
    if (this.state !== null && this.state.textContent !== said) this.state.textContent = said; // it is read aloud
  }

  private tell(item: Item): void {
    const line = this.block.querySelector<HTMLElement>(`[data-job-item="${item.number}"]`);
    if (line === null || !item.refused) word(line, item);
    else line.textContent = line.dataset["jobRefused"] ?? "";
  }

  /** A stream ends by itself after some time, or was refused, or cut: it is opened again, but not for ever. */
  private failed(): void {
    this.source?.close(); // the browser would try every second, and never where it was refused
    this.failures += 1;
    if (this.failures > MOST_FAILURES) this.lose();
    else window.setTimeout(() => this.open(), PAUSE * 2 ** this.failures);
  }

  private lose(): void {
    this.source?.close();
    const lost = this.block.querySelector<HTMLElement>("[data-job-lost]");
    if (lost !== null) lost.hidden = false;
  }

  /** Puts in what the page says of a job that has ended; the focus stays near where it was. */
  private async end(): Promise<void> {
    this.source?.close();
    try {
      const reply = await fetch(window.location.href);
      const found = new DOMParser().parseFromString(await reply.text(), "text/html").querySelector("[data-job]");
      if (!reply.ok || found === null) return this.lose();
      const held = this.block.contains(document.activeElement);
      this.block.replaceWith(found);
      if (held) found.querySelector<HTMLElement>("a")?.focus();
    } catch {
      this.lose();
    }
  }
}

/** Follows the job of `[data-job]`, whose value is the address of its events while it is under way. */
export function followJob(block: HTMLElement): void {
  const watch = new Watch(block);
  watch.open();
  window.addEventListener("pageshow", (event) => {
    if (event.persisted && block.isConnected) watch.open(); // back from another page
  });
}
