// Residuals of rounding size, in units of the rounding error.
const NOISE = 4 * Number.EPSILON;

const stepAfter = (x, part, step) => x.map((value, i) => value - part * step[i]);
const image = (rows, vector) => rows.map((row) => row.reduce((sum, entry, j) => sum + entry * vector[j], 0));
const squares = (a, b) => a.reduce((sum, value, i) => sum + value * b[i] * (value * b[i]), 0);

// The inverse of a matrix, which is changed, by elimination with the largest pivot of each column, and the determinant.
function inverted(rows) {
  const inverse = rows.map((row, i) => row.map((_, j) => Number(i === j)));
  let determinant = 1;
  rows.forEach((_, k) => {
    for (let i = k + 1; i < rows.length; i++) {
      if (!(Math.abs(rows[k][k]) < Math.abs(rows[i][k]))) continue;
      [rows[k], rows[i], inverse[k], inverse[i]] = [rows[i], rows[k], inverse[i], inverse[k]];
      determinant = -determinant;
    }
    const pivot = rows[k][k];
    determinant *= pivot;
    rows[k] = rows[k].map((entry) => entry / pivot);
    inverse[k] = inverse[k].map((entry) => entry / pivot);
    rows.forEach((row, i) => {
      const factor = row[k];
      if (i === k) return;
      rows[i] = stepAfter(row, factor, rows[k]);
      inverse[i] = stepAfter(inverse[i], factor, inverse[k]);
    });
  });
  return [inverse, determinant];
}

// Finds the common zero of equations by Newton's method with steps that shrink the residuals, from the start in `y`; NaN if it finds none. The equations compute residuals, their Jacobian in rows, and bounds of their rounding errors.
function coupled(n, iterations, equations, x, y) {
  const evaluated = (point) => {
    const out = [];
    equations(point, x, out);
    return { residuals: out.slice(0, n), jacobian: out.slice(n, n + n * n), rounding: out.slice(n + n * n) };
  };
  const filled = (value) => Array(n).fill(value);
  let [base, step, scales, rounds, weights] = [y.slice(0, n), filled(0), filled(1), filled(0), filled(0)];
  let [part, size, isSmall, isRegular, inverse] = [1, 0, false, true, filled(filled(0))];
  const rowsOf = (jacobian) => filled(0).map((_, i) => jacobian.slice(i * n, (i + 1) * n).map((entry) => entry / scales[i]));
  while (!isSmall) {
    const point = stepAfter(base, part, step);
    const { residuals, jacobian, rounding } = evaluated(point);
    isSmall = residuals.every((residual, i) => Math.abs(residual) <= NOISE * rounding[i]);
    const isFinite = rounding.every((bound) => bound < Infinity);
    const next = image(inverse, residuals.map((residual, i) => residual / scales[i]));
    if (!isFinite || !(isSmall || squares(next, weights) <= size * (1 - part / 2))) {
      isSmall = false;
      isRegular = part >= 1 / 1073741824;
      part *= 0.5;
      if (isRegular) continue;
      break;
    }
    rounds = rounding.map((bound) => Number(0 < bound));
    scales = rounding.map((bound) => (0 < bound ? bound : 1));
    [inverse] = inverted(rowsOf(jacobian));
    step = image(inverse, residuals.map((residual, i) => residual / scales[i]));
    isRegular = inverse.every((row, i) => row.reduce((sum, entry) => sum + Math.abs(entry), 0) + Math.abs(step[i]) < Infinity);
    weights = point.map((value, i) => Math.abs(value) + Math.abs(step[i])).map((unit) => (0 < unit ? 1 / unit : 0));
    [part, size, base] = [1, squares(step, weights), point];
    iterations--;
    isRegular = isRegular && (isSmall || iterations > 0);
    if (!isRegular) break;
  }
  let found = stepAfter(base, 1, step);
  // True if the Jacobian at a point has the same orientation as at the zero, and a similar volume.
  const isOrientedAlike = (point) => {
    const rows = rowsOf(evaluated(point).jacobian);
    const columns = filled(0).map((_, j) => image(inverse, rows.map((row) => row[j])));
    const [, orientation] = inverted(columns);
    return orientation < 65536 && 1 < 65536 * orientation;
  };
  for (let i = 0; isRegular && i < n; i++) {
    const hidden = inverse[i].reduce((sum, entry, j) => sum + Math.abs(entry * rounds[j]), 0);
    if (NOISE * hidden <= 1024 * Number.EPSILON * Math.abs(found[i])) continue;
    const aside = image(inverse, inverse[i].map((entry, j) => (entry < 0 ? -rounds[j] : rounds[j])));
    isRegular = [1, -1].every((side) => isOrientedAlike(stepAfter(found, side * 4 * NOISE, aside)));
  }
  for (let i = 0; i < n; i++) y[i] = isRegular ? found[i] : NaN;
}
