/* One press, one attempt: while the answers travel the button says so; without a connection they wait for it. */

const AGAIN = 3000; // ms between two looks for the server
const SILENCE = 8000; // ms after which it counts as out of reach

/** Whether the server can be reached; what it says, the next page shows. */
async function reached(): Promise<boolean> {
  try {
    await fetch("/health", { cache: "no-store", signal: AbortSignal.timeout(SILENCE) });
    return true;
  } catch {
    return false;
  }
}

class Sender {
  private readonly form: HTMLFormElement;
  private readonly sending: string;
  private readonly waiting: HTMLElement | null;
  private held: HTMLElement | null = null;
  private label = "";
  private passing = false;
  private timer = 0;

  constructor(form: HTMLFormElement, sending: string) {
    [this.form, this.sending] = [form, sending];
    this.waiting = form.querySelector("[data-waiting]");
  }

  private hold(button: HTMLElement): void {
    [this.held, this.label] = [button, button.textContent ?? ""];
    button.textContent = this.sending;
    button.setAttribute("aria-disabled", "true"); // `disabled` would drop the focus and the button's own value
  }

  release(): void {
    clearTimeout(this.timer);
    if (this.held === null) return;
    this.held.textContent = this.label;
    this.held.removeAttribute("aria-disabled");
    this.held = null;
    if (this.waiting !== null) this.waiting.textContent = "";
  }

  pressed(event: SubmitEvent, main: HTMLElement): void {
    if (this.passing) {
      this.passing = false;
      return;
    }
    const again = this.held !== null;
    if (!again) this.hold(event.submitter ?? main);
    if (again || this.waiting !== null) event.preventDefault();
    if (!again && this.waiting !== null) void this.send();
  }

  /** Sends the form as it was pressed, its key included, as soon as the server can be reached. */
  private async send(): Promise<void> {
    clearTimeout(this.timer);
    const pressed = this.held;
    const free = await reached();
    if (this.held === null || this.held !== pressed) return; // typed on, or gone
    if (!free) return this.wait();
    this.passing = true;
    this.form.requestSubmit(this.held);
  }

  private wait(): void {
    if (this.waiting !== null) this.waiting.textContent = this.form.dataset["wordWaiting"] ?? "";
    this.timer = window.setTimeout(() => void this.send(), AGAIN);
  }

  private get waits(): boolean {
    return this.held !== null && (this.waiting?.textContent ?? "") !== "";
  }

  back(): void {
    if (this.waits) void this.send();
  }

  typed(): void {
    if (this.waits) this.release(); // whoever types on has not finished
  }
}

/** Guards a form whose button carries `data-sending`, the words to show while it is on its way. */
export function guardSubmit(form: HTMLFormElement): void {
  const button = form.querySelector<HTMLElement>("button[data-sending]");
  if (button === null) return;
  const sender = new Sender(form, button.dataset["sending"] ?? "");
  form.addEventListener("submit", (event) => sender.pressed(event, button));
  form.addEventListener("input", () => sender.typed());
  window.addEventListener("online", () => sender.back());
  window.addEventListener("pageshow", () => sender.release()); // back from the next page
}
