/* The laboratory: the student's relations drive a machine, its readouts, its curves and its samples. */
import { follow } from "./asking.ts";
import { distance, finding, type Finding } from "./check.ts";
import { Clock } from "./clock.ts";
import { reach, valuesAt, type Machine } from "./machine.ts";
import { Motion, NOTHING, speed, valueOf, type Own } from "./motion.ts";
import { KINDS, Plot } from "./plots.ts";
import { readFormula, readPolygon, readRates } from "./relations.ts";
import { differences, read, written, type Row } from "./samples.ts";
import { Stage } from "./stage.ts";
import type { Values } from "./tree.ts";
import { decimals, filled, Numbers } from "./words.ts";

const TABLE_STEP = 5; // samples between the rows of the table
const SILENCE = 800; // ms without change after which the note is spoken

export class Panel {
  private readonly bench: HTMLElement;
  private readonly machine: Machine;
  private readonly words: Record<string, string>;
  private readonly numbers: Numbers;
  private readonly stage: Stage;
  private readonly plots: Plot[];
  private readonly clock: Clock;
  private readonly given: Values;
  private refused = false; // what stands in the field of the polygon could not be read
  private readonly held: boolean; // an examination: no ghost, no check, no distance
  private values: Values;
  private own: Own = NOTHING;
  private motion: Motion;
  private base: Motion; // with the data of the variant
  private speaking = 0;
  private drawing = 0;

  constructor(bench: HTMLElement, form: HTMLFormElement) {
    this.bench = bench;
    this.machine = JSON.parse(bench.dataset["laboratory"]!) as Machine;
    this.words = JSON.parse(bench.dataset["words"]!) as Record<string, string>;
    this.numbers = new Numbers(document.documentElement.lang);
    this.held = bench.dataset["held"] !== undefined;
    this.given = new Map(Object.entries(this.machine.values));
    this.values = new Map(this.given);
    this.motion = this.base = new Motion(this.machine, this.given, this.own);
    this.stage = new Stage(this.part("stage"), this.machine, this.numbers, this.held);
    this.plots = [...document.querySelectorAll<HTMLElement>("[data-plot]")].map((one) => new Plot(one, this.numbers, this.words));
    this.clock = new Clock(document.querySelector<HTMLInputElement>("#lab-t")!, this.machine.span, () => this.show(), (on) => this.playing(on));
    this.listen(form);
    this.changed();
  }

  private part(name: string): HTMLElement {
    return document.querySelector<HTMLElement>(`[data-lab="${name}"]`)!;
  }

  private get axis(): number {
    return Number(document.querySelector<HTMLInputElement>('[name="lab-axis"]:checked')?.value ?? 0);
  }

  private listen(form: HTMLFormElement): void {
    this.sliders();
    this.part("play").addEventListener("click", () => this.clock.toggle());
    this.part("back").addEventListener("click", () => this.clock.step(-1));
    this.part("forth").addEventListener("click", () => this.clock.step(1));
    for (const one of document.querySelectorAll('[name="lab-axis"]')) one.addEventListener("change", () => this.changed());
    for (const plot of this.plots) plot.follow((t) => this.clock.playing || this.clock.go(t));
    const field = form.querySelector<HTMLTextAreaElement>('[name="answer.polygon"]');
    follow(form, "polygon", (wire) => {
      const polygon = readPolygon(wire);
      this.refused = polygon === null && (field?.value.trim() ?? "") !== "";
      this.learn({ polygon });
    });
    follow(form, "velocities", (wire) => this.learn({ velocities: readRates(wire) }));
    follow(form, "accelerations", (wire) => this.learn({ accelerations: readRates(wire) }));
    for (const name of this.machine.plotted.flatMap(({ rate, surge }) => [rate, surge])) {
      follow(form, `${name}_formula`, (wire) => this.formula(name, wire));
    }
    this.exchange();
  }

  private learn(part: Partial<Own>): void {
    this.own = { ...this.own, ...part };
    this.base = new Motion(this.machine, this.given, this.own);
    this.changed();
  }

