/**
 * From dark violet to yellow with lightness rising evenly; ColourMap.h has the same stops.
 * @type {number[][]} red, green, blue, 0 to 255
 */
const stops = [
  [68, 1, 84],
  [65, 68, 135],
  [42, 120, 142],
  [34, 168, 132],
  [122, 209, 81],
  [253, 231, 37],
];

/**
 * @param {number} part  in [0,1]; what is outside takes the colour of the end
 * @returns {number[]} red, green, blue, 0 to 1
 */
export function colourOf(part) {
  const place = Math.min(Math.max(part, 0), 1) * (stops.length - 1);
  const stop = Math.min(Math.floor(place), stops.length - 2);
  const t = place - stop;
  return [0, 1, 2].map((c) => ((1 - t) * stops[stop][c] + t * stops[stop + 1][c]) / 255);
}

/** @param {number} part @returns {string} for CSS and SVG */
export function cssColour(part) {
  return `rgb(${colourOf(part)
    .map((c) => Math.round(255 * c))
    .join(" ")})`;
}
