/* The stage: the student's machine over the dashed ghost of the true motion. */
import { broken } from "./check.ts";
import { layer, paint, path, roundStep, type Shape } from "./drawing.ts";
import type { Machine, Point } from "./machine.ts";
import type { Moment, Motion } from "./motion.ts";
import type { Values } from "./tree.ts";
import { decimals, type Numbers } from "./words.ts";

const [WIDTH, HEIGHT, EDGE] = [640, 400, 36];

export class Stage {
  private readonly machine: Machine;
  private readonly numbers: Numbers;
  private readonly ground: Element;
  private readonly moving: Element;
  private scale = 1;
  private origin: readonly [number, number] = [WIDTH / 2, HEIGHT / 2];

  private readonly held: boolean; // nothing of the true motion is shown

  constructor(drawing: Element, machine: Machine, numbers: Numbers, held: boolean) {
    this.machine = machine;
    this.held = held;
    this.numbers = numbers;
    [this.ground, this.moving] = [layer(drawing), layer(drawing)];
  }

  /** Chooses the scale so that the whole motion is seen, and draws what does not move. */
  fit(motion: Motion, size: number): void {
    const seen = motion.moments.flatMap(({ truth, stance }) => [...(this.held ? [] : truth), ...(stance?.nodes ?? [])]);
    const near = [{ x: 0, y: 0 }, ...seen].filter(({ x, y }) => Math.hypot(x, y) <= 2.5 * size);
    const [xs, ys] = [near.map(({ x }) => x), near.map(({ y }) => y)];
    const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    this.scale = Math.min((WIDTH - 2 * EDGE) / (right - left || 1), (HEIGHT - 2 * EDGE) / (high - low || 1));
    this.origin = [WIDTH / 2 - (this.scale * (left + right)) / 2, HEIGHT / 2 + (this.scale * (low + high)) / 2];
    paint(this.ground, [...this.axes(), ...this.trails(motion)]);
  }

  /** Draws one moment. */
  draw(moment: Moment, values: Values): void {
    const own = moment.stance?.nodes ?? null;
    const torn = new Set(this.held ? [] : broken(this.machine, moment, values).map(({ at }) => at));
    const ghost = this.held ? [] : this.chain(moment.truth, true, torn);
    const named = own ?? (this.held ? null : moment.truth);
    paint(this.moving, [
      ...this.frame(), ...ghost, ...(own === null ? [] : this.chain(own, false, torn)), ...(named === null ? [] : this.labels(named)),
    ]);
  }

  private on({ x, y }: Point): readonly [number, number] {
    return [this.origin[0] + this.scale * x, this.origin[1] - this.scale * y];
  }

  private axes(): Shape[] {
    const [x, y] = this.origin;
    const step = roundStep(90 / this.scale);
    const shapes: Shape[] = [["path", { class: "f-axis", d: `M8 ${y.toFixed(1)}H${WIDTH - 8}M${x.toFixed(1)} ${HEIGHT - 8}V8` }]];
    for (let k = Math.ceil((30 - x) / this.scale / step); x + k * step * this.scale < WIDTH - 30; k++) {
      const at = x + k * step * this.scale;
      shapes.push(["path", { class: "f-thin", d: `M${at.toFixed(1)} ${(y - 4).toFixed(1)}v8` }]);
      const label = this.numbers.shown(k * step, decimals(step, 1), "m");
      if (k !== 0 && at > 60) shapes.push(["text", { class: "n halo", x: at.toFixed(1), y: HEIGHT - 6, "text-anchor": "middle" }, label]);
    }
    shapes.push(["text", { class: "t-thin", x: WIDTH - 18, y: (y - 8).toFixed(1) }, "x"]);
    return [...shapes, ["text", { class: "t-thin", x: (x + 8).toFixed(1), y: y < 70 ? HEIGHT - 26 : 20 }, "y"]];
  }

  private trails(motion: Motion): Shape[] {
    const end = (nodes: readonly Point[] | undefined): readonly [number, number] =>
      nodes === undefined ? [NaN, NaN] : this.on(nodes.at(-1)!);
    const [truth, own] = [motion.moments.map((one) => end(one.truth)), motion.moments.map((one) => end(one.stance?.nodes))];
    return [["path", { class: "f-hid", d: this.held ? "" : path(truth) }], ["path", { class: "f-pos f-1", d: path(own) }]];
  }

