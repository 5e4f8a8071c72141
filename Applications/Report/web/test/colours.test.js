/** Exact: the colours of the pages' scripts are those of the program's pictures. No browser is needed. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { cssColour, stops } from "../src/colours.js";

test("the stops are those of the program", () => {
  const program = readFileSync(process.env.MOSERHEX_COLOUR_SCALE, "utf8");
  const list = program.slice(program.indexOf("sequentialScale()")).match(/0x[0-9a-f]{6}/g);
  const hexadecimal = (stop) => `0x${stop.map((level) => level.toString(16).padStart(2, "0")).join("")}`;
  assert.deepEqual(stops.map(hexadecimal), list);
});

test("the ends of the scale are its first and last stop", () => {
  assert.equal(cssColour(-1), "rgb(68 1 84)");
  assert.equal(cssColour(2), "rgb(253 231 37)");
});
