import assert from "node:assert/strict";
import { test } from "node:test";

import { joinGrid, joinTable, split } from "./answers.ts";
import { ask } from "./ask.ts";
import { readCopy } from "./draft.ts";
import { answerName } from "./fields.ts";
import { meaning } from "./formula.ts";
import { overall, readProgress } from "./jobs.ts";
import { readKept } from "./kept.ts";
import { allowsAttribute, allowsElement } from "./mathml.ts";
import { neighbour } from "./matrix.ts";
import { merge, same } from "./merge.ts";
import { lettersOf, moved } from "./order.ts";
import { tableOf } from "./paste.ts";
import { senseOf } from "./polygon.ts";
import { read, write } from "./polygon_text.ts";
import { readPreview, turnstile } from "./preview.ts";
import {
  inserted, moveOf, ordinate, placesOf, removed, rowsOf, scaleOf, withOrdinate, withPlace, type Place,
} from "./sketch_model.ts";
import { inWords } from "./spoken.ts";
import { keystroke, nextKey } from "./symbols.ts";
import { inTime, passes, stageAfter } from "./time_left.ts";
import { entriesOf } from "./twin.ts";
import { latexOf } from "./visual.ts";

test("an answer field is told from any other field by its name", () => {
  assert.equal(answerName("answer.omega2"), "omega2");
  assert.equal(answerName("answer."), null);
  assert.equal(answerName("language"), null);
});

test("only presentation elements of MathML pass", () => {
  for (const name of ["math", "mfrac", "mi", "mtd"]) assert.ok(allowsElement(name), name);
  for (const name of ["script", "img", "annotation-xml", "semantics", "maction", "a", "style", "mglyph"]) {
    assert.ok(!allowsElement(name), name);
  }
});

test("no attribute can run, link, style or name anything", () => {
  assert.ok(allowsAttribute("width", ".17em"));
  assert.ok(allowsAttribute("accent", "true"));
  for (const name of ["href", "xlink:href", "onclick", "style", "class", "id", "actiontype", "src"]) {
    assert.ok(!allowsAttribute(name, "x"), name);
  }
  assert.ok(!allowsAttribute("width", "url(//x)"));
  assert.ok(!allowsAttribute("width", "1".repeat(41)));
});

test("a preview is read in its declared shape and anything else is no preview", () => {
  const good = { ok: true, mathml: "<math></math>", text: "1 mm", latex: "1", unit: "mm", note: null, rows: null };
  assert.deepEqual(readPreview(good), good);
  const rows = [[0, 4, null, 1.5], [2, 1, null, null]];
  assert.deepEqual(readPreview({ ...good, relations: { rows } }), { ...good, rows });
  for (const relations of [{ rows: [[0, 1]] }, { rows: [["0", 1, null, null]] }, { formula: "x" }]) {
    assert.deepEqual(readPreview({ ...good, relations }), good);
  }
  const least = { ok: true, mathml: "", text: "", latex: "", unit: null, note: null, rows: null };
  assert.deepEqual(readPreview({ ok: true, mathml: "" }), least);
  const bad = { ok: false, message: "Not read.", position: 7 };
  assert.deepEqual(readPreview(bad), bad);
  for (const reply of [null, "ok", 1, [], {}, { ok: true }, { ok: false }, { error: { code: "x" } }]) {
    assert.equal(readPreview(reply), null);
  }
});

test("a refusal is told in the words of the server, and only a lost connection is none", async () => {
  const here = globalThis as { document?: unknown; fetch: unknown };
  const before = here.fetch;
  here.document = { documentElement: { lang: "en" } };
  const answers = (status: number, body: unknown) => (here.fetch = async () => new Response(JSON.stringify(body), { status }));
  try {
    for (const status of [401, 404, 429]) {
      answers(status, { error: { message: "Not yours any more." } });
      assert.deepEqual(await ask("/preview", "l3", "1"), { ok: false, message: "Not yours any more.", position: null });
    }
    answers(503, { error: { message: "The store rests." } });
    assert.equal(await ask("/preview", "l3", "1"), null);
    here.fetch = () => Promise.reject(new TypeError("no connection"));
    assert.equal(await ask("/preview", "l3", "1"), null);
  } finally {
    here.fetch = before;
    delete here.document;
  }
});

