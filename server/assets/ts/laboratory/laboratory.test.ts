import assert from "node:assert/strict";
import { test } from "node:test";

import { finding } from "./check.ts";
import { path, roundStep } from "./drawing.ts";
import { trueNodes, valuesAt, type Machine } from "./machine.ts";
import { derivative, Motion, NOTHING } from "./motion.ts";
import { readPolygon, readRates } from "./relations.ts";
import { differences, read, written } from "./samples.ts";
import { linear, owners, Student } from "./student.ts";
import { compile, namesOf, readTree, type Tree } from "./tree.ts";
import { decimals, filled, Numbers } from "./words.ts";

const SLIDER_CRANK: Machine = {
  drives: [{ name: "a1", rate: "w1", surge: "e1" }],
  pairs: [{ kind: "turn", coordinate: "a1", behind: "", datum: 0, turn: 0 }],
  links: [
    { length: "l1", start: "A", end: "B", slides: false, called: ["", "", ""] },
    { length: "l2", start: "B", end: "C", slides: false, called: ["", "", ""] },
  ],
  plotted: [{ axis: "x", name: "l3", rate: "v3", surge: "a3" }],
  span: 0.3,
  tip: "l1",
  rod: "l2",
  values: { l1: 0.1, l2: 0.3, a1: (40 * Math.PI) / 180, w1: 20, e1: 50 }, // worked example VP-2
};
const START = new Map(Object.entries(SLIDER_CRANK.values));
const sum = (...trees: Tree[]): Tree => trees.reduce((one, other) => ["+", one, other]);
const times = (one: Tree, other: Tree): Tree => ["*", one, other];
const polygon = (x: Tree, y: Tree): object => ({
  vectors: [
    { start: "A", end: "B", length: "l1", angle: "a1" },
    { start: "B", end: "C", length: "l2", angle: "a2" },
    { start: "A", end: "C", length: "l3", angle: 0 },
  ],
  equations: [{ axis: "x", zero: x }, { axis: "y", zero: y }],
});
const X: Tree = ["-", sum(times("l1", ["cos", "a1"]), times("l2", ["cos", "a2"])), "l3"];
const Y: Tree = sum(times("l1", ["sin", "a1"]), times("l2", ["sin", "a2"]));

test("a formula is computed, and what is no formula of the language is refused", () => {
  const tree = readTree(["-", ["^", "l", 2], ["degrees", 180]])!;
  assert.equal(compile(tree)(new Map([["l", 3]])), 9 - Math.PI);
  assert.ok(Number.isNaN(compile(tree)(new Map())));
  assert.deepEqual([...namesOf(["*", "pi", ["sin", "l"]])], ["l"]);
  for (const wire of [["constructor", 1], ["eval", "x"], ["+"], {}, null, ["+", 1, { a: 1 }], [["+"], 1]]) assert.equal(readTree(wire), null);
  assert.equal(readTree(Array.from({ length: 300 }).reduce<unknown>((tree) => ["negate", tree], 1)), null);
});

test("coordinates move by constant acceleration and the rod reaches its guide", () => {
  const values = valuesAt(SLIDER_CRANK, START, 0.1);
  assert.ok(Math.abs(values.get("a1")! - (START.get("a1")! + 2 + 0.25)) < 1e-12);
  assert.equal(values.get("w1"), 25);
  assert.ok(Math.abs(trueNodes(SLIDER_CRANK, START)[2]!.x - 0.3696373) < 5e-8); // VP-2
});

test("a turn measured from the frame and one measured from a body differ by that body's turn", () => {
  const turn = (coordinate: string, behind: string, datum: number): Machine["pairs"][number] => ({ kind: "turn", coordinate, behind, datum, turn: 0 });
  const arm = (datum: number): Machine => ({
    ...SLIDER_CRANK, pairs: [turn("a1", "", 0), turn("a2", "l1", datum)], tip: "l2", rod: "",
    drives: [...SLIDER_CRANK.drives, { name: "a2", rate: "w2", surge: "e2" }],
  });
  const values = new Map([["a1", Math.PI / 2], ["a2", Math.PI / 2], ["l1", 1], ["l2", 2]]);
  const ends = [0, 1].map((datum) => trueNodes(arm(datum), values)[2]!);
  assert.ok(Math.hypot(ends[0]!.x - 0, ends[0]!.y - 3) < 1e-12);
  assert.ok(Math.hypot(ends[1]!.x + 2, ends[1]!.y - 1) < 1e-12);
});

test("right relations keep every length and follow the true motion", () => {
  const motion = new Motion(SLIDER_CRANK, START, { ...NOTHING, polygon: readPolygon(polygon(X, Y)) });
  for (const moment of motion.moments) {
    assert.equal(finding(SLIDER_CRANK, moment, valuesAt(SLIDER_CRANK, START, moment.t), true).kind, "agrees");
  }
});

