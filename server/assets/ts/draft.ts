/* A draft is in this browser at each key and on the server seconds later; it ends when its answers are graded. */
import { readAnswers, writeAnswer, type Answers } from "./answers.ts";
import { keyOf, load, readKept, store, type Kept } from "./kept.ts";
import { merge, same } from "./merge.ts";
import { draftCell, type Cell } from "./saved.ts";

const PAUSE = 1200; // ms after the last key
const LONGEST = 3500; // ms that a key waits at most
const RETRIES = [3000, 6000, 12000, 30000]; // ms between tries without a connection

interface ServerCopy {
  answers: Answers;
  revision: number;
  time: string | null;
}

/** The server's copy in its declared shape; null for anything else. */
export function readCopy(reply: unknown): ServerCopy | null {
  if (typeof reply !== "object" || reply === null) return null;
  const { answers, revision, time } = reply as Record<string, unknown>;
  if (typeof answers !== "object" || answers === null || typeof revision !== "number") return null;
  const texts = Object.entries(answers).map(([name, text]) => [name, Array.isArray(text) ? text.join("\n") : String(text)]);
  return { answers: Object.fromEntries(texts) as Answers, revision, time: typeof time === "string" ? time : null };
}

async function call(url: string, init: RequestInit): Promise<{ status: number; copy: ServerCopy | null }> {
  try {
    const reply = await fetch(url, { ...init, headers: { "Content-Type": "application/json" } });
    return { status: reply.status, copy: reply.ok ? readCopy(await reply.json()) : null };
  } catch {
    return { status: 0, copy: null }; // no connection, or no JSON
  }
}

class Draft {
  private readonly form: HTMLFormElement;
  private readonly url: string;
  private readonly key: string;
  private readonly cell: Cell;
  private readonly graded: string;
  private revision: number;
  private synced: Answers; // what the server has
  private base: Answers; // what this tab and the others share: what differs was typed here
  private quarrel: string[] = [];
  private local = true;
  private timer = 0;
  private since = 0; // when the first unsent key was typed
  private failures = 0;
  private sending = false;

  constructor(form: HTMLFormElement, url: string) {
    [this.form, this.url] = [form, url];
    this.key = keyOf(url);
    this.cell = draftCell(form, () => this.local);
    this.revision = Number(form.dataset["revision"] ?? 0);
    [this.synced, this.base] = [readAnswers(form), readAnswers(form)];
    const [kept, graded] = [load(this.key), form.dataset["graded"]];
    this.graded = graded ?? kept?.graded ?? "";
    if (form.dataset["time"] !== undefined) this.cell.show("saved", new Date(form.dataset["time"]));
    if (kept !== null && kept.graded === this.graded) this.adopt(kept.synced, kept.answers, this.synced);
    this.keep();
  }

  /** Puts together what is here and what came from elsewhere, and asks where both changed. */
  private adopt(base: Answers, mine: Answers, theirs: Answers): void {
    const merged = merge(base, mine, theirs);
    const { answers, conflicts } = merged;
    this.base = merged.base;
    for (const [name, text] of Object.entries(answers)) writeAnswer(this.form, name, text);
    this.quarrel = conflicts;
    this.ask();
    if (conflicts.length === 0 && !same(answers, this.synced)) this.soon();
  }

  private keep(): void {
    const answers = readAnswers(this.form);
    const kept: Kept = { time: Date.now(), revision: this.revision, answers, synced: this.synced, graded: this.graded };
    this.local = store(this.key, kept);
  }

  typed(): void {
    this.keep();
    this.soon();
  }

  private soon(): void {
    const now = Date.now();
    if (this.since === 0) this.since = now;
    if (this.failures === 0) this.cell.show("saving");
    this.again(Math.max(0, Math.min(PAUSE, this.since + LONGEST - now)));
  }

