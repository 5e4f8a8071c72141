/**
 * Makes the pages that are tested, by the program itself.
 *
 *     node make_pages.js MOSERHEX FOLDER
 */
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [program, folder] = process.argv.slice(2);
const path = (name) => join(folder, name);
const run = (...words) => execFileSync(program, words, { stdio: ["ignore", "ignore", "inherit"] });
/** For runs that are to fail. */
const runToFail = (...words) => {
  if (spawnSync(program, words, { stdio: "ignore" }).status === 0) {
    throw new Error(`${words.join(" ")} did not fail`);
  }
};

/** A cohort as collect finds it: reports that differ a little, some of failures, one far from all others. */
function makeCohort(report, size) {
  mkdirSync(path("cohort"));
  const mesh = readFileSync(path("cases/prostate.vtu"));
  for (let n = 0; n < size; ++n) {
    const name = `sub-${String(n).padStart(4, "0")}`;
    const of = structuredClone(report);
    const wave = Math.sin(12.9898 * n);
    of.input.file = `${name}.nii.gz`;
    of.mesh.file = `${name}.vtu`;
    of.mesh.volume_mm3 = (n === 700 ? 190000 : 50000) * (1 + 0.1 * wave);
    of.stages.at(-1).sj_min = 0.2 + 0.03 * Math.cos(n);
    of.conditioning.dice = 0.99 + 0.004 * wave;
    if (n % 50 === 49) {
      of.status = "failed";
      of.error = { code: "E_TOPOLOGY", message: `${name}.nii.gz: not one solid` };
      delete of.mesh.volume_mm3;
    } else {
      writeFileSync(path(`cohort/${name}.vtu`), mesh.subarray(0, 64));
    }
    writeFileSync(path(`cohort/${name}.json`), JSON.stringify(of));
  }
}

/** A table of six subjects in two groups, each with an image: the zones on whose grid its label is, or the label itself. */
function makeStudy() {
  mkdirSync(path("study"));
  const rows = ["subject,mesh,mri,arm"];
  for (const [frame, arm] of [["anatomical", "control"], ["ridge", "treated"]]) {
    for (const [name, image] of [["prostate", "prostate_zones"], ["prostate_zones", "prostate_zones"], ["prostate_followup", "prostate_followup"]]) {
      const mesh = `${name}-${frame}.vtu`;
      run("mesh", path(`sample/${name}.nrrd`), path(`study/${mesh}`), "--shells=4", `--frame=${frame}`, "--quiet");
      rows.push(`${name}-${frame},${mesh},../sample/${image}.nrrd,${arm}`);
    }
  }
  writeFileSync(path("study/study.csv"), `${rows.join("\n")}\n`);
  run("atlas", path("study/study.csv"), "--output", path("study"), "--images=mri", "--group=arm", "--permutations=20", "--samples=20", "--quiet");
}

rmSync(folder, { recursive: true, force: true });
mkdirSync(path("cases"), { recursive: true });
run("sample", path("sample"), "--quiet");
run("mesh", path("sample/prostate.nrrd"), path("case.vtu"), "--quiet", "--report", path("case.html"), "--report", path("case.json"));
run("mesh", path("sample/prostate_zones.nrrd"), path("zones.vtu"), "--quiet", "--padding=1", "--shells=6", "--report", path("zones.html"));
run("mesh", path("sample/prostate.nrrd"), path("initial.vtu"), "--quiet", "--stage=initial", "--shells=4", "--report", path("initial.html"));
run("mesh", path("sample/prostate_followup.nrrd"), path("tied.vtu"), "--quiet", "--template", path("case.vtu"), "--align=affine", "--report", path("tied.html"));
const hostile = path("<b> & \"c\" 'd'.nrrd");
writeFileSync(hostile, "NRRD0004\n");
runToFail("mesh", hostile, path("failed.vtu"), "--quiet", "--report", path("failed.html"));
const sample = ["prostate", "prostate_zones", "prostate_followup"].map((name) => path(`sample/${name}.nrrd`));
run("batch", ...sample, "--output", path("cases"), "--shells=4", "--case-pages", "--quiet");
run("atlas", path("cases"), "--output", path("atlas"), "--samples=20", "--quiet");
makeStudy();
makeCohort(JSON.parse(readFileSync(path("case.json"), "utf8")), 1500);
runToFail("collect", path("cohort"), "--html", path("cohort.html"), "--quiet"); // some of its cases have failed
