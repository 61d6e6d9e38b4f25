//! Polynomials whose coefficients are states, for one motion or several in lanes.

use crate::linalg::vector::combined_if_fused as combined;
use crate::scalar::Number;
use crate::system::{MAX_ORDER, StateVector};

/// Returns the change over a time `h`, given the coefficients of orders 1, 2, …
#[inline(always)]
pub(super) fn increment<const FUSED: bool, S: Number, Y: StateVector<S>>(coefficients: &[Y], h: S) -> Y {
    let mut change = polynomial::<FUSED, S, Y>(coefficients, None, h);
    for sum in change.padded_mut() {
        *sum = *sum * h;
    }
    change
}

/// Returns the slope after a time `h`, given the coefficients and their orders.
#[inline(always)]
pub(super) fn slope<const FUSED: bool, S: Number, Y: StateVector<S>>(
    coefficients: &[Y],
    orders: &[S; MAX_ORDER],
    h: S,
) -> Y {
    polynomial::<FUSED, S, Y>(coefficients, Some(orders), h)
}

/// Computes Σ hᵏ times the coefficient of order k + 1, and times the order if it is given, as four
/// polynomials in h⁴. Successive terms can then be computed independently.
#[inline(always)]
fn polynomial<const FUSED: bool, S: Number, Y: StateVector<S>>(
    coefficients: &[Y],
    orders: Option<&[S; MAX_ORDER]>,
    h: S,
) -> Y {
    let square = h * h;
    let fourth = square * square;
    let (blocks, rest) = coefficients.as_chunks::<4>();
    let mut sums = [coefficients.first().map_or(Y::ZERO, StateVector::zeros); 4];
    for (place, (sum, coefficients)) in sums.iter_mut().zip(rest).enumerate() {
        *sum = term(coefficients, orders, 4 * blocks.len() + place);
    }
    for (block, coefficients) in blocks.iter().enumerate().rev() {
        for place in 0..4 {
            let term = term(&coefficients[place], orders, 4 * block + place);
            sums[place] = combined::<FUSED, S, Y>(&term, fourth, &sums[place]);
        }
    }
    let [total, first, second, third] = sums;
    // A closure would be compiled without the instructions of its caller.
    let even = combined::<FUSED, S, Y>(&total, square, &second);
    let odd = combined::<FUSED, S, Y>(&first, square, &third);
    combined::<FUSED, S, Y>(&even, h, &odd)
}

#[inline(always)]
fn term<S: Number, Y: StateVector<S>>(coefficients: &Y, orders: Option<&[S; MAX_ORDER]>, index: usize) -> Y {
    let mut term = *coefficients;
    if let Some(orders) = orders {
        for entry in term.padded_mut() {
            *entry = *entry * orders[index];
        }
    }
    term
}

/// Returns the largest of the coefficients of an order, each times its scale.
#[inline(always)]
pub(super) fn largest<S: Number, Y: StateVector<S>>(coefficients: &Y, scales: &Y) -> S {
    let mut largest = S::ZERO;
    for (coefficient, scale) in coefficients.as_ref().iter().zip(scales.as_ref()) {
        largest = largest.max(coefficient.abs() * *scale);
    }
    largest
}
