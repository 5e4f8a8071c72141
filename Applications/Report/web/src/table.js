import { shortNumber } from "./numbers.js";
import { element, pageData } from "./page.js";
import { filteredRows, outlinePoints, sortedRows } from "./rows.js";

const svgSpace = "http://www.w3.org/2000/svg";
const statusSigns = { done: "\u2713", failed: "\u2715", missing: "?" };
const marks = {
  1: { sign: " \u25b2", words: " far above the others" },
  "-1": { sign: " \u25bc", words: " far below the others" },
};

function make(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

const hiddenText = (text) => make("span", { class: "visually-hidden" }, text);
const sign = (text) => make("span", { "aria-hidden": "true" }, text);

/** A long name breaks behind a mark that separates its words. */
function breakable(name) {
  return name.split(/(?<=[_/\\])/).flatMap((part, number) => (number === 0 ? [part] : [make("wbr"), part]));
}

/** The largest side of an outline of the group, which all pictures share so that sizes compare [mm]. */
function largestSide(rows) {
  let largest = 1;
  for (const row of rows) {
    for (const axis of [0, 1]) {
      const values = outlinePoints(row.outline).map((point) => point[axis]);
      largest = Math.max(largest, values.length ? Math.max(...values) - Math.min(...values) : 0);
    }
  }
  return largest;
}

function thumbnail(row, side) {
  const points = outlinePoints(row.outline);
  if (points.length === 0) {
    return "";
  }
  const middle = [0, 1].map((axis) => {
    const values = points.map((point) => point[axis]);
    return (Math.max(...values) + Math.min(...values)) / 2;
  });
  const svg = document.createElementNS(svgSpace, "svg");
  svg.setAttribute("viewBox", "-26 -26 52 52");
  svg.setAttribute("class", "thumbnail");
  svg.setAttribute("aria-hidden", "true");
  const polygon = document.createElementNS(svgSpace, "polygon");
  const place = ([x, z]) => `${(((x - middle[0]) * 48) / side).toFixed(1)},${(((middle[1] - z) * 48) / side).toFixed(1)}`;
  polygon.setAttribute("points", points.map(place).join(" "));
  svg.append(polygon);
  return svg;
}

function statusCell(row) {
  const cell = make("td", { class: `status ${row.status}` }, sign(`${statusSigns[row.status] ?? ""} `), row.status);
  if (row.code) {
    cell.append(make("br"), make("code", {}, row.code));
  }
  if (row.message) {
    cell.append(make("details", {}, make("summary", {}, "why"), row.message));
  }
  return cell;
}

function figureCell(value, mark) {
  const cell = make("td", { class: "figure" }, shortNumber(value, 4));
  if (mark !== 0) {
    cell.classList.add("outlier");
    cell.append(sign(marks[mark].sign), hiddenText(marks[mark].words));
  }
  return cell;
}

class GroupTable {
  constructor(data) {
    this.data = data;
    this.side = largestSide(data.rows);
    this.sort = { key: null, isDescending: false };
    this.page = 0;
    this.body = make("tbody");
    element("group-scroll").replaceChildren(
      make("table", {}, make("caption", {}, "A row for each; outlines from the front, all to one scale"), this.head(), this.body),
    );
    for (const id of ["group-search", "group-status", "group-outliers", "group-size"]) {
      element(id).addEventListener("input", () => this.show(0));
    }
    element("group-previous").addEventListener("click", () => this.show(this.page - 1));
    element("group-next").addEventListener("click", () => this.show(this.page + 1));
    this.show(0);
  }

  head() {
    const row = make("tr");
    if (this.data.rows.some((of) => of.outline)) {
      row.append(make("th", { scope: "col" }, "Outline"));
    }
    const columns = [
      ["name", this.data.caseName],
      ["status", "status"],
      ...this.data.columns.map((column, number) => [number, column.name]),
    ];
    this.headings = columns.map(([key, name]) => {
      const button = make("button", { type: "button", class: "sort" }, name, make("span", { class: "arrow", "aria-hidden": "true" }));
      const heading = make("th", { scope: "col" }, button);
      button.addEventListener("click", () => this.sortBy(key));
      row.append(heading);
      return { key, heading };
    });
    this.hasOutlines = row.firstChild !== this.headings[0].heading;
    return make("thead", {}, row);
  }

  sortBy(key) {
    const again = this.sort.key === key;
    this.sort = { key, isDescending: again && !this.sort.isDescending };
    for (const { key: of, heading } of this.headings) {
      heading.removeAttribute("aria-sort");
      heading.querySelector(".arrow").textContent = "";
      if (of === key) {
        heading.setAttribute("aria-sort", this.sort.isDescending ? "descending" : "ascending");
        heading.querySelector(".arrow").textContent = this.sort.isDescending ? " \u2193" : " \u2191";
      }
    }
    this.show(0);
  }

  chosenRows() {
    const rows = filteredRows(this.data.rows, {
      text: element("group-search").value,
      status: element("group-status").value,
      outliersOnly: element("group-outliers").checked,
    });
    return this.sort.key === null ? rows : sortedRows(rows, this.sort.key, this.sort.isDescending);
  }

  rowElement(row) {
    const name = breakable(row.name);
    const heading = row.page ? [make("a", { href: row.page }, ...name)] : name;
    const made = make("tr", {}, make("th", { scope: "row" }, ...heading), statusCell(row));
    if (this.hasOutlines) {
      made.prepend(make("td", {}, thumbnail(row, this.side)));
    }
    made.append(...row.figures.map((value, number) => figureCell(value, row.marks[number])));
    return made;
  }

  /** @param {number} page  from 0 */
  show(page) {
    const rows = this.chosenRows();
    const size = Number(element("group-size").value) || Math.max(rows.length, 1);
    const pages = Math.max(Math.ceil(rows.length / size), 1);
    this.page = Math.min(Math.max(page, 0), pages - 1);
    const shown = rows.slice(this.page * size, (this.page + 1) * size);
    this.body.replaceChildren(...shown.map((row) => this.rowElement(row)));
    element("group-count").textContent = `${rows.length} of ${this.data.rows.length} ${this.data.caseName}s`;
    element("group-page").textContent = `page ${this.page + 1} of ${pages}`;
    element("group-previous").disabled = this.page === 0;
    element("group-next").disabled = this.page === pages - 1;
  }
}

/** Fills the table of a group, where the page is one of a group. */
export function startGroup() {
  const data = pageData("group-data");
  if (data) {
    new GroupTable(data);
  }
}
