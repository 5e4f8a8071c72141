/**
 * Viridis, even steps to the eye; ../../src/ColourScale.cxx has the same stops, which a test compares.
 * @type {number[][]} red, green, blue, 0 to 255
 */
export const stops = [
  0x440154, 0x482475, 0x414487, 0x355f8d, 0x2a788e, 0x21918c, 0x22a884, 0x44bf70, 0x7ad151, 0xbddf26, 0xfde725,
].map((rgb) => [rgb >> 16, (rgb >> 8) & 255, rgb & 255]);

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
