//! Items that the expansion of [`system!`](crate::system!) may name and users may not: they are not
//! stable.

pub mod hints;

pub use crate::__hints as bring_hints;
pub use lagrange_macro::system;
pub use lagrange_runtime::system::{Order, Products, SeriesSolver};

use crate::scalar::Number;

/// Computes sine and cosine of several angles, under its bare name.
#[inline(always)]
pub fn sin_cos_each<S: Number, const N: usize>(angles: [S; N]) -> [(S, S); N] {
    S::sin_cos_each(angles)
}

/// Builds a matrix in rows from its nonzero entries, each with its row and column.
///
/// # Panics
/// If an index is too large.
#[inline]
pub fn matrix<S: Number, const N: usize, const M: usize>(entries: &[(usize, usize, S)]) -> [[S; N]; M] {
    let mut matrix = [[S::ZERO; N]; M];
    for &(row, column, entry) in entries {
        matrix[row][column] = entry;
    }
    matrix
}

/// Selects one value where a number is less than another, a second one where it is not, and NaN
/// where one of the two is.
#[inline(always)]
pub fn if_less<S: Number>(left: S, right: S, then: S, otherwise: S) -> S {
    let or_otherwise = S::select(right.less_equal(left), otherwise, S::NAN);
    S::select(left.less(right), then, or_otherwise)
}

/// Selects by a comparison of two numbers: less than or equal.
#[inline(always)]
pub fn if_less_equal<S: Number>(left: S, right: S, then: S, otherwise: S) -> S {
    let or_otherwise = S::select(right.less(left), otherwise, S::NAN);
    S::select(left.less_equal(right), then, or_otherwise)
}

/// Functions under their bare names, so that generated formulas read like formulas.
macro_rules! bare_names {
    ($(
        $name:ident($($argument:ident),*) C $c:tt lanes $lanes:tt $method:tt
    )*) => {
        $(bare_names! { $name($($argument: S),*) -> S })*
    };
    ($($name:ident($($argument:ident: $kind:ty),*) -> $result:ty)*) => {
        $(#[inline(always)]
        pub fn $name<S: Number>($($argument: $kind),*) -> $result {
            S::$name($($argument),*)
        })*
    };
}

crate::scalar::functions!(bare_names);

bare_names! {
    sin_cos(x: S) -> (S, S)
    sign(x: S) -> S
    min(a: S, b: S) -> S
    max(a: S, b: S) -> S
    powi(base: S, exponent: i32) -> S
    powf(base: S, exponent: S) -> S
    multiply_add(factor: S, other: S, addend: S) -> S
    reciprocal(x: S) -> S
}
