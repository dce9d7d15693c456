/* The diagram editor: a drawing with handles over its table; the two are one answer, and the table is sent. */
import { announceInput } from "./fields.ts";
import { FILLED } from "./twin.ts";
import {
  after, inserted, middleOf, moveOf, ordinate, placesOf, removed, rowsOf, scaleOf, withOrdinate, withPlace, written,
  type Place, type Scale, type Side,
} from "./sketch_model.ts";

const SVG = "http://www.w3.org/2000/svg";
const [WIDTH, HEIGHT, EDGE, PIECES] = [560, 240, 34, 24] as const;
const ADDS = ["Enter", " ", "Insert"];
const REMOVES = ["Delete", "Backspace"];

interface Handle {
  at: number;
  side: Side;
  x: number;
  value: number;
}

function draw(name: string, attributes: Record<string, string | number>): SVGElement {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) node.setAttribute(key, String(value));
  return node;
}

function handlesOf(places: Place[]): Handle[] {
  return places.flatMap((place, at): Handle[] => {
    const next = places[at + 1];
    const sides: Handle[] = [{ at, side: "left", x: place.x, value: place.left }];
    if (place.right !== null) sides.push({ at, side: "right", x: place.x, value: place.right });
    if (next) sides.push({ at, side: "middle", x: (place.x + next.x) / 2, value: middleOf(place, next) });
    return sides;
  });
}

class Sketch {
  private readonly box: HTMLElement;
  private readonly table: HTMLTableElement;
  private readonly spoken = document.createElement("p");
  private readonly comma = document.documentElement.lang !== "en";
  private readonly downwards: boolean;
  private readonly figure: SVGElement;
  private readonly area = draw("path", { class: "f-area" });
  private readonly ordinates = draw("path", { class: "f-ord" });
  private readonly curve = draw("path", { class: "f-pos" });
  private readonly labels = draw("g", {});
  private readonly knobs = new Map<string, SVGElement>();
  private scale: Scale = scaleOf([], 1);

  constructor(box: HTMLElement, table: HTMLTableElement) {
    [this.box, this.table] = [box, table];
    this.downwards = box.dataset["quantity"] === "M"; // on the side in tension
    this.figure = draw("svg", { class: "fig", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "group", "aria-label": box.dataset["wordTitle"] ?? "" });
    const zero = draw("path", { class: "f-thick", d: `M${EDGE} ${HEIGHT / 2}H${WIDTH - EDGE}` });
    this.figure.append(this.area, this.ordinates, zero, this.curve, this.labels);
    const help = box.querySelector(".help")?.id;
    if (help) this.figure.setAttribute("aria-describedby", help);
    this.spoken.className = "vh";
    this.spoken.setAttribute("role", "status");
    box.prepend(this.figure);
    box.append(this.spoken);
    this.show();
  }

  private cells(): HTMLInputElement[][] {
    return Array.from(this.table.tBodies[0]?.rows ?? [], (row) => Array.from(row.querySelectorAll("input")));
  }

  /* The text says what no table can show. */
  private get locked(): boolean {
    return this.cells()[0]?.[0]?.readOnly ?? false;
  }

  private places(): Place[] | null {
    const found = placesOf(this.cells().map((row) => row.map((cell) => cell.value)));
    if (found === null || found.length > 1) return found;
    const start = found[0] ?? { x: 0, left: 0, right: null, middle: null };
    return [start, { x: start.x + Number(this.box.dataset["span"] ?? 1), left: 0, right: null, middle: null }];
  }

  private x(value: number): number {
    const { first, last } = this.scale;
    return EDGE + ((value - first) / (last - first)) * (WIDTH - 2 * EDGE);
  }

  private y(value: number): number {
    return HEIGHT / 2 + ((this.downwards ? 1 : -1) * value * (HEIGHT / 2 - EDGE)) / this.scale.highest;
  }

  /* One empty row beyond the last that is used stays in sight. */
  private fold(): void {
    const rows = this.cells();
    const used = rows.findLastIndex((row) => row.some((cell) => cell.value.trim() !== "" || cell === document.activeElement));
    rows.forEach((row, at) => row[0]?.closest("tr")?.toggleAttribute("hidden", at > Math.max(used + 1, 2)));
  }

