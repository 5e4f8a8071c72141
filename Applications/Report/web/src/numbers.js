/** @param {number|null} value @param {number} [digits] @returns {string} so many significant digits, for people */
export function shortNumber(value, digits = 3) {
  if (value === null || !Number.isFinite(value)) {
    return "";
  }
  if (value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e6)) {
    return value.toExponential(digits - 1);
  }
  return String(Number(value.toPrecision(digits)));
}

/**
 * Round numbers that divide a range into about so many parts.
 * @param {number} low @param {number} high @param {number} parts
 * @returns {number[]}
 */
export function roundMarks(low, high, parts) {
  const span = high - low;
  if (!(span > 0)) {
    return [low];
  }
  const decade = 10 ** Math.floor(Math.log10(span / parts));
  const ratio = span / parts / decade;
  const step = decade * (ratio < 1.5 ? 1 : ratio < 3.5 ? 2 : ratio < 7.5 ? 5 : 10);
  const first = Math.ceil(low / step - 1e-9);
  const length = Math.floor(high / step + 1e-9 * parts - first) + 1;
  return Array.from({ length }, (_, n) => (first + n) * step + 0); // no negative zero
}
