//! Sums and products of doubles together with their rounding errors.

/// Rounding errors of products below this are not representable as doubles.
const LEAST_EXACT_PRODUCT: f64 = f64::from_bits((1023 - 969) << 52);

/// Returns the rounded sum and its error (Knuth).
#[inline(always)]
pub(crate) fn sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_a = sum - b;
    let of_b = sum - of_a;
    (sum, (a - of_a) + (b - of_b))
}

/// Returns the rounded sum and its error, for |a| ≥ |b| or a = 0 (Dekker).
#[inline(always)]
pub(crate) fn ordered_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Returns the rounded product and its error. The error is set to zero if it may not be
/// representable as a double.
#[inline(always)]
pub(crate) fn product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let error = product_error(a, b, product);
    (product, if product.abs() < LEAST_EXACT_PRODUCT { 0.0 } else { error })
}

/// Computes a b + c, rounded once where `std` or the target has that, otherwise twice.
#[inline(always)]
pub(crate) fn fused(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(feature = "std")]
    return a.mul_add(b, c);
    #[cfg(not(feature = "std"))]
    return a * b + c;
}

/// Returns the rounded product and its error, for code that the processor's fused products compute.
#[inline(always)]
pub(crate) fn fused_product(a: f64, b: f64) -> (f64, f64) {
    #[cfg(feature = "std")]
    return (a * b, a.mul_add(b, -(a * b)));
    #[cfg(not(feature = "std"))]
    return product(a, b);
}

#[cfg(all(feature = "std", target_feature = "fma"))]
#[inline(always)]
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    a.mul_add(b, -product)
}

/// Computes the error from products of halves, which are exact (Dekker).
#[cfg(not(all(feature = "std", target_feature = "fma")))]
#[inline(always)]
fn product_error(a: f64, b: f64, product: f64) -> f64 {
    let ((a1, a2), (b1, b2)) = (halves(a), halves(b));
    ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2
}

/// Splits a number into two numbers of at most 26 bits.
#[cfg(not(all(feature = "std", target_feature = "fma")))]
#[inline(always)]
fn halves(x: f64) -> (f64, f64) {
    const LOWER_BITS: u64 = (1 << 27) - 1;
    let upper = f64::from_bits(x.to_bits().wrapping_add(1 << 26) & !LOWER_BITS);
    (upper, x - upper)
}