  show(): void {
    const places = this.places();
    this.fold();
    this.box.hidden = places === null || this.locked;
    if (places === null) return;
    this.scale = scaleOf(places, Number(this.box.dataset["span"] ?? 1));
    this.drawCurve(places);
    this.drawHandles(handlesOf(places));
  }

  private drawCurve(places: Place[]): void {
    let [line, ordinates] = ["", ""];
    places.forEach((place, at) => {
      const next = places[at + 1];
      line += `${at === 0 ? "M" : "L"}${this.point(place.x, at === 0 ? 0 : place.left)}L${this.point(place.x, after(place))}`;
      for (let piece = 1; next && piece <= PIECES; piece += 1) {
        const share = piece / PIECES;
        const [x, value] = [place.x + (next.x - place.x) * share, ordinate(place, next, share)];
        line += `L${this.point(x, value)}`;
        ordinates += `M${this.point(x, 0)}L${this.point(x, value)}`;
      }
    });
    const end = `L${this.point(places.at(-1)?.x ?? 0, 0)}`;
    this.curve.setAttribute("d", line + end);
    this.area.setAttribute("d", `${line}${end}Z`);
    this.ordinates.setAttribute("d", ordinates);
  }

  private point(x: number, value: number): string {
    return `${this.x(x).toFixed(1)} ${this.y(value).toFixed(1)}`;
  }

  private drawHandles(handles: Handle[]): void {
    this.labels.replaceChildren();
    const seen = new Set<string>();
    let next: SVGElement = this.labels; // Tab goes along the bar; a handle that has the focus is never moved
    for (const handle of handles.toReversed()) {
      const key = `${handle.at}.${handle.side}`;
      seen.add(key);
      const knob: SVGElement = this.knobs.get(key) ?? this.knob(handle.at, handle.side);
      if (!this.knobs.has(key)) this.figure.insertBefore(knob, next);
      this.knobs.set(key, knob);
      this.place(knob, handle);
      next = knob;
    }
    for (const [key, knob] of this.knobs) {
      if (seen.has(key)) continue;
      knob.remove();
      this.knobs.delete(key);
    }
  }

  private place(knob: SVGElement, { at, side, x, value }: Handle): void {
    const [left, top] = [this.x(x), this.y(value)];
    knob.setAttribute("transform", `translate(${left.toFixed(1)} ${top.toFixed(1)})`);
    const said = { x: written(x, this.comma), value: written(value, this.comma).replace("-", "−") };
    const { quantity = "", unit = "", xUnit = "" } = this.box.dataset;
    knob.setAttribute("aria-valuenow", String(value));
    knob.setAttribute("aria-valuemin", String(-this.scale.highest));
    knob.setAttribute("aria-valuemax", String(this.scale.highest));
    knob.setAttribute("aria-valuetext", `x ${said.x} ${xUnit}, ${quantity} ${said.value} ${unit}`.trim());
    const word = this.box.dataset[`word${side[0]?.toUpperCase()}${side.slice(1)}`] ?? "";
    knob.setAttribute("aria-label", word.replace("{row}", String(at + 1)));
    if (side !== "middle") this.label(left, top, side, said.value);
  }

  private label(left: number, top: number, side: Side, text: string): void {
    const below = top >= HEIGHT / 2;
    const anchor = side === "right" ? "start" : left < WIDTH / 2 ? "start" : "end";
    const node = draw("text", { class: "n halo", x: left + (anchor === "start" ? 13 : -13), y: top + (below ? 22 : -13), "text-anchor": anchor });
    node.textContent = text;
    this.labels.append(node);
  }

