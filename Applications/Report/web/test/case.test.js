/** The page of a case in a browser. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { coloursOfCanvas, openPage, pagesFolder, pictureOfCanvas, startBrowser, takePicture } from "./browser.js";

let browser;
before(async () => {
  browser = await startBrowser();
});
after(() => browser.close());

const slide = (page, id, value) =>
  page.locator(`#${id}`).evaluate((input, to) => {
    input.value = to;
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, String(value));

test("a case opens without a request or an error and says whether it can be trusted", async () => {
  const { page, faults } = await openPage(browser, "case.html");
  assert.match(await page.locator("#trust-heading").innerText(), /^\u2713\s*Trust$/);
  assert.ok((await page.locator(".reasons li").count()) >= 4);
  assert.equal(await page.locator("svg.slice").count(), 9);
  assert.equal(await page.locator("svg.histogram").count(), 4);
  assert.ok((await coloursOfCanvas(page)) > 200);
  await takePicture(page, "case");
  assert.deepEqual(faults, []);
});

test("the 3-D view is cut, coloured and turned by its controls", async () => {
  const { page, faults } = await openPage(browser, "case.html");
  assert.equal(await page.locator("#viewer-count").innerText(), "6859 of 6859 cells");
  const whole = await pictureOfCanvas(page);
  await slide(page, "cut-i-high", 9);
  assert.equal(await page.locator("#viewer-count").innerText(), `${9 * 19 * 19} of 6859 cells`);
  const cut = await pictureOfCanvas(page);
  assert.notEqual(cut, whole);
  await slide(page, "shell-high", 1);
  assert.equal(await page.locator("#viewer-count").innerText(), "0 of 6859 cells");
  await slide(page, "cut-i-high", 19);
  assert.equal(await page.locator("#viewer-count").innerText(), "1 of 6859 cells");
  await page.getByRole("button", { name: "Whole mesh" }).click();
  assert.equal(await page.locator("#viewer-count").innerText(), "6859 of 6859 cells");
  await page.getByLabel("Colour cells by").selectOption("shell");
  assert.notEqual(await pictureOfCanvas(page), whole);
  await page.getByRole("button", { name: "Half of it" }).click();
  await page.locator("#view").scrollIntoViewIfNeeded();
  await takePicture(page.locator("#view"), "view-half", undefined);
  assert.deepEqual(faults, []);
});

test("the lower slider never passes the upper one", async () => {
  const { page } = await openPage(browser, "case.html");
  await slide(page, "cut-k-high", 5);
  await slide(page, "cut-k-low", 8);
  assert.equal(await page.locator("#cut-k-high").inputValue(), "8");
  assert.equal(await page.locator("#viewer-count").innerText(), "361 of 6859 cells");
});

test("the 3-D view is turned and zoomed by keys", async () => {
  const { page } = await openPage(browser, "case.html");
  await page.locator("#viewer-canvas").focus();
  const before = await pictureOfCanvas(page);
  await page.keyboard.press("ArrowLeft");
  const turned = await pictureOfCanvas(page);
  assert.notEqual(turned, before);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("+");
  assert.notEqual(await pictureOfCanvas(page), before);
});

test("every control has a label and can be reached by the Tab key", async () => {
  const { page } = await openPage(browser, "case.html");
  const controls = page.locator("#viewer-controls :is(input, select, button)");
  const count = await controls.count();
  const reached = new Set();
  await page.locator("#viewer-canvas").focus();
  for (let n = 0; n < count; ++n) {
    await page.keyboard.press("Tab");
    reached.add(await page.evaluate(() => [...document.querySelectorAll("#viewer-controls *")].indexOf(document.activeElement)));
  }
  assert.ok(!reached.has(-1));
  assert.equal(reached.size, count);
  for (const control of await controls.all()) {
    const name = await control.evaluate((of) => (of.labels?.length ? of.labels[0].innerText : of.innerText).trim());
    assert.notEqual(name, "");
  }
});

test("the JSON that can be downloaded is the report", async () => {
  const { page } = await openPage(browser, "case.html");
  const waiting = page.waitForEvent("download");
  await page.getByRole("button", { name: "Download the report as JSON" }).click();
  const content = readFileSync(await (await waiting).path(), "utf8");
  assert.deepEqual(JSON.parse(content), JSON.parse(readFileSync(join(pagesFolder, "case.json"), "utf8")));
});

test("several labels with padding are shown, too", async () => {
  const { page, faults } = await openPage(browser, "zones.html");
  assert.equal(await page.locator("#viewer-count").innerText(), "2057 of 2057 cells"); // 11^3 + 6 * 11^2
  await page.getByLabel("Colour cells by").selectOption("label");
  await slide(page, "shell-high", 6);
  assert.equal(await page.locator("#viewer-count").innerText(), "1331 of 2057 cells");
  await takePicture(page, "zones");
  assert.deepEqual(faults, []);
});

test("a mesh tied to a template says how, and how far apart the two are", async () => {
  const { page, faults } = await openPage(browser, "tied.html");
  assert.match(await page.locator("#template").innerText(), /case\.vtu.*affine map/s);
  const [before, after] = await page.locator("#template tbody td").allInnerTexts();
  assert.ok(parseFloat(after) < parseFloat(before));
  assert.deepEqual(faults, []);
});

test("a mesh that is not exact, and a failure with a hostile name, say so", async () => {
  const initial = await openPage(browser, "initial.html");
  assert.match(await initial.page.locator("#trust-heading").innerText(), /Look at it|Do not use/);
  const failed = await openPage(browser, "failed.html");
  assert.match(await failed.page.locator("#trust-heading").innerText(), /Do not use/);
  assert.match(await failed.page.locator("h1").innerText(), /^<b> & "c" 'd'\.nrrd$/);
  await takePicture(failed.page, "failed");
  assert.deepEqual([...initial.faults, ...failed.faults], []);
});

test("without WebGL the page says so, and the rest is there", async () => {
  const without = await startBrowser(false);
  try {
    const { page } = await openPage(without, "case.html");
    assert.match(await page.locator("#viewer-message").innerText(), /no WebGL/);
    assert.ok(await page.getByLabel("Colour cells by").isDisabled());
    assert.equal(await page.locator("svg.slice").count(), 9);
  } finally {
    await without.close();
  }
});

test("the page prints, without its controls", async () => {
  const { page } = await openPage(browser, "case.html");
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator("#viewer-controls").isHidden());
  assert.ok(await page.locator("svg.slice").first().isVisible());
});

test("a narrow screen is not wider than itself", async () => {
  const { page } = await openPage(browser, "case.html", { width: 390, height: 800 });
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await takePicture(page, "case-narrow");
});
