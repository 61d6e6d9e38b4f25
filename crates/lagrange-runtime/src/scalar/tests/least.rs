//! A number type that defines only the required functions and uses defaults otherwise.

use core::ops::{Add, Div, Mul, Neg, Sub};
use std::format;

use super::super::{Number, Scalar};

/// A number of type T with only the required functions.
#[derive(Clone, Copy, PartialEq, PartialOrd, Debug)]
struct Least<T>(T);

macro_rules! operators {
    ($($operator:ident $method:ident;)*) => {
        $(impl<T: Scalar> $operator for Least<T> {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                Least(self.0.$method(other.0))
            }
        })*
    };
}

operators! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}

impl<T: Scalar> Neg for Least<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Least(-self.0)
    }
}

impl<T: Scalar> Number for Least<T> {
    type Mask = bool;

    const ZERO: Self = Least(T::ZERO);
    const ONE: Self = Least(T::ONE);
    const NAN: Self = Least(T::NAN);

    fn from_f64(value: f64) -> Self {
        Least(T::from_f64(value))
    }

    fn less(self, other: Self) -> bool {
        self < other
    }

    fn less_equal(self, other: Self) -> bool {
        self <= other
    }

    fn select(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }

    fn sin(self) -> Self {
        Least(self.0.sin())
    }

    fn cos(self) -> Self {
        Least(self.0.cos())
    }

    fn atan2(self, abscissa: Self) -> Self {
        Least(self.0.atan2(abscissa.0))
    }

    fn exp(self) -> Self {
        Least(self.0.exp())
    }

    fn ln(self) -> Self {
        Least(self.0.ln())
    }

    fn sqrt(self) -> Self {
        Least(self.0.sqrt())
    }

    fn powf(self, exponent: Self) -> Self {
        Least(self.0.powf(exponent.0))
    }
}

/// Returns samples from tiny to large, with the boundaries of all domains, zeros of both signs,
/// infinities and NaN.
fn samples() -> impl Iterator<Item = f64> {
    let swept = (-300..=300).map(|step| f64::from(step) * 0.037);
    let powers = (-60..=60).map(|power| 1.7 * 2.0_f64.powi(power));
    let corners = [0.0, 0.5, 1.0, 709.9, 710.4, f64::MIN_POSITIVE, f64::MAX, f64::INFINITY, f64::NAN];
    swept.chain(powers).chain(corners).flat_map(|x| [x, -x])
}

/// Compares values, infinities, NaN and signs of zeros.
fn check<T: Scalar>(name: &str, arguments: &[T], found: T, expected: T) {
    let text = || format!("{name} of {arguments:?}: {found:?}, not {expected:?}");
    let is_nan = |x: T| x.partial_cmp(&x).is_none();
    if is_nan(expected) {
        assert!(is_nan(found), "{}", text());
        return;
    }
    let is_negative = |x: T| x < T::ZERO || T::ONE / x < T::ZERO;
    assert_eq!(is_negative(found), is_negative(expected), "{}", text());
    let tolerance = T::from_f64(6.0) * T::epsilon() * expected.abs();
    assert!(found == expected || (found - expected).abs() <= tolerance, "{}", text());
}

/// Compares each function of the list with that of the underlying number.
macro_rules! compare {
    ($T:ident: $(
        $name:ident($first:ident $(, $second:ident)?) C $c:tt lanes $lanes:tt $method:tt
    )*) => {
        $(for $first in samples().map($T::from_f64) {
            compare!(@at $T, $name, $first $(, $second)?);
        })*
    };
    (@at $T:ident, $name:ident, $x:ident) => {
        check(stringify!($name), &[$x], Least($x).$name().0, $x.$name())
    };
    (@at $T:ident, $name:ident, $x:ident, $y:ident) => {
        for $y in samples().step_by(7).map($T::from_f64) {
            check(stringify!($name), &[$x, $y], Least($x).$name(Least($y)).0, $x.$name($y));
        }
    };
}

#[test]
fn defaults_are_the_functions_of_the_platform_but_for_some_rounding() {
    lagrange_math::functions!(compare f64:);
    lagrange_math::functions!(compare f32:);
}
