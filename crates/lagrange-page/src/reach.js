// Coordinates in which a point of a body is as near as possible to a place, for bodies that are dragged. `placed` returns the point of a
// scene. Steps are those of Gauss and Newton, damped where the point cannot follow: K. Levenberg, Quart. Appl. Math. 2 (1944).
function reaches(model, functions, placed) {
  const trial = startsMotion(model, functions);
  const coordinates = model.positions - model.firstOrder;
  const [LEAST, MOST, NEAR] = [1e-4, 1e4, 0.3];
  const misses = (y, target) => {
    const scene = [];
    functions.drawing(0, y, trial.p, scene);
    const point = placed(scene);
    return [target[0] - point[0], target[1] - point[1]];
  };
  // The coordinates brought onto the constraints, beside other entries as they are; null if that fails.
  const held = (y, fields) => (trial.start(y, fields) ? y.map((value, i) => (i < coordinates ? trial.y[i] : value)) : null);

  function step(y, fields, target) {
    const miss = misses(y, target);
    const slopes = y.slice(0, coordinates).map((value, i) => {
      const h = 1e-6 * (1 + Math.abs(value));
      const moved = misses(y.map((other, k) => (k === i ? value + h : other)), target);
      return miss.map((part, row) => (part - moved[row]) / h);
    });
    const sum = (a, b) => slopes.reduce((total, slope) => total + slope[a] * slope[b], 0);
    const [xx, xy, yy] = [sum(0, 0), sum(0, 1), sum(1, 1)];
    const size = Math.hypot(...miss);
    // The derivatives hold for places that are near.
    const [right, up] = miss.map((part) => part * Math.min(1, NEAR * Math.sqrt(xx + yy) / size));
    for (let damping = LEAST * (xx + yy); damping < MOST * (xx + yy); damping *= 4) {
      const determinant = (xx + damping) * (yy + damping) - xy * xy;
      const [u, v] = [((yy + damping) * right - xy * up) / determinant, ((xx + damping) * up - xy * right) / determinant];
      const next = held(y.map((value, i) => (i < coordinates ? value + slopes[i][0] * u + slopes[i][1] * v : value)), fields);
      if (next && Math.hypot(...misses(next, target)) < size) return next;
    }
    return null;
  }
  return (start, fields, target) => {
    let y = held(start, fields) ?? start;
    for (let k = 0; k < 200 && Math.hypot(...misses(y, target)) > 1e-9; k++) {
      const next = step(y, fields, target);
      if (!next) break;
      y = next;
    }
    return y;
  };
}