  private chain(nodes: readonly Point[], ghost: boolean, torn: Set<number>): Shape[] {
    const places = nodes.map((node) => this.on(node));
    const links = this.machine.links.map(({ start, end }, at): Shape => {
      const style = ghost ? "f-ghost" : torn.has(at) ? "f-load f-heavy" : "f-link";
      return ["path", { class: style, d: path([places[at]!, places[at + 1]!]), "data-link": ghost ? "" : start + end }];
    });
    return [...links, ...this.joints(places, ghost)];
  }

  private joints(places: readonly (readonly [number, number])[], ghost: boolean): Shape[] {
    const [pin, body, thick] = ghost ? ["f-ghost-o", "f-ghost-o", "f-ghost"] : ["f-o", "f-body", "f-thick"];
    const turn = (at: number): number => {
      const [[x, y], [u, v]] = [places[at]!, places[at + 1]!];
      return (Math.atan2(v - y, u - x) * 180) / Math.PI;
    };
    const put = (at: number, degrees: number): string =>
      `translate(${places[at]!.map((value) => value.toFixed(1)).join(" ")}) rotate(${degrees.toFixed(1)})`;
    const blocks = this.machine.pairs.flatMap(({ kind }, at): Shape[] =>
      kind === "turn" ? [] : [["rect", { class: body, x: -17, y: -9, width: 34, height: 18, transform: put(at || 1, turn(at)) }]],
    );
    const last = places.length - 1;
    if (this.machine.rod !== "") blocks.push(["rect", { class: body, x: -20, y: -12, width: 40, height: 24, transform: put(last, 0) }]);
    const pins = this.machine.pairs.flatMap(({ kind }, at) => (kind === "turn" ? [at] : []));
    if (this.machine.rod !== "") pins.push(last - 1, last);
    const circles = pins.map((at): Shape => ["circle", { class: pin, cx: places[at]![0].toFixed(1), cy: places[at]![1].toFixed(1), r: 5 }]);
    const fork: Shape[] = this.machine.rod !== "" ? [] : [["path", { class: thick, d: "M12-9H0V9H12", transform: put(last, turn(last - 1)) }]];
    return [...blocks, ...circles, ...fork];
  }

  private frame(): Shape[] {
    if (this.machine.pairs[0]!.kind === "slide") return [];
    const [x, y] = this.origin.map((value) => value.toFixed(1));
    return [
      ["path", { class: "f-o", d: `M${x} ${y}l-13 22h26z` }],
      ["path", { class: "f-thick", d: `M${x} ${y}m-22 22h44` }],
      ["path", { class: "f-hatch", d: `M${x} ${y}m-15 22l-7 8m14-8l-7 8m14-8l-7 8m14-8l-7 8m14-8l-7 8` }],
    ];
  }

  private labels(nodes: readonly Point[]): Shape[] {
    const names = [this.machine.links[0]!.start, ...this.machine.links.map(({ end }) => end)];
    return names.map((name, at): Shape => {
      const [x, y] = this.on(nodes[at]!);
      if (at === nodes.length - 1 && this.machine.rod !== "") return ["text", { class: "r halo", x: x.toFixed(1), y: (y - 22).toFixed(1), "text-anchor": "middle" }, name];
      const [u, v] = at === 0 ? [nodes[1]!.x < 0 ? 0.8 : -0.8, 0.6] : outward(nodes, at); // beside its ground
      return ["text", { class: "r halo", x: (x + 24 * u).toFixed(1), y: (y - 24 * v + 6).toFixed(1), "text-anchor": "middle" }, name];
    });
  }
}

/* Away from the links that meet at a node. */
function outward(nodes: readonly Point[], at: number): [number, number] {
  const here = nodes[at]!;
  const toward = [nodes[at - 1], nodes[at + 1]].flatMap((other) => {
    const far = other === undefined ? 0 : Math.hypot(other.x - here.x, other.y - here.y);
    return other === undefined || far === 0 ? [] : [[(other.x - here.x) / far, (other.y - here.y) / far] as const];
  });
  const [u, v] = toward.reduce(([a, b], [c, d]) => [a - c, b - d] as const, [0, 0] as const);
  const size = Math.hypot(u, v);
  if (toward.length === 0) return [0, 1];
  return size > 0.3 ? [u / size, v / size] : [-toward[0]![1], toward[0]![0]];
}
