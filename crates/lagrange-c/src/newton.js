// True if two slopes have the same sign and differ by no more than a factor.
const isSimilar = (a, b) => a < 0 === b < 0 && Math.abs(a) < 65536 * Math.abs(b) && Math.abs(b) < 65536 * Math.abs(a);

// The zero that Newton's method finds from a start; NaN if it finds none. The equation computes the residual, its slope and a bound of its rounding error.
function newton(start, iterations, equation, x) {
  const root = Math.sqrt(Number.EPSILON), noisePart = root * Math.sqrt(root);
  const at = (y) => {
    const out = [];
    equation(y, x, out);
    return out;
  };
  let [y, lastLength, lastSlope] = [start, 0, 0];
  for (; iterations > 0; iterations--) {
    const [residual, slope, rounding] = at(y);
    const next = y - residual / slope, length = Math.abs(residual / slope), steepness = Math.abs(slope);
    const bound = 4 * Number.EPSILON * rounding, hidden = bound / steepness;
    const isSmall = Math.abs(residual) <= bound && bound < Infinity && steepness < Infinity;
    const isNoise = length < noisePart * Math.abs(next) && 0 < lastLength && lastLength <= length;
    const agrees = Math.abs(slope - lastSlope) <= 0.25 * steepness, spans = 4 * hidden <= lastLength;
    if (isSmall && (bound <= 0 || (spans && agrees))) return next;
    if (isSmall || isNoise) {
      const noise = isSmall ? 0 : length < lastLength ? lastLength : length;
      const width = 32 * (hidden < noise ? noise : hidden);
      const above = at(next + width), below = at(next - width);
      const areOpposite = (above[0] < 0 && 0 < below[0]) || (below[0] < 0 && 0 < above[0]);
      const isCentral = isSmall || 4 * Math.abs(above[0] + below[0]) <= Math.abs(above[0] - below[0]);
      if (areOpposite && isCentral && isSimilar(below[1], above[1]) && isSimilar(below[1], slope)) return next;
    }
    if (next !== next) break;
    [y, lastLength, lastSlope] = [next, length, slope];
  }
  return NaN;
}