test("the progress of a job is read in its declared shape and anything else is none", () => {
  const item = (number: number, done: number, refused = false) => ({ number, done, total: 30, refused });
  const batches = { state: "running", done: 1, total: 3, items: [] };
  assert.deepEqual(readProgress(JSON.stringify(batches)), batches);
  assert.deepEqual(overall(batches), { done: 1, total: 3 });
  const cards = { ...batches, items: [item(1, 30), item(2, 7), item(3, 0, true)] };
  assert.deepEqual(overall(readProgress(JSON.stringify(cards)) ?? batches), { done: 37, total: 90 });
  const odd = { ...batches, items: [{ ...item(1, 30), refused: "no" }] };
  for (const told of [null, 1, "x", {}, { ...batches, done: "1" }, { ...batches, items: 1 }, { ...batches, items: [{}] }, odd]) {
    assert.equal(readProgress(JSON.stringify(told)), null);
  }
});

test("only the last question may be answered", () => {
  const turns = turnstile();
  const [first, second] = [turns.next(), turns.next()];
  assert.ok(!turns.isLast(first));
  assert.ok(turns.isLast(second));
});

test("a key types its text, and a selection goes inside brackets", () => {
  assert.deepEqual(keystroke("l1", 0, ""), { text: "l1", back: 0 });
  assert.deepEqual(keystroke("l1", 0, "x"), { text: "l1", back: 0 });
  assert.deepEqual(keystroke("sqrt()", 1, ""), { text: "sqrt()", back: 1 });
  assert.deepEqual(keystroke("sqrt()", 1, "a+b"), { text: "sqrt(a+b)", back: 0 });
});

test("arrows go round the symbol row and Home and End to its ends", () => {
  assert.equal(nextKey("ArrowRight", 3, 4), 0);
  assert.equal(nextKey("ArrowLeft", 0, 4), 3);
  assert.equal(nextKey("ArrowDown", 1, 4), 2);
  assert.equal(nextKey("ArrowUp", 1, 4), 0);
  assert.equal(nextKey("Home", 2, 4), 0);
  assert.equal(nextKey("End", 2, 4), 3);
  assert.equal(nextKey("Tab", 2, 4), null);
});

test("Enter adds no line to a formula and checks only with Ctrl", () => {
  const enter = { key: "Enter", ctrlKey: false, metaKey: false, isComposing: false };
  assert.equal(meaning(enter, true), "nothing");
  assert.equal(meaning(enter, false), "default");
  assert.equal(meaning({ ...enter, ctrlKey: true }, true), "check");
  assert.equal(meaning({ ...enter, metaKey: true }, false), "check");
  assert.equal(meaning({ ...enter, isComposing: true }, true), "default");
  assert.equal(meaning({ ...enter, key: "a", ctrlKey: true }, true), "default");
});

test("an arrow leads to the next entry of a matrix and nowhere from other fields", () => {
  assert.equal(neighbour("answer.T.2.3", "ArrowUp"), "answer.T.1.3");
  assert.equal(neighbour("answer.T.2.3", "ArrowRight"), "answer.T.2.4");
  assert.equal(neighbour("answer.omega2", "ArrowUp"), null);
  assert.equal(neighbour("answer.T.2.3", "a"), null);
});

test("a copied table is parted into its cells, and one cell is no table", () => {
  assert.deepEqual(tableOf("0,5\t\t14\r\n1,5\t-1\t2\r\n"), [["0,5", "", "14"], ["1,5", "-1", "2"]]);
  assert.deepEqual(tableOf("\t1\n2\t3"), [["", "1"], ["2", "3"]]);
  assert.deepEqual(tableOf("q1; L1\npi/2 - q2; 0"), [["q1", "L1"], ["pi/2 - q2", "0"]]);
  assert.deepEqual(tableOf(" 1  2\n 3 4\n"), [["1", "2"], ["3", "4"]]);
  for (const text of ["", "12,5", "pi/2 - q2", "12,5\n"]) assert.equal(tableOf(text), null, text);
});

