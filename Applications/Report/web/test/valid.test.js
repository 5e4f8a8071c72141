/** The pages are valid HTML, whatever is in them, and load nothing. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { HtmlValidate, StaticConfigLoader } from "html-validate";

const pages = [
  "case.html",
  "zones.html",
  "initial.html",
  "failed.html",
  "cases/summary.html",
  "cases/prostate.html",
  "atlas/atlas.html",
  "study/atlas.html",
  "tied.html",
  "cohort.html",
];
const folder = process.env.MOSERHEX_PAGES;
const validator = new HtmlValidate(
  new StaticConfigLoader({ extends: ["html-validate:recommended", "html-validate:document", "html-validate:a11y"] }),
);

for (const name of pages) {
  test(`${name} is valid`, async () => {
    const report = await validator.validateString(readFileSync(join(folder, name), "utf8"), name);
    const faults = report.results.flatMap((result) =>
      result.messages.map((message) => `${message.line}:${message.column} ${message.ruleId}: ${message.message}`),
    );
    assert.deepEqual(faults, []);
  });

  test(`${name} names no address to load from`, () => {
    const markup = readFileSync(join(folder, name), "utf8").replaceAll(/<(script|style)\b[^>]*>.*?<\/\1>/gs, "");
    assert.equal(markup.match(/\b(src|srcset|data|action|poster)\s*=\s*"(?!data:)/i), null);
    assert.equal(markup.match(/href\s*=\s*"(https?:)?\/\//i), null);
    assert.match(markup, /default-src 'none'/);
  });
}

test("the validator finds faults", async () => {
  const report = await validator.validateString("<!DOCTYPE html><html><body><p><div></p></body></html>");
  assert.equal(report.valid, false);
});
