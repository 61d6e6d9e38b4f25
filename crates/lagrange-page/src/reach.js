// Coordinates in which a point of a body is as near as possible to a place, for bodies that are dragged. `placed` returns the point of a
// scene. Steps are those of Gauss and Newton, damped where the point cannot follow: K. Levenberg, Quart. Appl. Math. 2 (1944).
function reaches(model, functions, placed) {
  let trial = null;
  const coordinates = model.positions - model.firstOrder;
  const [LEAST, MOST, NEAR, NOTHING] = [1e-4, 1e4, 0.3, 1e-9];
  const point = (y, p) => {
    const scene = [];
    functions.drawing(0, normalised([...y], model.quaternions), p, scene);
    return placed(scene);
  };
  const minus = (a, b) => a.map((value, k) => value - b[k]);
  // The coordinates brought onto the constraints, beside other entries as they are; null if that fails.
  const held = (y, fields) => (trial.start(y, fields) ? y.map((value, i) => (i < coordinates ? trial.y[i] : value)) : null);
  // The derivative of the point by each coordinate, where `onto` brings them onto the constraints.
  const slopesAt = (y, p, onto = (moved) => moved) => y.slice(0, coordinates).map((value, i) => {
    const h = 1e-6 * (1 + Math.abs(value));
    const moved = onto(y.map((other, k) => (k === i ? value + h : other)));
    return minus(point(moved, p), point(y, p)).map((part) => part / h);
  });

  // The next coordinates and how far the point is from its place there; null if none are nearer.
  function step(y, fields, target) {
    const miss = minus(target, point(y, trial.p));
    const size = Math.hypot(...miss);
    if (size < NOTHING) return null;
    const slopes = slopesAt(y, trial.p, (moved) => (model.constraints && held(moved, fields)) || moved);
    const products = miss.map((_, a) => miss.map((_, b) => slopes.reduce((total, slope) => total + slope[a] * slope[b], 0)));
    const all = products.reduce((sum, row, k) => sum + row[k], 0);
    // The derivatives hold for places that are near.
    const wanted = miss.map((part) => part * Math.min(1, NEAR * Math.sqrt(all) / size));
    for (let damping = LEAST * all; damping < MOST * all; damping *= 4) {
      const pull = solved(products.map((row, a) => [...row.map((value, b) => (a === b ? value + damping : value)), wanted[a]]));
      const next = held(y.map((value, i) => value + (slopes[i]?.reduce((sum, slope, k) => sum + slope * pull[k], 0) ?? 0)), fields);
      const far = next && Math.hypot(...minus(target, point(next, trial.p)));
      if (next && far < size) return { next, far, isEnough: far < NOTHING || size - far < 1e-13 * size };
    }
    return null;
  }
  // Solves a positive definite system, whose last column is the right side, by elimination.
  function solved(rows) {
    rows.forEach((row, k) => rows.slice(k + 1).forEach((below) => {
      const part = below[k] / row[k];
      row.forEach((value, column) => { below[column] -= part * value; });
    }));
    return rows.reduceRight((found, row, k) => {
      found[k] = (row[rows.length] - row.reduce((sum, value, column) => (column > k && column < rows.length ? sum + value * found[column] : sum), 0)) / row[k];
      return found;
    }, []);
  }
  return {
    // True if any coordinate moves the point.
    isFree: (y, p) => slopesAt(y, p).flat().some(Boolean),
    // Makes no further step after the deadline.
    to(start, fields, target, deadline = Infinity) {
      trial ??= startsMotion(model, functions);
      let y = held(start, fields) ?? start;
      for (let k = 0; k < 200; k++) {
        const found = step(y, fields, target);
        y = found?.next ?? y;
        if ((found?.isEnough ?? true) || performance.now() > deadline) break;
      }
      return y;
    },
  };
}