const ARM: Machine = {
  ...SLIDER_CRANK,
  drives: [...SLIDER_CRANK.drives, { name: "a2", rate: "w2", surge: "e2" }],
  pairs: [...SLIDER_CRANK.pairs, { kind: "turn", coordinate: "a2", behind: "l1", datum: 0, turn: 0 }],
  plotted: [{ axis: "x", name: "x_C", rate: "v_x", surge: "a_x" }, { axis: "y", name: "y_C", rate: "v_y", surge: "a_y" }],
  tip: "l2",
  rod: "",
};
const ARM_START = new Map([...START, ["a2", 1], ["w2", -3], ["e2", 2]]);
const byOneVector = (x: Tree, y: Tree): ReturnType<typeof readPolygon> =>
  readPolygon({
    vectors: [
      { start: "A", end: "B", length: "l1", angle: "a1" },
      { start: "B", end: "C", length: "l2", angle: "a2" },
      { start: "A", end: "C", length: "r", angle: "phi" },
    ],
    equations: [{ axis: "x", zero: x }, { axis: "y", zero: y }],
  });
const [ARM_X, ARM_Y] = ["cos", "sin"].map((wave) => sum(times("l1", [wave, "a1"]), times("l2", [wave, "a2"]))) as [Tree, Tree];

test("a vector to the last node may be projected as its coordinates, on either side", () => {
  for (const own of [byOneVector(["-", ARM_X, "x_C"], ["-", ARM_Y, "y_C"]), byOneVector(["-", "x_C", ARM_X], ["-", ARM_Y, "y_C"])]) {
    const motion = new Motion(ARM, ARM_START, { ...NOTHING, polygon: own });
    for (const moment of motion.moments) {
      assert.equal(finding(ARM, moment, valuesAt(ARM, ARM_START, moment.t), true).kind, "agrees");
    }
  }
  const turned: Tree = sum(times("l1", ["cos", "a1"]), times("l2", ["cos", "a2"]));
  const wrong = new Motion(ARM, ARM_START, { ...NOTHING, polygon: byOneVector(["-", ARM_X, "x_C"], ["-", turned, "y_C"]) });
  assert.equal(finding(ARM, wrong.at(0), ARM_START, true).kind, "broken");
});

test("the velocity of the last node is its own, however the vector to it is written", () => {
  const turn = (wave: string, sign: Tree, name: string): Tree =>
    ["-", times(sign, sum(times(times("l1", "w1"), [wave, "a1"]), times(times("l2", "w2"), [wave, "a2"]))), name];
  const velocities = readRates({ equations: [{ axis: "x", zero: turn("sin", -1, "v_x") }, { axis: "y", zero: turn("cos", 1, "v_y") }], said: [] });
  const polar = byOneVector(["-", ARM_X, times("r", ["cos", "phi"])], ["-", ARM_Y, times("r", ["sin", "phi"])]);
  for (const own of [polar, byOneVector(["-", ARM_X, "x_C"], ["-", ARM_Y, "y_C"])]) {
    const motion = new Motion(ARM, ARM_START, { ...NOTHING, polygon: own, velocities });
    for (const axis of ["x", "y"] as const) {
      const [curve, under] = [motion.curve("velocity", axis), motion.under("velocity", axis)];
      assert.ok(Math.max(...curve.map((value, k) => Math.abs(value - under[k]!))) < 1e-3 * Math.max(...curve.map(Math.abs)));
    }
  }
});

test("a cosine in the place of a sine breaks the crank and nothing else", () => {
  const wrong: Tree = sum(times("l1", ["cos", "a1"]), times("l2", ["sin", "a2"]));
  const motion = new Motion(SLIDER_CRANK, START, { ...NOTHING, polygon: readPolygon(polygon(X, wrong)) });
  const found = finding(SLIDER_CRANK, motion.at(0), START, true);
  assert.ok(found.kind === "broken");
  assert.deepEqual(found.links.map(({ at }) => at), [0]);
  assert.ok(Math.abs(found.links[0]!.own - 0.1 * Math.SQRT2 * Math.cos(START.get("a1")!)) < 1e-12);
});

test("relations without a solution, or with too much to find, build no machine", () => {
  const far: Tree = ["-", Y, 5];
  const motion = new Motion(SLIDER_CRANK, START, { ...NOTHING, polygon: readPolygon(polygon(X, far)) });
  assert.equal(finding(SLIDER_CRANK, motion.at(0), START, true).kind, "unsolved");
  const many = new Student(SLIDER_CRANK, readPolygon(polygon(sum(X, "z"), Y))!, START);
  assert.equal(many.begin(START, 0.4), null);
});

test("the student's velocity is the rate of his own closing vector", () => {
  const speedX: Tree = ["-", ["negate", sum(times(times("l1", "w1"), ["sin", "a1"]), times(times("l2", "w2"), ["sin", "a2"]))], "v3"];
  const speedY: Tree = sum(times(times("l1", "w1"), ["cos", "a1"]), times(times("l2", "w2"), ["cos", "a2"]));
  const velocities = readRates({ equations: [{ axis: "x", zero: speedX }, { axis: "", zero: speedY }], said: [] });
  const motion = new Motion(SLIDER_CRANK, START, { ...NOTHING, polygon: readPolygon(polygon(X, Y)), velocities });
  assert.ok(Math.abs(motion.at(0).velocity!.x + 1.621649) < 5e-7); // VP-2
  const [own, under] = [motion.curve("velocity", "x"), motion.under("velocity", "x")];
  assert.ok(Math.max(...own.map((value, k) => Math.abs(value - under[k]!))) < 1e-3 * Math.max(...own));
});

