/**
 * Bundles the scripts and the style of the pages into a C++ source.
 *
 *     node build.js OUTPUT.cxx      in a folder with src/ and node_modules/
 */
import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const common = { bundle: true, minify: true, write: false, legalComments: "none", logLevel: "warning" };

/** @param {string} entry @returns {Promise<string>} one script that can stand in a <script> element */
async function bundledScript(entry) {
  const result = await build({ ...common, entryPoints: [entry], format: "iife", target: "es2020", charset: "ascii" });
  const text = result.outputFiles[0].text;
  if (/<\/script|<!--/i.test(text)) {
    throw new Error(`${entry}: what ends a script element stands in its bundle`);
  }
  return text;
}

async function bundledStyle(entry) {
  const result = await build({ ...common, entryPoints: [entry], charset: "ascii" });
  return result.outputFiles[0].text;
}

/** @param {string} text @returns {string} a C++ raw string literal */
function literal(text) {
  const delimiter = "moserhex";
  if (text.includes(`)${delimiter}"`)) {
    throw new Error("the delimiter of the raw string stands in the text");
  }
  return `R"${delimiter}(${text})${delimiter}"`;
}

const three = JSON.parse(readFileSync("node_modules/three/package.json", "utf8"));
const parts = [
  await bundledStyle("src/style.css"),
  await bundledScript("src/report.js"),
  await bundledScript("src/group.js"),
  three.version,
  readFileSync("node_modules/three/LICENSE", "utf8").trim(),
];
writeFileSync(
  process.argv[2],
  `#include "ReportAssets.h"

namespace moserhex::app
{

const ReportAssets *
reportAssets()
{
  static const ReportAssets assets{ ${parts.map(literal).join(",\n")} };
  return &assets;
}

} // namespace moserhex::app
`,
);