  private formula(name: string, wire: unknown): void {
    const formulas = new Map(this.own.formulas);
    const found = readFormula(wire);
    if (found === null) formulas.delete(name);
    else formulas.set(name, found);
    this.learn({ formulas });
  }

  private sliders(): void {
    const all = [...this.bench.querySelectorAll<HTMLInputElement>("[data-given]")];
    const tell = (slider: HTMLInputElement): void => {
      const value = Number(slider.value);
      const scale = this.given.get(slider.dataset["given"]!)!;
      const said = this.numbers.shown(value, decimals(scale, 3), slider.dataset["unit"]);
      slider.parentElement!.querySelector("output")!.textContent = said;
      slider.setAttribute("aria-valuetext", said);
    };
    const put = (): void => {
      for (const slider of all) {
        const value = this.given.get(slider.dataset["given"]!)!;
        const length = this.machine.links.some((link) => link.length === slider.dataset["given"]);
        const size = Math.abs(value) || 1;
        slider.min = String(round(length ? size / 2 : -2 * size));
        slider.max = String(round(2 * size));
        slider.step = String(round(size / (length ? 200 : 50)));
        slider.value = String(value);
        tell(slider);
      }
    };
    put();
    for (const slider of all) {
      slider.addEventListener("input", () => {
        this.values.set(slider.dataset["given"]!, Number(slider.value));
        tell(slider);
        cancelAnimationFrame(this.drawing);
        this.drawing = requestAnimationFrame(() => this.changed()); // once a frame while a slider is dragged
      });
    }
    this.part("reset").addEventListener("click", () => {
      this.values = new Map(this.given);
      put();
      this.changed();
    });
  }

  /* After a change of relations, sizes or the coordinate shown. */
  private changed(): void {
    this.motion = new Motion(this.machine, this.values, this.own);
    this.stage.fit(this.motion, reach(this.machine, this.values));
    const { axis } = this.machine.plotted[this.axis]!;
    for (const plot of this.plots) plot.draw(this.motion, axis, this.held);
    this.tabulate(axis);
    this.show();
  }

  /* After a change of time. */
  private show(): void {
    const { t } = this.clock;
    const moment = this.motion.at(t);
    const values = valuesAt(this.machine, this.values, t);
    this.stage.draw(moment, values);
    const typed = this.own.polygon !== null;
    const found = finding(this.machine, moment, values, typed);
    this.note(this.held && typed ? { kind: "held" } : found.kind === "nothing" && this.refused ? { kind: "unread" } : found);
    const places = decimals(reach(this.machine, this.values), 4);
    this.machine.plotted.forEach(({ axis }, at) => {
      this.part(`own-${at}`).textContent = this.numbers.shown(valueOf(moment, "position", axis), places, "m");
    });
    if (!this.held) this.part("distance").textContent = this.numbers.shown(distance(moment), places, "m");
    const time = this.numbers.shown(t, decimals(this.machine.span, 3), "s");
    this.part("time-value").textContent = time;
    document.querySelector("#lab-t")!.setAttribute("aria-valuetext", time);
    const { axis } = this.machine.plotted[this.axis]!;
    this.plots.forEach((plot, at) => plot.point(t, valueOf(moment, KINDS[at]!, axis), plot.beneath(t)));
    this.observe(t);
  }

  private note(found: Finding): void {
    const text = this.sentence(found);
    const note = this.part("note");
    note.textContent = text;
    note.classList.toggle("torn", found.kind === "broken" || found.kind === "unsolved");
    note.classList.toggle("fits", found.kind === "agrees");
    if (this.clock.playing) return;
    clearTimeout(this.speaking);
    this.speaking = window.setTimeout(() => {
      if (this.part("spoken").textContent !== text) this.part("spoken").textContent = text;
    }, SILENCE);
  }

  private sentence(found: Finding): string {
    const last = this.machine.links.at(-1)!.end;
    const metres = (value: number, scale: number): string => this.numbers.shown(value, decimals(scale, 3), "m");
    if (found.kind === "astray") {
      return filled(this.words["astray"]!, { node: last, distance: metres(found.distance, reach(this.machine, this.given)) });
    }
    if (found.kind !== "broken") return filled(this.words[found.kind]!, { node: last });
    const sentences = found.links.map(({ at, own, true: length }) => {
      const { start, end, slides } = this.machine.links[at]!;
      const said = { link: start + end, true: metres(length, length), own: metres(own, length) };
      return filled(this.words[slides ? "slide" : "link"]!, said);
    });
    return sentences.join(" ");
  }

