/* The time left until a task is due, kept up to date; it is spoken at an hour, ten minutes, one minute and at the end.
   Beside it what the task is by now: open, past due, closed. */

const SPOKEN = [3600, 600, 60, 0]; // seconds left
const DAY = 24 * 60; // minutes

export type Left = Readonly<Record<"days" | "hours" | "over", string>>;

/** Tells seconds in words: days and hours, else hours and minutes; at the end that they are over. */
export function inTime(seconds: number, words: Left): string {
  if (seconds <= 0) return words.over;
  const minutes = Math.floor(seconds / 60);
  const far = minutes >= DAY;
  const [first, second] = far ? [minutes / DAY, (minutes / 60) % 24] : [minutes / 60, minutes % 60];
  const told = (part: number): string => String(Math.floor(part));
  return words[far ? "days" : "hours"].replace("{first}", told(first)).replace("{second}", told(second));
}

/** Whether one of the moments that are spoken lies between two looks. */
export function passes(before: number, after: number): boolean {
  return SPOKEN.some((moment) => before > moment && after <= moment);
}

export type Ahead = Readonly<Partial<Record<"late" | "lateIn" | "closed" | "closedIn", string>>>;

/** What a task is some seconds after the page was made: closed, past due, or what the page says. */
export function stageAfter(seconds: number, ahead: Ahead): string | undefined {
  if (ahead.closedIn !== undefined && seconds > Number(ahead.closedIn)) return ahead.closed;
  return ahead.lateIn !== undefined && seconds > Number(ahead.lateIn) ? ahead.late : undefined;
}

/** Keeps what a task is up to date; what is typed stays, and the server has the last word. */
export function tellStage(line: HTMLElement): void {
  const made = Date.now();
  const timer = window.setInterval(() => {
    const seconds = (Date.now() - made) / 1000;
    const stage = stageAfter(seconds, line.dataset);
    if (stage !== undefined && line.textContent !== stage) line.textContent = stage;
    if (stage !== undefined && stage === line.dataset["closed"]) clearInterval(timer);
  }, 1000);
}

/** Keeps a line with `data-left`, the seconds left when the page was made, and the live region behind it. */
export function tellTimeLeft(line: HTMLElement): void {
  const { left, days = "", hours = "", over = "" } = line.dataset;
  const end = Date.now() + Number(left) * 1000;
  let before = Number(left);
  const timer = window.setInterval(() => {
    const now = (end - Date.now()) / 1000;
    const text = inTime(now, { days, hours, over });
    if (line.textContent !== text) line.textContent = text;
    line.classList.toggle("soon", now < DAY * 60);
    if (passes(before, now) && line.nextElementSibling !== null) line.nextElementSibling.textContent = text;
    before = now;
    if (now <= 0) clearInterval(timer);
  }, 1000);
}
