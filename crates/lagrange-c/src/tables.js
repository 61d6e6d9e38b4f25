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

// A derivative of the polynomial with these coefficients of ascending powers of s.
function polynomial(coefficients, first, size, order, s) {
  if (order >= size) return 0;
  let sum = coefficients[first + size - 1] * falling(size - 1, order);
  for (let i = size - 1; i > order; i--) sum = sum * s + coefficients[first + i - 1] * falling(i - 1, order);
  return sum;
}

const beyond = ({ knots }, piece, x) => x - knots[piece > 0 ? piece - 1 : 0];

function curve(axis, x, coefficients, size) {
  if (x !== x) return x;
  const piece = pieceOf(axis, x);
  return polynomial(coefficients, piece * size, size, axis.order, beyond(axis, piece, x));
}

function surface(alongX, x, alongY, y, coefficients, size) {
  if (x !== x || y !== y) return x + y;
  const [i, j] = [pieceOf(alongX, x), pieceOf(alongY, y)];
  const first = (i * (alongY.knots.length + 1) + j) * size * size;
  const rows = [];
  for (let row = 0; row < size; row++) {
    rows.push(polynomial(coefficients, first + row * size, size, alongY.order, beyond(alongY, j, y)));
  }
  return polynomial(rows, 0, size, alongX.order, beyond(alongX, i, x));
}