  private observe(t: number): void {
    const [now, then] = [speed(this.motion, t), speed(this.base, t)];
    const places = decimals(then, 4);
    this.part("speed-now").textContent = this.numbers.shown(now, places, "m/s");
    this.part("speed-then").textContent = this.numbers.shown(then, places, "m/s");
    this.part("ratio").textContent = this.numbers.shown(now / then, 4);
  }

  private playing(on: boolean): void {
    this.part("play").textContent = this.words[on ? "stop" : "play"]!;
    this.show();
  }

  private tabulate(axis: "x" | "y"): void {
    const curves = [
      this.motion.curve("position", axis), this.motion.curve("velocity", axis), this.motion.under("velocity", axis),
      this.motion.curve("acceleration", axis), this.motion.under("acceleration", axis),
    ];
    const rows = this.motion.moments.flatMap(({ t }, at) => {
      if (at % TABLE_STEP !== 0) return [];
      const row = document.createElement("tr");
      const cells = [t, ...curves.map((curve) => curve[at]!)].map((value, column) => {
        const cell = document.createElement(column === 0 ? "th" : "td");
        cell.className = "num";
        if (column === 0) cell.setAttribute("scope", "row");
        cell.textContent = this.numbers.shown(value, column === 0 ? decimals(this.machine.span, 3) : 4);
        return cell;
      });
      row.append(...cells);
      return [row];
    });
    this.part("table").querySelector("tbody")!.replaceChildren(...rows);
  }

  private row(t: number): Row {
    const moment = this.motion.at(t);
    const { axis } = this.machine.plotted[this.axis]!;
    const [x, v, a] = KINDS.map((kind) => valueOf(moment, kind, axis));
    return { t, x: x!, v: v!, a: a! };
  }

  private exchange(): void {
    const field = document.querySelector<HTMLTextAreaElement>("#lab-csv")!;
    const take = (file: File | undefined): void => {
      void file?.slice(0, 500_000).text().then((text) => {
        field.value = text;
        this.compare(text);
      });
    };
    this.part("export").addEventListener("click", () => save(written(this.motion.moments.map(({ t }) => this.row(t)), this.numbers.comma)));
    this.part("compare").addEventListener("click", () => this.compare(field.value));
    const chosen = this.part("file") as HTMLInputElement;
    chosen.addEventListener("change", () => take(chosen.files?.[0]));
    field.addEventListener("dragover", (event) => event.preventDefault());
    field.addEventListener("drop", (event) => {
      const file = event.dataTransfer?.files[0];
      if (file === undefined) return; // dropped text falls in by itself
      event.preventDefault();
      take(file);
    });
  }

  private compare(text: string): void {
    const rows = read(text);
    const found = Array.isArray(rows) ? differences(rows, (t) => this.row(t)) : [];
    const said = Array.isArray(rows)
      ? found.map(({ column, most, t, size }) => {
          const unit = { x: "m", v: "m/s", a: "m/s\u00b2" }[column];
          const told = { column, most: this.numbers.shown(most, decimals(Math.max(most, size / 1e4) || 1, 3), unit), time: this.numbers.shown(t, decimals(this.machine.span, 3), "s") };
          return filled(this.words["difference"]!, told);
        })
      : [filled(this.words["bad_line"]!, { line: String(rows.line) })];
    const lines = (said.length > 0 ? said : [this.words["nothing_common"]!]).map((sentence) => {
      const line = document.createElement("p");
      line.textContent = sentence;
      return line;
    });
    this.part("differences").replaceChildren(...lines);
  }
}

const round = (value: number): number => Number(value.toPrecision(12));

function save(text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "text/csv" }));
  link.download = "samples.csv";
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Starts the laboratory of a page. */
export function start(bench: HTMLElement): void {
  const form = document.querySelector<HTMLFormElement>("form[data-preview]");
  if (form !== null) new Panel(bench, form);
}