  private knob(at: number, side: Side): SVGElement {
    const knob = draw("g", { class: `handle ${side}`, role: "slider", tabindex: 0, "aria-orientation": "vertical" });
    knob.append(draw("rect", { class: "target", x: -22, y: -22, width: 44, height: 44 }), draw("rect", { class: "f-handle", x: -5, y: -5, width: 10, height: 10 }));
    knob.addEventListener("keydown", (event) => this.key(event as KeyboardEvent, at, side));
    knob.addEventListener("pointerdown", (event) => {
      knob.setPointerCapture((event as PointerEvent).pointerId);
      knob.focus();
    });
    knob.addEventListener("pointermove", (event) => {
      if (knob.hasPointerCapture((event as PointerEvent).pointerId)) this.drag(event as PointerEvent, at, side);
    });
    return knob;
  }

  private key(event: KeyboardEvent, at: number, side: Side): void {
    const places = this.places();
    if (places === null || this.locked || event.ctrlKey || event.altKey || event.metaKey) return;
    const move = moveOf(event.key, event.shiftKey, this.downwards);
    if (move !== null) this.write(this.stepped(places, at, side, move));
    else if (ADDS.includes(event.key)) this.add(places, at, side);
    else if (REMOVES.includes(event.key)) this.remove(places, at, side);
    else if (event.key === "Escape") this.leave(at, side);
    else return;
    event.preventDefault();
  }

  private say(word: string, at: number): void {
    this.spoken.textContent = (this.box.dataset[word] ?? "").replace("{row}", String(at + 1));
  }

  private add(places: Place[], at: number, side: Side): void {
    const changed = inserted(places, at, side, this.cells().length);
    if (changed === places) return this.say("wordFull", at);
    this.write(changed);
    if (changed.length > places.length) this.say("wordAdded", at + 1);
    else this.say("wordJump", at);
  }

  private remove(places: Place[], at: number, side: Side): void {
    const changed = removed(places, at, side);
    if (changed === places) return this.say("wordEnds", at);
    this.write(changed);
    const stays = side === "middle" ? this.knobs.get(`${at}.middle`) : undefined;
    (stays ?? this.knobs.get(`${Math.min(at, changed.length - 1)}.left`))?.focus();
    this.say({ left: "wordRemoved", right: "wordNoJump", middle: "wordNoBend" }[side], at);
  }

  /* To the cell of the table that says the same as the handle. */
  private leave(at: number, side: Side): void {
    const [rows, column] = [this.cells(), { left: 1, right: 2, middle: 3 }[side]];
    const used = rows.filter((row) => row.some((cell) => cell.value.trim() !== ""));
    ((used[at] ?? rows[at])?.[column] ?? rows[0]?.[0])?.focus();
  }

  private stepped(places: Place[], at: number, side: Side, move: { x: number; value: number }): Place[] {
    const handle = handlesOf(places).find((one) => one.at === at && one.side === side);
    if (handle === undefined) return places;
    if (move.value !== 0) return withOrdinate(places, at, side, handle.value + move.value * this.scale.step, this.scale);
    return side === "middle" ? places : withPlace(places, at, handle.x + move.x * this.scale.xStep, this.scale);
  }

  private drag(event: PointerEvent, at: number, side: Side): void {
    const [places, matrix] = [this.places(), (this.figure as SVGSVGElement).getScreenCTM()];
    if (places === null || this.locked || matrix === null) return;
    const { y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    const value = ((this.downwards ? 1 : -1) * (y - HEIGHT / 2) * this.scale.highest) / (HEIGHT / 2 - EDGE);
    const held = Math.max(-this.scale.highest, Math.min(this.scale.highest, value));
    this.write(withOrdinate(places, at, side, held, this.scale));
  }

  private write(places: Place[]): void {
    const rows = rowsOf(places, this.comma);
    const cells = this.cells();
    cells.forEach((row, r) => row.forEach((cell, c) => (cell.value = rows[r]?.[c] ?? "")));
    const first = cells[0]?.[0];
    if (first !== undefined) announceInput(first);
  }
}

/** Starts the editor of a `[data-sketch]` beside its table. */
export function sketch(box: HTMLElement): void {
  const answer = box.closest<HTMLElement>(".answer");
  const table = answer?.querySelector<HTMLTableElement>("table[data-join='table']");
  if (!answer || !table) return;
  const made = new Sketch(box, table);
  for (const change of ["input", FILLED]) answer.addEventListener(change, () => made.show());
}
