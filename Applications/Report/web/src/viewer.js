import { cssColour } from "./colours.js";
import { Mesh } from "./mesh.js";
import { roundMarks, shortNumber } from "./numbers.js";
import { element, pageData } from "./page.js";
import { MeshScene } from "./scene.js";

const axes = ["i", "j", "k"];
const pairs = [...axes.map((axis) => `cut-${axis}`), "shell"];

/** The colours with the numbers at them, as an SVG. @param {object} field */
function legendSvg(field) {
  const [x, width] = [16, 200];
  const place = (value) => x + ((value - field.low) / (field.high - field.low || 1)) * width;
  const steps = 50;
  const bars = Array.from(
    { length: steps },
    (_, s) =>
      `<rect x="${x + (s * width) / steps}" y="0" width="${width / steps + 0.5}" height="14" fill="${cssColour((s + 0.5) / steps)}"/>`,
  );
  const marks = roundMarks(field.low, field.high, field.whole ? 6 : 4)
    .filter((mark) => !field.whole || Number.isInteger(mark))
    .map((mark) => `<path d="M${place(mark)} 14v4"/><text x="${place(mark)}" y="31">${shortNumber(mark)}</text>`);
  return `<svg viewBox="0 0 232 34" role="img" aria-label="Colours from ${shortNumber(field.low)} to ${shortNumber(field.high)}">${bars.join("")}${marks.join("")}</svg>`;
}

const numberAt = (id) => Number(element(id).value);

/** Keeps the lower of two sliders below the upper one, whichever moved. */
function keepOrder(moved) {
  const [, pair, end] = moved.id.match(/^(.*)-(low|high)$/) ?? [];
  if (!pair) {
    return;
  }
  const other = element(`${pair}-${end === "low" ? "high" : "low"}`);
  if (numberAt(`${pair}-low`) > numberAt(`${pair}-high`)) {
    other.value = moved.value;
  }
}

function rangeOfControls() {
  return {
    low: axes.map((axis) => numberAt(`cut-${axis}-low`) - 1),
    high: axes.map((axis) => numberAt(`cut-${axis}-high`) - 1),
    shells: [numberAt("shell-low"), numberAt("shell-high")],
  };
}

/** Half of the mesh: what lies behind its middle, seen from the front. */
function cutInHalf() {
  const [low, high] = [element("cut-j-low"), element("cut-j-high")];
  low.value = String(Math.ceil(Number(high.max) / 2));
  high.value = high.max;
}

/** Builds the 3-D view; where there is no WebGL it says so and the controls are switched off. */
export function startViewer() {
  const data = pageData("mesh-data");
  if (!data) {
    return;
  }
  const controls = element("viewer-controls");
  const message = element("viewer-message");
  const mesh = new Mesh(data);
  let scene;
  try {
    scene = new MeshScene(element("viewer-canvas"), element("viewer-letters"), mesh);
  } catch {
    message.textContent = "This browser has no WebGL, so there is no 3-D view. The slices and histograms do not need it.";
    for (const group of controls.querySelectorAll("fieldset")) {
      group.disabled = true;
    }
    return;
  }
  message.hidden = true;
  const update = () => {
    for (const pair of pairs) {
      for (const end of ["low", "high"]) {
        element(`${pair}-${end}-value`).textContent = element(`${pair}-${end}`).value;
      }
    }
    const field = mesh.field(element("colour-by").value);
    const seen = mesh.seenCells(rangeOfControls());
    const count = seen.reduce((sum, isSeen) => sum + isSeen, 0);
    element("viewer-count").textContent = `${count} of ${mesh.cells} cells`;
    element("colour-legend").innerHTML = legendSvg(field);
    scene.edges.visible = element("show-edges").checked;
    scene.show(seen, field);
  };
  controls.addEventListener("input", (event) => {
    keepOrder(event.target);
    update();
  });
  controls.addEventListener("click", (event) => {
    const view = event.target.dataset?.view;
    if (view) {
      scene.lookFrom(view);
    }
  });
  element("whole-view").addEventListener("click", () => {
    for (const slider of controls.querySelectorAll("input[type=range]")) {
      slider.value = slider.defaultValue;
    }
    update();
  });
  element("half-view").addEventListener("click", () => {
    cutInHalf();
    scene.lookFrom("A");
    update();
  });
  scene.resize();
  update();
}
