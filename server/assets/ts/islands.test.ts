import assert from "node:assert/strict";
import { test } from "node:test";

import { readDraft } from "./draft.ts";
import { answerName } from "./fields.ts";
import { meaning } from "./formula.ts";
import { allowsAttribute, allowsElement } from "./mathml.ts";
import { neighbour } from "./matrix.ts";
import { readPreview, turnstile } from "./preview.ts";
import { keystroke, nextKey } from "./symbols.ts";

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
  const good = { ok: true, mathml: "<math></math>", text: "1 mm", unit: "mm", note: null };
  assert.deepEqual(readPreview(good), good);
  assert.deepEqual(readPreview({ ok: true, mathml: "" }), { ok: true, mathml: "", text: "", unit: null, note: null });
  const bad = { ok: false, message: "Not read.", position: 7 };
  assert.deepEqual(readPreview(bad), bad);
  for (const reply of [null, "ok", 1, [], {}, { ok: true }, { ok: false }, { error: { code: "x" } }]) {
    assert.equal(readPreview(reply), null);
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

test("a draft is kept for thirty days and a damaged one is dropped", () => {
  const [day, now] = [24 * 3600 * 1000, 1e12];
  const stored = (time: number): string => JSON.stringify({ time, values: { "answer.a": ["1 mm"] } });
  assert.deepEqual(readDraft(stored(now - 29 * day), now)?.values, { "answer.a": ["1 mm"] });
  assert.equal(readDraft(stored(now - 31 * day), now), null);
  for (const text of [null, "", "null", "[]", "{}", '{"time":1,"values":{"a":[1]}}', '{"time":1,"values":{"a":"x"}}']) {
    assert.equal(readDraft(text, 2), null);
  }
});