  private again(pause: number): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.send(), pause);
  }

  /** Sends what the server does not have yet; `keepalive` lets it outlive the page. */
  async send(keepalive = false): Promise<void> {
    clearTimeout(this.timer);
    const answers = readAnswers(this.form);
    if (this.sending || this.quarrel.length > 0) return;
    if (same(answers, this.synced)) return this.settled(new Date());
    this.sending = true;
    const body = JSON.stringify({ answers, revision: this.revision });
    const { status, copy } = await call(this.url, { method: "PUT", body, keepalive });
    this.sending = false;
    if (copy !== null) this.accepted(answers, copy);
    else if (status === 409) await this.reread();
    else this.failed(status === 401 || status === 404);
  }

  private accepted(answers: Answers, copy: ServerCopy): void {
    [this.synced, this.revision, this.failures] = [answers, copy.revision, 0];
    const now = readAnswers(this.form);
    for (const [name, text] of Object.entries(answers)) if (now[name] !== this.base[name]) this.base[name] = text;
    this.keep();
    if (same(now, answers)) this.settled(new Date(copy.time ?? Date.now()));
    else {
      this.since = 0;
      this.soon();
    }
  }

  private settled(time: Date): void {
    [this.since, this.failures] = [0, 0];
    this.cell.show("saved", time);
  }

  private async reread(): Promise<void> {
    const { copy } = await call(this.url, {});
    if (copy === null) return this.failed();
    [this.synced, this.revision] = [copy.answers, copy.revision];
    this.adopt(this.base, readAnswers(this.form), copy.answers);
    this.keep();
    if (this.quarrel.length === 0) await this.send();
  }

  private failed(ended = false): void {
    this.cell.show(ended ? "ended" : "unsaved");
    this.again(RETRIES[Math.min(this.failures, RETRIES.length - 1)] ?? 0);
    this.failures += 1;
  }

  private ask(): void {
    const box = this.form.querySelector<HTMLElement>("[data-draft-conflict]");
    if (box === null) return;
    const names = this.quarrel.map((name) => {
      const field = this.form.querySelector(`[name="answer.${CSS.escape(name)}"], [name^="answer.${CSS.escape(name)}."]`);
      return field?.closest(".answer")?.querySelector(".q, legend")?.textContent?.trim() ?? "";
    });
    const which = box.querySelector("[data-draft-which]");
    if (which !== null) which.textContent = names.join("; ");
    box.hidden = this.quarrel.length === 0;
    if (this.quarrel.length > 0) this.cell.show("unsaved");
  }

  /** Ends the quarrel with what stands here, or with what came from elsewhere. */
  take(theirs: boolean): void {
    const names = this.quarrel;
    this.quarrel = [];
    this.ask();
    for (const name of names) this.base[name] = this.synced[name] ?? "";
    for (const name of theirs ? names : []) writeAnswer(this.form, name, this.synced[name] ?? "");
    this.keep();
    void this.send();
  }

  /** Another tab of this browser has typed, or the server has taken what it typed. */
  heard(text: string | null): void {
    const kept = readKept(text, Date.now());
    if (kept === null || kept.graded !== this.graded) return;
    const mine = readAnswers(this.form);
    const quarrel = merge(this.base, mine, kept.synced).conflicts;
    const { answers, base } = merge(this.base, mine, kept.answers);
    this.base = base;
    for (const [name, answer] of Object.entries(answers)) if (answer !== mine[name]) writeAnswer(this.form, name, answer);
    if (kept.revision <= this.revision) return;
    [this.synced, this.revision, this.quarrel] = [kept.synced, kept.revision, quarrel];
    this.ask();
  }

  watch(): void {
    this.form.addEventListener("input", () => this.typed());
    this.form.addEventListener("change", () => this.typed());
    this.form.addEventListener("focusout", () => void (this.since !== 0 && this.failures === 0 && this.again(200)));
    this.form.addEventListener("click", ({ target }) => {
      const chosen = target instanceof HTMLElement ? target.dataset["draftTake"] : undefined;
      if (chosen !== undefined) this.take(chosen === "theirs");
    });
    this.form.addEventListener("submit", () => {
      clearTimeout(this.timer); // a draft that arrives after what is handed in would pass for a newer one
      this.since = 0;
    });
    window.addEventListener("online", () => this.again(0));
    window.addEventListener("pagehide", () => void (this.since !== 0 && this.send(true)));
    window.addEventListener("storage", (event) => void (event.key === this.key && this.heard(event.newValue)));
  }
}

/** Restores and keeps the draft of a form with `data-draft`, the address of the server's copy. */
export function restoreDraft(form: HTMLFormElement): void {
  const url = form.dataset["draft"];
  if (url !== undefined) new Draft(form, url).watch();
}
