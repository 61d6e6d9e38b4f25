// The piece that a number is in: 0 before the first knot, the number of knots behind the last.
function pieceOf({ knots, density }, x) {
  let [low, high] = [1, knots.length - 1];
  if (x < knots[0]) return 0;
  if (x > knots[high]) return knots.length;
  if (density > 0) return 1 + Math.min(Math.trunc((x - knots[0]) * density), knots.length - 2);
  while (low < high) {
    const middle = Math.floor((low + high) / 2);
    if (knots[middle] <= x) low = middle + 1; else high = middle;
  }
  return low;
}

// n (n - 1) ... (n - k + 1)
function falling(n, k) {
  let product = 1;
  for (let i = 0; i < k; i++) product *= n - i;
  return product;
}

// A derivative of a product of polynomials of distances, whose coefficients belong to ascending powers; those of the last distance are adjacent.
function polynomial(axes, distances, at, coefficients, first, size) {
  const [order, step] = [axes[at].order, size ** (axes.length - 1 - at)];
  if (order >= size) return 0;
  const term = (i) => (step > 1 ? polynomial(axes, distances, at + 1, coefficients, first + i * step, size) : coefficients[first + i]) * falling(i, order);
  let sum = term(size - 1);
  for (let i = size - 2; i >= order; i--) sum = sum * distances[at] + term(i);
  return sum;
}

// The value or a derivative of a table of several arguments.
function lookup(axes, values, coefficients, size) {
  let piece = 0;
  const distances = [];
  for (const [i, x] of values.entries()) {
    if (x !== x) return x;
    const along = pieceOf(axes[i], x);
    distances.push(x - axes[i].knots[along > 0 ? along - 1 : 0]);
    piece = piece * (axes[i].knots.length + 1) + along;
  }
  return polynomial(axes, distances, 0, coefficients, piece * size ** axes.length, size);
}