test("the time left is told in two parts and spoken at an hour, ten minutes, one minute and the end", () => {
  const words = { days: "{first} d {second} h", hours: "{first} h {second} min", over: "up" };
  const told = [200000, 86400, 86399, 3600, 61, 59, 0.5, 0, -3].map((seconds) => inTime(seconds, words));
  assert.deepEqual(told, ["2 d 7 h", "1 d 0 h", "23 h 59 min", "1 h 0 min", "0 h 1 min", "0 h 0 min", "0 h 0 min", "up", "up"]);
  const looks = [[3601, 3600], [601, 599.9], [61, 60], [1, -0.1], [3600, 3599], [599, 598], [0, -1]] as const;
  assert.deepEqual(looks.map(([before, after]) => passes(before, after)), [true, true, true, true, false, false, false]);
});

test("a draft is kept for thirty days and a damaged one is dropped", () => {
  const [day, now] = [24 * 3600 * 1000, 1e12];
  const whole = { time: 0, revision: 2, answers: { a: "1 mm" }, synced: { a: "" }, graded: "" };
  const stored = (time: number): string => JSON.stringify({ ...whole, time });
  assert.deepEqual(readKept(stored(now - 29 * day), now)?.answers, { a: "1 mm" });
  assert.equal(readKept(stored(now - 31 * day), now), null);
  for (const change of [{ time: "1" }, { revision: null }, { answers: { a: [1] } }, { synced: null }, { graded: 1 }]) {
    assert.equal(readKept(JSON.stringify({ ...whole, time: now, ...change }), now), null);
  }
  for (const text of [null, "", "null", "[]", "{}", "1", "{"]) assert.equal(readKept(text, 2), null);
});

test("what one side changed is taken over, what both changed is asked", () => {
  const [base, mine, theirs] = [{ a: "1", b: "2", c: "3" }, { a: "1", b: "20", c: "30" }, { a: "10", b: "2", c: "31" }];
  const { answers, conflicts } = merge(base, mine, theirs);
  assert.deepEqual({ answers, conflicts }, { answers: { a: "10", b: "20", c: "30" }, conflicts: ["c"] });
  assert.deepEqual(merge({}, { a: "x" }, { a: "x" }), { answers: { a: "x" }, conflicts: [], base: { a: "x" } });
  assert.ok(same({ a: "" }, {}) && !same({ a: "1" }, {}));
});

test("the server's copy is taken in its declared shape only", () => {
  assert.deepEqual(readCopy({ answers: { a: ["1", "2"], b: "3" }, revision: 4, time: null }), {
    answers: { a: "1\n2", b: "3" },
    revision: 4,
    time: null,
  });
  for (const reply of [null, 1, {}, { answers: null, revision: 1 }, { answers: {}, revision: "1" }]) {
    assert.equal(readCopy(reply), null);
  }
});

test("a grid is one text, and only that text is a grid again", () => {
  const rows = [["1", " c1"], ["", "0"]];
  assert.equal(joinGrid(rows), "[[1; c1], [; 0]]");
  assert.deepEqual(split("[[1; c1], [; 0]]", 2, 2, joinGrid), [["1", "c1"], ["", "0"]]);
  assert.equal(joinGrid([["1"], ["2"]]), "[1; 2]");
  assert.deepEqual(split("[1; 2]", 2, 1, joinGrid), [["1"], ["2"]]);
  assert.equal(joinGrid([["", " "]]), "");
  for (const text of ["[[1,c1],[;0]]", "[[1; 2]]", "x", "[[1; 2], [3; 4], [5; 6]]"]) assert.equal(split(text, 2, 2, joinGrid), null);
});

