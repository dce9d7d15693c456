/* The copy of a draft in this browser: written at each key, read after a crash. */
import type { Answers } from "./answers.ts";

export interface Kept {
  time: number; // ms since the epoch
  revision: number; // of the server's copy that `synced` is
  answers: Answers;
  synced: Answers;
  graded: string; // number of the receipt after which this draft began
}

const PREFIX = "grubler.draft.";
const LIFE = 30 * 24 * 3600 * 1000; // ms; the server forgets an idle practice variant after the same 30 days

export const keyOf = (url: string): string => PREFIX + url;

function isAnswers(value: unknown): value is Answers {
  return typeof value === "object" && value !== null && Object.values(value).every((text) => typeof text === "string");
}

/** The draft in a stored text; null for what is old, foreign or damaged. */
export function readKept(stored: string | null, now: number): Kept | null {
  let found: unknown;
  try {
    found = JSON.parse(stored ?? "null");
  } catch {
    return null;
  }
  if (typeof found !== "object" || found === null) return null;
  const { time, revision, answers, synced, graded } = found as Record<string, unknown>;
  const numbers = typeof time === "number" && typeof revision === "number" && now - time < LIFE;
  if (!numbers || !isAnswers(answers) || !isAnswers(synced) || typeof graded !== "string") return null;
  return { time, revision, answers, synced, graded };
}

/* Storage may be forbidden or full: the page then works as it does without script. */
function carefully<T>(action: (store: Storage) => T): T | null {
  try {
    return action(localStorage);
  } catch (fault) {
    if (fault instanceof DOMException) return null;
    throw fault;
  }
}

function forgetOld(store: Storage): void {
  for (const key of Object.keys(store)) {
    if (key.startsWith(PREFIX) && readKept(store.getItem(key), Date.now()) === null) store.removeItem(key);
  }
}

export function load(key: string): Kept | null {
  return carefully((store) => {
    forgetOld(store);
    return readKept(store.getItem(key), Date.now());
  });
}

/** Keeps a draft; tells whether this browser does. */
export function store(key: string, kept: Kept): boolean {
  return carefully((place) => (place.setItem(key, JSON.stringify(kept)), true)) ?? false;
}
