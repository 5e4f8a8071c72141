/**
 * Runs test files in this folder by Node's test runner; ends with 77, saying so, where they need a browser and there is
 * none.
 *
 *     node run.js FILE...
 */
import { spawnSync } from "node:child_process";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const folder = dirname(fileURLToPath(import.meta.url));
const files = process.argv.slice(2);
if (files.some((file) => ["case.test.js", "group.test.js"].includes(file))) {
  const { chromiumPath, hasChromium } = await import("./browser.js");
  if (!hasChromium()) {
    console.log(`skipped: no browser at ${chromiumPath}; install Debian's chromium, or set MOSERHEX_CHROMIUM`);
    process.exit(77);
  }
}
const { status } = spawnSync(process.execPath, ["--test", ...files.map((file) => join(folder, file))], { stdio: "inherit" });
process.exit(status ?? 1);