test("a matrix is taken apart however it is typed, and no other text is", () => {
  assert.deepEqual(entriesOf(" [[a, -b], [atan2(c; d), 1]]", 2, 2), [["a", "-b"], ["atan2(c; d)", "1"]]);
  assert.deepEqual(entriesOf("[[1,5; 2]; [0; 1]]", 2, 2), [["1,5", "2"], ["0", "1"]]);
  assert.deepEqual(entriesOf("[1; 2]", 2, 1), [["1"], ["2"]]);
  assert.deepEqual(entriesOf("[[1], [2]]", 2, 1), [["1"], ["2"]]);
  assert.deepEqual(entriesOf("[1, 2]", 1, 2), [["1", "2"]]);
  for (const text of ["", "x", "[1, 2]", "[[1, 2]]", "[[1, 2], [3]]", "A1*A2"]) assert.equal(entriesOf(text, 2, 2), null);
});

test("a table of a diagram leaves out what is empty", () => {
  const rows = [["0", "0", "4", ""], ["", "", "", ""], ["2", "-1", "", "0,5"], ["3", "", "", ""]];
  const text = "0; 0; 4\n2; -1; ; 0,5\n3; ";
  assert.equal(joinTable(rows), text);
  assert.deepEqual(split(text, 4, 4, joinTable), [rows[0], rows[2], rows[3], rows[1]]);
  assert.equal(split("0 .. 2: 4*x", 4, 4, joinTable), null);
});

test("a diagram is its table: ends, jumps, bends", () => {
  const rows = [["0", "0", "4,5", ""], ["1.5", "-1", "", "2"], ["", "", "", ""], ["3", "0", "", ""]];
  const places = placesOf(rows) ?? [];
  assert.deepEqual(places[0], { x: 0, left: 0, right: 4.5, middle: null });
  assert.deepEqual(rowsOf(places, true)[0], ["0", "0", "4,5", ""]);
  assert.equal(placesOf([["0", "F", "", ""]]), null);
  const [first, second, third] = places as [Place, Place, Place];
  assert.equal(ordinate(first, second, 0.5), 1.75); // straight from 4.5 to -1
  assert.deepEqual([0, 0.5, 1].map((share) => ordinate(second, third, share)), [-1, 2, 0]);
});

test("keys move a handle the way it is seen and + and - by its value", () => {
  assert.deepEqual(moveOf("ArrowUp", false, false), { x: 0, value: 1 });
  assert.deepEqual(moveOf("ArrowUp", true, true), { x: 0, value: -10 });
  assert.deepEqual(moveOf("+", false, true), { x: 0, value: 1 });
  assert.deepEqual(moveOf("ArrowLeft", false, true), { x: -1, value: 0 });
  assert.deepEqual(moveOf("PageDown", false, true), { x: 0, value: 10 });
  assert.equal(moveOf("Tab", false, false), null);
});

test("Insert adds a jump, then a place; Delete takes the bend, the jump, the place", () => {
  const flat = [0, 2].map((x) => ({ x, left: 1, right: null, middle: null }));
  const jump = inserted(flat, 0, "left", 5);
  assert.equal(jump[0]?.right, 1);
  assert.equal(inserted(jump, 0, "left", 5).length, 3);
  assert.equal(inserted(jump, 0, "left", 2).length, 2);
  assert.equal(removed(jump, 0, "right")[0]?.right, null);
  assert.equal(removed(inserted(jump, 0, "right", 5), 1, "left").length, 2);
  assert.equal(removed(flat, 0, "left").length, 2);
});

test("a handle stays on the grid and between its neighbours", () => {
  const places = [0, 1, 2].map((x) => ({ x, left: 3, right: null, middle: null }));
  const scale = scaleOf(places, 2);
  assert.deepEqual([scale.highest, scale.step, scale.xStep], [4, 0.05, 0.02]);
  assert.equal(withOrdinate(places, 1, "left", 3.0312, scale)[1]?.left, 3.05);
  assert.equal(withPlace(places, 1, 1.239, scale)[1]?.x, 1.24);
  assert.equal(withPlace(places, 1, 2, scale), places);
});

const POLYGON = [
  "l1: A > B, length l1, angle alpha1",
  "l2: B > C, length l2, angle alpha2",
  "l3: A > C, length l3, angle 0",
  "closure: l1 + l2 - l3 = 0",
  "x: l1*cos(alpha1) + l2*cos(alpha2) - l3 = 0",
  "y: l1*sin(alpha1) + l2*sin(alpha2) = 0",
  "unknowns: alpha2; l3",
].join("\n");

