/* The curves of one coordinate: own over true for the position, own over the derivative of the previous own one. */
import { layer, paint, path, type Shape } from "./drawing.ts";
import type { Motion } from "./motion.ts";
import { decimals, filled, type Numbers } from "./words.ts";

export const KINDS = ["position", "velocity", "acceleration"] as const;
export type Kind = (typeof KINDS)[number];
export const UNITS: Record<Kind, string> = { position: "m", velocity: "m/s", acceleration: "m/s\u00b2" };
const SECTIONS: Record<Kind, string> = { position: "7", velocity: "10", acceleration: "10" };
const [LEFT, RIGHT, TOP, BOTTOM, HEIGHT] = [58, 552, 10, 104, 132];
const CLEAR = 18; // of the nought at the axis, for a value beside it

/** The least and the largest of curves; zero always belongs. */
export function extremes(...curves: (readonly number[])[]): [number, number] {
  const all = curves.flat().filter(Number.isFinite);
  return [Math.min(0, ...all), Math.max(0, ...all)];
}

export class Plot {
  private readonly figure: HTMLElement;
  private readonly numbers: Numbers;
  private readonly words: Record<string, string>;
  private readonly kind: Kind;
  private readonly curves: Element;
  private readonly mark: Element;
  private own: number[] = [];
  private under: number[] = [];
  private span = 1;

  constructor(figure: HTMLElement, numbers: Numbers, words: Record<string, string>) {
    this.figure = figure;
    this.numbers = numbers;
    this.words = words;
    this.kind = figure.dataset["plot"] as Kind;
    const drawing = figure.querySelector("svg")!;
    [this.curves, this.mark] = [layer(drawing), layer(drawing)];
    figure.querySelector("[data-plot-unit]")!.textContent = numbers.unit(UNITS[this.kind]);
  }

  /** Draws both curves of a motion. */
  draw(motion: Motion, axis: "x" | "y", held: boolean): void {
    this.span = motion.machine.span;
    [this.own, this.under] = [motion.curve(this.kind, axis), motion.under(this.kind, axis)];
    if (held && this.kind === "position") this.under = this.own;
    const [low, high] = extremes(this.own, this.under);
    const y = (value: number): number => BOTTOM - ((BOTTOM - TOP) * (value - low)) / (high - low || 1);
    const way = (curve: readonly number[]): string =>
      path(curve.map((value, k) => [LEFT + ((RIGHT - LEFT) * k) / (curve.length - 1), y(value)] as const));
    const places = decimals(high - low, 2);
    const ends = [low, high].filter((value) => Math.abs(y(value) - y(0)) > CLEAR);
    const shapes: Shape[] = [
      ["path", { class: "f-thin", d: `M${LEFT} ${TOP}V${BOTTOM}M${LEFT} ${y(0).toFixed(1)}H${RIGHT}` }],
      ["text", { class: "n", x: LEFT - 6, y: (y(0) + 4).toFixed(1), "text-anchor": "end" }, "0"],
      ...ends.map((value): Shape => ["text", { class: "n", x: LEFT - 6, y: (y(value) + 4).toFixed(1), "text-anchor": "end" }, this.numbers.shown(value, places)]),
      ["path", { class: "f-ghost", d: way(this.under) }],
      ["path", { class: "f-pos", d: way(this.own) }],
      ["text", { class: "n", x: RIGHT, y: HEIGHT - 4, "text-anchor": "end" }, this.numbers.shown(this.span, decimals(this.span, 2), "s")],
      ["text", { class: "n", x: LEFT, y: HEIGHT - 4, "text-anchor": "middle" }, this.numbers.shown(0, 0)],
    ];
    paint(this.curves, shapes);
  }

  /** Puts the cursor at a time and tells the exact values there. */
  point(t: number, value: number, beneath: number): void {
    const x = (LEFT + ((RIGHT - LEFT) * t) / this.span).toFixed(1);
    paint(this.mark, [["path", { class: "f-thin", d: `M${x} ${TOP - 4}V${BOTTOM + 4}` }]]);
    const places = decimals(Math.max(...extremes(this.own, this.under).map(Math.abs)), 4);
    const told = Number.isFinite(value)
      ? this.numbers.shown(value, places, UNITS[this.kind])
      : filled(this.words["waits"]!, { section: SECTIONS[this.kind] });
    const below = this.kind === "position" || !Number.isFinite(beneath) ? "" : filled(this.words["beneath"]!, { value: this.numbers.shown(beneath, places) });
    this.figure.querySelector("output")!.textContent = below === "" ? told : `${told}, ${below}`;
  }

  /** The value of the curve beneath at a time, between its samples. */
  beneath(t: number): number {
    const at = (t / this.span) * (this.under.length - 1);
    const k = Math.min(this.under.length - 2, Math.max(0, Math.floor(at)));
    return this.under[k]! + (at - k) * (this.under[k + 1]! - this.under[k]!);
  }

  /** Calls back with the time under the pointer. */
  follow(turned: (t: number) => void): void {
    const drawing = this.figure.querySelector("svg")!;
    const move = (event: PointerEvent): void => {
      const { left, width } = drawing.getBoundingClientRect();
      const x = ((event.clientX - left) / width) * 560;
      turned(Math.min(1, Math.max(0, (x - LEFT) / (RIGHT - LEFT))) * this.span);
    };
    drawing.addEventListener("pointermove", (event) => {
      if (event.pointerType === "mouse" || event.buttons > 0) move(event);
    });
    drawing.addEventListener("pointerdown", move);
  }
}
