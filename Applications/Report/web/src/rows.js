/** What of a group's rows is shown, and in which order. No page is needed for it. */

/** Collates names as people count: case 2 before case 10. */
const collator = new Intl.Collator("en", { numeric: true, sensitivity: "base" });

/**
 * @param {object[]} rows
 * @param {{text: string, status: string, outliersOnly: boolean}} filter
 * @returns {object[]}
 */
export function filteredRows(rows, { text, status, outliersOnly }) {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  return rows.filter((row) => {
    const content = `${row.name} ${row.code} ${row.message}`.toLowerCase();
    return (
      words.every((word) => content.includes(word)) &&
      (status === "" || row.status === status) &&
      (!outliersOnly || row.marks.some((mark) => mark !== 0))
    );
  });
}

/**
 * @param {object[]} rows
 * @param {string|number} key  "name", "status", or the number of a column; unknown numbers go last either way
 * @param {boolean} isDescending
 * @returns {object[]} a new list; rows that are alike keep their order
 */
export function sortedRows(rows, key, isDescending) {
  const sign = isDescending ? -1 : 1;
  if (typeof key === "string") {
    const textOf = (row) => (key === "status" ? `${row.status} ${row.code}` : row[key]);
    return [...rows].sort((a, b) => sign * collator.compare(textOf(a), textOf(b)));
  }
  return [...rows].sort((a, b) => {
    const [x, y] = [a.figures[key], b.figures[key]];
    if (x === null || y === null) {
      return Number(x === null) - Number(y === null);
    }
    return sign * (x - y);
  });
}

/**
 * @param {string} outline  "x,z x,z ..." in mm
 * @returns {number[][]} points; none where the text is something else
 */
export function outlinePoints(outline) {
  const points = outline.split(" ").map((pair) => pair.split(",").map(Number));
  return points.every((point) => point.length === 2 && point.every(Number.isFinite)) && points.length > 2 ? points : [];
}
