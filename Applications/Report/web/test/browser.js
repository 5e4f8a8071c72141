/** A browser for tests: Debian's Chromium without a screen, in which nothing but the file itself can be loaded. */
import { existsSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

export const chromiumPath = process.env.MOSERHEX_CHROMIUM || "/usr/bin/chromium";
export const hasChromium = () => existsSync(chromiumPath);

/** Where the pages to test are, and where pictures of them go. */
export const pagesFolder = process.env.MOSERHEX_PAGES;
const pictureFolder = process.env.MOSERHEX_PICTURES;

const switches = [
  "--no-sandbox",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--enable-unsafe-swiftshader",
];

/** @param {boolean} withWebGl */
export function startBrowser(withWebGl = true) {
  return chromium.launch({
    executablePath: chromiumPath,
    args: withWebGl ? switches : [...switches, "--disable-3d-apis"],
  });
}

/**
 * Opens a page of the folder.
 * @returns {Promise<{page: import("playwright-core").Page, faults: string[]}>} faults: what it asked the network for,
 *          and its errors; filled while the page lives
 */
export async function openPage(browser, file, size = { width: 1360, height: 1000 }) {
  const context = await browser.newContext({ viewport: size, acceptDownloads: true });
  const page = await context.newPage();
  const faults = [];
  const url = pathToFileURL(join(pagesFolder, file)).href;
  await page.route("**/*", (route) => {
    const asked = route.request().url();
    if (asked === url || asked.startsWith("data:") || asked.startsWith("blob:")) {
      return route.continue();
    }
    faults.push(`request: ${asked}`);
    return route.abort();
  });
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !/GPU stall due to ReadPixels/.test(message.text())) {
      faults.push(`console: ${message.text()}`);
    }
  });
  page.on("pageerror", (error) => faults.push(`error: ${error.message}`));
  await page.goto(url);
  return { page, faults };
}

/** Keeps a picture of a page for people. */
export async function takePicture(page, name, fullPage = true) {
  mkdirSync(pictureFolder, { recursive: true });
  await page.screenshot({ path: join(pictureFolder, `${name}.png`), fullPage });
}

/** @returns {Promise<number>} how many different colours the 3-D view has, its ground among them */
export function coloursOfCanvas(page) {
  return page.evaluate(() => {
    const canvas = document.getElementById("viewer-canvas");
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    const colours = new Set();
    for (let at = 0; at < data.length; at += 4) {
      colours.add((data[at] << 16) | (data[at + 1] << 8) | data[at + 2]);
    }
    return colours.size;
  });
}

/** @returns {Promise<string>} the picture of the 3-D view, to compare */
export function pictureOfCanvas(page) {
  return page.evaluate(() => document.getElementById("viewer-canvas").toDataURL());
}
