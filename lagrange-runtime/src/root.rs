//! Zeros of functions that emitted code cannot write out: the algebraic unknowns of declarations.

use crate::scalar::{Mask, Number, spacing_at_one};

/// Residuals up to this many times what rounding may leave of them count as zero.
const TOLERANCE: f64 = 4.0;

/// The zero that Newton's method finds from a start within so many steps; NaN if it finds none. Numbers side by side go on until each of
/// them has its own, which does not depend on the others.
///
/// `equation` computes of y the residual r, its slope ∂r/∂y, and what one relative rounding error in y and in each value that r is made of
/// would leave of it. A zero is where r is no larger than that, within a factor of four for as many roundings as there are; from there one more step is
/// taken. So a plain distance between steps, which means nothing where the digits of r cancel, decides nothing.
///
/// ```
/// use lagrange::root::newton;
///
/// let cube_root_of_two = newton(1.0_f64, 30, |y| [y.powi(3) - 2.0, 3.0 * y * y, 4.0 * y.powi(3).abs()]);
/// assert!((cube_root_of_two - 2.0_f64.cbrt()).abs() < 1e-15);
/// assert!(newton(1.0_f64, 30, |y| [y * y + 1.0, 2.0 * y, 3.0 * y * y]).is_nan());
/// ```
#[inline(always)]
pub fn newton<S: Number>(start: S, iterations: u32, equation: impl Fn(S) -> [S; 3]) -> S {
    let tolerance = S::from_f64(TOLERANCE) * spacing_at_one();
    let is_number = |y: S| y.less_equal(y);
    let (mut y, mut root) = (start, S::NAN);
    for _ in 0..iterations {
        let [residual, slope, rounding] = equation(y);
        let bound = tolerance * rounding;
        let is_zero = residual.abs().less_equal(bound) & bound.less(S::from_f64(f64::INFINITY));
        y = y - residual / slope;
        root = S::select(is_zero & !is_number(root), y, root);
        if (is_number(root) | !is_number(y)).all() {
            break;
        }
    }
    root
}

#[cfg(test)]
mod tests;
