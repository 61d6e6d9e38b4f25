// a to the power b; what is not a number stays so.
function powf(a, b) {
  if (a !== a || b !== b) return a + b;
  return a === 1 || (a === -1 && Math.abs(b) === Infinity) ? 1 : Math.pow(a, b);
}

// Repeated squaring from the lowest bit of the exponent.
function powi(base, exponent) {
  let [product, square] = [1, base];
  for (let remaining = Math.abs(exponent); remaining > 0; remaining = Math.floor(remaining / 2)) {
    if (remaining % 2 === 1) product *= square;
    if (remaining > 1) square *= square;
  }
  return exponent < 0 ? 1 / product : product;
}
