/** Exact: what is sorted and filtered, and numbers for people. No browser is needed. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { roundMarks, shortNumber } from "../src/numbers.js";
import { filteredRows, outlinePoints, sortedRows } from "../src/rows.js";

const row = (name, value, more = {}) => ({ name, status: "done", code: "", message: "", figures: [value], marks: [0], ...more });
const names = (rows) => rows.map((of) => of.name);

test("names are sorted as people count", () => {
  const rows = [row("case10", 1), row("case2", 2), row("Case1", 3)];
  assert.deepEqual(names(sortedRows(rows, "name", false)), ["Case1", "case2", "case10"]);
  assert.deepEqual(names(sortedRows(rows, "name", true)), ["case10", "case2", "Case1"]);
});

test("numbers that are not known go last either way, and equal ones keep their order", () => {
  const rows = [row("a", null), row("b", 2), row("c", 1), row("d", 2)];
  assert.deepEqual(names(sortedRows(rows, 0, false)), ["c", "b", "d", "a"]);
  assert.deepEqual(names(sortedRows(rows, 0, true)), ["b", "d", "c", "a"]);
});

test("all words must be found, in any of the texts", () => {
  const rows = [row("a", 1, { message: "two handles" }), row("b", 1, { code: "E_THIN" })];
  const find = (text) => names(filteredRows(rows, { text, status: "", outliersOnly: false }));
  assert.deepEqual(find("HANDLES two"), ["a"]);
  assert.deepEqual(find("e_thin"), ["b"]);
  assert.deepEqual(find("handles e_thin"), []);
  assert.deepEqual(find(" "), ["a", "b"]);
});

test("an outline that is none gives no points", () => {
  assert.deepEqual(outlinePoints("0,0 1,0 1,-1.5"), [[0, 0], [1, 0], [1, -1.5]]);
  for (const text of ["", "0,0 1,1", "0,0 1,0 1,x", "0,0,0 1,0,0 1,1,1", "<svg>"]) {
    assert.deepEqual(outlinePoints(text), []);
  }
});

test("numbers have the digits that people read", () => {
  assert.equal(shortNumber(0.123456), "0.123");
  assert.equal(shortNumber(1e-26), "1.00e-26");
  assert.equal(shortNumber(0), "0");
  assert.equal(shortNumber(null), "");
});

test("marks of an axis are round and within it", () => {
  assert.deepEqual(roundMarks(0, 1, 5), [0, 0.2, 0.4, 0.6000000000000001, 0.8, 1]);
  assert.deepEqual(roundMarks(3, 3, 5), [3]);
});
