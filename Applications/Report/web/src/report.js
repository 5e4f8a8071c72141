import { copyText, element, saveText } from "./page.js";
import { startGroup } from "./table.js";
import { startViewer } from "./viewer.js";

document
  .getElementById("copy-methods")
  ?.addEventListener("click", () => copyText(element("methods-text").innerText, element("copy-state")));
document
  .getElementById("download-report")
  ?.addEventListener("click", () => saveText("report.json", element("report-data").textContent, "application/json"));
startGroup();
startViewer();
