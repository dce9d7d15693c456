/* The time of the stage: a slider, two steps and a button that plays. Nothing moves before it is pressed. */

const SHORTEST = 3; // s that one run takes at least: a fast machine is shown slowly
const STEPS = 120;
const PACE = 400; // ms between the still pictures for those who prefer less motion

export class Clock {
  private readonly slider: HTMLInputElement;
  private readonly span: number;
  private readonly turned: () => void;
  private readonly switched: (playing: boolean) => void;
  private timer: number | null = null;
  private last = 0;

  constructor(slider: HTMLInputElement, span: number, turned: () => void, switched: (playing: boolean) => void) {
    [this.slider, this.span, this.turned, this.switched] = [slider, span, turned, switched];
    slider.max = String(span);
    slider.step = String(span / STEPS);
    slider.addEventListener("input", () => {
      this.stop();
      turned();
    });
  }

  get t(): number {
    return Number(this.slider.value);
  }

  get playing(): boolean {
    return this.timer !== null;
  }

  go(t: number): void {
    this.slider.value = String(Math.min(this.span, Math.max(0, t)));
    this.turned();
  }

  step(way: 1 | -1): void {
    this.stop();
    this.go(this.t + (way * this.span) / 30);
  }

  toggle(): void {
    if (this.playing) return this.stop();
    if (this.t >= this.span * (1 - 1e-9)) this.go(0);
    this.last = performance.now();
    this.next();
    this.switched(true);
  }

  private stop(): void {
    if (this.timer === null) return;
    cancelAnimationFrame(this.timer);
    clearTimeout(this.timer);
    this.timer = null;
    this.switched(false);
  }

  private next(): void {
    const still = matchMedia("(prefers-reduced-motion: reduce)").matches;
    const run = (): void => {
      const now = performance.now();
      const gone = ((now - this.last) / 1000) * (this.span / Math.max(SHORTEST, this.span));
      this.last = now;
      const t = this.t + (still ? this.span / 15 : gone);
      this.go(t);
      if (t >= this.span) this.stop();
      else this.next();
    };
    this.timer = still ? window.setTimeout(run, PACE) : requestAnimationFrame(run);
  }
}