test("a rate belongs to the name it is said of, else to its letter, its axis, its place", () => {
  const student = new Student(SLIDER_CRANK, readPolygon(polygon(X, Y))!, START);
  const of = (names: string[], said: [string, string][] = []): string[] =>
    owners(student, names, new Map(said)).map((at) => student.sought[at]!);
  assert.deepEqual(of(["v3", "w2"]), ["l3", "a2"]);
  assert.deepEqual(of(["l3_d", "a2_d"]), ["l3", "a2"]);
  assert.deepEqual(of(["s", "q"], [["q", "l3_d"]]), ["a2", "l3"]);
});

test("five points differentiate a quartic exactly up to the ends", () => {
  const ts = Array.from({ length: 9 }, (_, k) => k / 4);
  const found = derivative(ts.map((t) => t ** 4 - t), 1 / 4);
  found.forEach((value, k) => assert.ok(Math.abs(value - (4 * ts[k]! ** 3 - 1)) < 1e-12));
});

test("two equations are solved unless they say the same", () => {
  assert.deepEqual(linear([2, 0], [0, 4], [6, 4]), [3, 1]);
  assert.equal(linear([1, 2], [2, 4], [1, 1]), null);
});

test("samples are written and read again with either decimal mark", () => {
  const rows = [{ t: 0, x: 0.5, v: -1.25, a: NaN }, { t: 0.1, x: 0.4, v: -1, a: 2e-7 }];
  for (const comma of [true, false]) assert.deepEqual(read(written(rows, comma)), rows);
  assert.ok(written(rows, true).startsWith("t;x;v;a\r\n0;0,5;-1,25;\r\n"));
  assert.deepEqual(read("\ufeffT [s],x [m]\n0,1\n0.5,2\n"), [{ t: 0, x: 1, v: NaN, a: NaN }, { t: 0.5, x: 2, v: NaN, a: NaN }]);
});

test("a table that cannot be read names its line", () => {
  assert.deepEqual(read('"t";"x_D [mm]";"v, \u043c\u043c/\u0441"\n"0,5";"1500";"2"'), [{ t: 0.5, x: 1.5, v: 0.002, a: NaN }]);
  assert.deepEqual(read("t (ms);y;a_y [cm/s^2]\n500;2;40"), [{ t: 0.5, x: 2, v: NaN, a: 0.4 }]);
  for (const head of ["t;x [in]", "t;x [kN]", "t;alpha"]) assert.deepEqual(read(`${head}\n1;2`), { line: 1 }, head);
  assert.deepEqual(read("x;v\n1;2"), { line: 1 });
  assert.deepEqual(read("t;x\n0;1\nend;2"), { line: 3 });
  assert.deepEqual(read("t;x\n"), { line: 2 });
  assert.deepEqual(read("t;x\n0;1\n1;two"), { line: 3 });
  assert.deepEqual(read("t;x\n0;\n1;nan"), [{ t: 0, x: NaN, v: NaN, a: NaN }, { t: 1, x: NaN, v: NaN, a: NaN }]);
});

test("the largest difference of each column comes with its time, empty columns are left out", () => {
  const rows = [{ t: 0, x: 1, v: 0, a: NaN }, { t: 1, x: 4, v: 1, a: NaN }];
  const found = differences(rows, (t) => ({ t, x: 1 + t, v: t, a: 0 }));
  assert.deepEqual(found, [{ column: "x", most: 2, t: 1, size: 2 }, { column: "v", most: 0, t: 1, size: 1 }]);
});

test("numbers follow the language and sentences take their values", () => {
  assert.equal(new Numbers("pl").shown(-0.5179, 3, "m"), "\u22120,518\u202fm");
  assert.equal(new Numbers("en").shown(-1e-9, 2), "0.00");
  assert.equal(new Numbers("ru").shown(NaN, 2), "\u2013");
  assert.equal(new Numbers("ru").shown(1, 1, "m/s\u00b2"), "1,0\u202f\u043c/\u0441\u00b2");
  assert.equal(filled("{link}: {own}, {other}", { link: "BC", own: "{link}" }), "BC: {link}, {other}");
  assert.deepEqual([0.4, 12, 1e-3].map((scale) => decimals(scale, 3)), [3, 1, 5]);
});

test("a missing point breaks a line, and axes have round steps", () => {
  assert.equal(path([[0, 0], [1, 1], [NaN, 2], [3, 3]]), "M0.0 0.0L1.0 1.0M3.0 3.0");
  assert.deepEqual([0.012, 0.2, 0.6].map(roundStep), [0.02, 0.2, 1]);
});