test("the rows of a polygon write the text that they were read from", () => {
  const sheet = read(POLYGON, ["A", "B", "C"]);
  assert.deepEqual(sheet.vectors.map(({ sign }) => sign), ["+", "+", "-"]);
  assert.deepEqual(sheet.rest, []);
  assert.equal(write(sheet), POLYGON);
});

test("a line that the rows have no place for is kept as typed", () => {
  const sheet = read(`${POLYGON}\nclosure: l1 = l3\nx2: a = 0\nwhat`, ["A", "B", "C"]);
  assert.deepEqual(sheet.rest, ["x2: a = 0", "what", "closure: l1 = l3"]);
  assert.equal(read("l1: A > Q, length 1, angle 0", ["A", "B"]).rest.length, 1);
  assert.equal(write(read("", ["A"])), "");
});

test("a key in a row of the builder leaves it, goes on or takes it away", () => {
  assert.equal(senseOf("Enter", false, true), "next");
  assert.equal(senseOf("Enter", false, false), null); // a button or a list takes it
  assert.equal(senseOf("Enter", true, true), null); // checks the answers
  assert.equal(senseOf("Delete", false, true), null); // a letter
  assert.equal(senseOf("Delete", false, false), "remove");
  assert.deepEqual(["ArrowUp", "ArrowDown"].map((key) => senseOf(key, true, true)), ["up", "down"]);
  assert.equal(senseOf("Escape", false, true), "leave");
  assert.equal(senseOf("Tab", false, true), null);
});

test("items of an order move by one and typed letters are followed", () => {
  assert.deepEqual(moved(["a", "b", "c"], 1, -1), ["b", "a", "c"]);
  assert.deepEqual(moved(["a", "b"], 0, -1), ["a", "b"]);
  assert.deepEqual(lettersOf("B; a, c", ["a", "b", "c"]), ["b", "a", "c"]);
  assert.equal(lettersOf("b; a", ["a", "b", "c"]), null);
});

test("declared names are written in the visual editor as they are printed", () => {
  const names = ["l1", "alpha1", "R_A", "L", "omega", "x_K", "epsilon12", "EI", "h3_d", "Theta1_dd"];
  const printed = ["l_{1}", "\\alpha_{1}", "R_{A}", "L", "\\omega", "x_{K}", "\\epsilon_{12}", "EI", "\\dot{h}_{3}", "\\ddot{\\Theta}_{1}"];
  assert.deepEqual(names.map(latexOf), printed);
});

test("what was taken over is no change of one's own when more of it comes", () => {
  const first = merge({ a: "", b: "" }, { a: "", b: "mine" }, { a: "1", b: "" });
  const then = merge(first.base, first.answers, { a: "12", b: "" });
  assert.deepEqual([then.answers, then.conflicts], [{ a: "12", b: "mine" }, []]);
});

test("an announcement is said phrase by phrase, the longest first, and no part of a word is a phrase", () => {
  const phrases = { "end of": "koniec:", "end of mathfield": "koniec wzoru", over: "przez", sub: "z indeksem" };
  assert.equal(inWords(" 'L' sub 1 over  'L'; End of mathfield", phrases), " 'L' z indeksem 1 przez  'L'; koniec wzoru");
  assert.equal(inWords("subset overline", phrases), "subset overline");
  assert.equal(inWords("over", {}), "over");
});

test("a task goes on from open to past due and to closed", () => {
  const ahead = { late: "late", lateIn: "60", closed: "closed", closedIn: "90" };
  assert.deepEqual([0, 60, 61, 91].map((seconds) => stageAfter(seconds, ahead)), [undefined, undefined, "late", "closed"]);
  assert.equal(stageAfter(1e6, { late: "late", lateIn: "60" }), "late");
  assert.equal(stageAfter(61, { late: "late", lateIn: "60", closed: "closed", closedIn: "60" }), "closed");
});
