//! Every function at NaN, ±0 and ±∞ for all number types, and `libm` against the standard library.
//!
//! The first part tests whichever of the two libraries the features select.

mod least;
mod portable;

use core::f64::consts::{FRAC_PI_2, PI};

use super::{Lanes, Number, Portable, Scalar};

/// Numbers at which functions are most likely to be wrong.
struct Special<S> {
    zero: S,
    one: S,
    infinity: S,
    nan: S,
}

fn special<S: Scalar>() -> Special<S> {
    Special { zero: S::ZERO, one: S::ONE, infinity: S::from_f64(f64::INFINITY), nan: S::NAN }
}

/// True if two numbers agree, including NaN and the sign of zeros.
fn same<S: Scalar>(a: S, b: S) -> bool {
    let is_nan = |x: S| x.partial_cmp(&x).is_none();
    let same_zero = a != S::ZERO || S::ONE / a == S::ONE / b;
    (is_nan(a) && is_nan(b)) || (a == b && same_zero)
}

#[track_caller]
fn expect<S: Scalar>(found: S, wanted: S) {
    assert!(same(found, wanted), "{found:?} instead of {wanted:?}");
}

/// Checks like `expect`, but up to rounding.
#[track_caller]
fn expect_near<S: Scalar>(found: S, wanted: f64) {
    let error = (found - S::from_f64(wanted)).abs();
    assert!(error <= S::from_f64(1e-6), "{found:?} instead of {wanted:?}");
}

/// Runs the checks for all number types.
macro_rules! for_all {
    ($($test:ident)*) => {
        $(
            mod $test {
                use super::super::Portable;

                #[test]
                fn f32() {
                    super::super::checks::$test::<f32>();
                }

                #[test]
                fn f64() {
                    super::super::checks::$test::<f64>();
                }

                #[test]
                fn portable() {
                    super::super::checks::$test::<Portable<f32>>();
                    super::super::checks::$test::<Portable>();
                }
            }
        )*
    };
}

mod all {
    for_all! {
        constants_and_conversion nan_is_never_hidden odd_functions_keep_signed_zeros
        circular_functions_at_the_edges hyperbolic_functions_at_the_edges roots_and_logarithms_at_the_edges
        atan2_follows_signs_of_zero signs_and_magnitudes extrema_propagate_nan powers multiply_add_is_a_product_and_a_sum whole_numbers_below
    }
}

mod checks {
    use super::{FRAC_PI_2, PI, Scalar, Special, expect, expect_near, special};

    pub(super) fn constants_and_conversion<S: Scalar>() {
        let Special { zero, one, infinity, nan } = special::<S>();
        expect(S::from_f64(0.0), zero);
        expect(S::from_f64(-0.0), -zero);
        expect(S::from_f64(1.0), one);
        expect(S::from_f64(f64::NAN), nan);
        assert!(zero.is_finite() && one.is_finite());
        assert!(!infinity.is_finite() && !(-infinity).is_finite() && !nan.is_finite());
    }

    pub(super) fn whole_numbers_below<S: Scalar>() {
        let Special { infinity, nan, .. } = special::<S>();
        let found = [-3.5, -0.0, 0.9, 1.0, 6.99, 7.0, 1e30].map(|x| S::from_f64(x).floor_below(7));
        assert_eq!(found, [0, 0, 0, 1, 6, 6, 6].map(Some));
        assert_eq!([infinity, -infinity, nan].map(|x| x.floor_below(7)), [6, 0, 0].map(Some));
        assert_eq!(S::from_f64(2.5).floor_below(1), Some(0));
    }

    pub(super) fn nan_is_never_hidden<S: Scalar>() {
        let Special { zero, one, infinity, nan } = special::<S>();
        let unary = [
            S::sin,
            S::cos,
            S::tan,
            S::asin,
            S::acos,
            S::atan,
            S::sinh,
            S::cosh,
            S::tanh,
            S::exp,
            S::ln,
            S::sqrt,
            S::abs,
            S::sign,
            |x| S::sin_cos(x).0,
            |x| S::sin_cos(x).1,
            |x| S::powi(x, 3),
            |x| S::powi(x, -2),
        ];
        for function in unary {
            expect(function(nan), nan);
        }
        for function in [S::atan2, S::min, S::max, S::powf] {
            for other in [zero, one, -one, infinity, -infinity, nan] {
                expect(function(nan, other), nan);
                expect(function(other, nan), nan);
            }
        }
        expect(S::hypot(nan, one), nan);
        expect(S::hypot(one, nan), nan);
        expect(S::multiply_add(nan, zero, one), nan);
        expect(S::multiply_add(zero, nan, one), nan);
        expect(S::multiply_add(zero, one, nan), nan);
    }

    pub(super) fn odd_functions_keep_signed_zeros<S: Scalar>() {
        let zero = S::ZERO;
        let odd = [S::sin, S::tan, S::asin, S::atan, S::sinh, S::tanh, S::sqrt, S::sign, |x| S::powi(x, 3)];
        for function in odd {
            expect(function(zero), zero);
            expect(function(-zero), -zero);
        }
        expect(S::sin_cos(-zero).0, -zero);
    }

    pub(super) fn circular_functions_at_the_edges<S: Scalar>() {
        let Special { zero, one, infinity, nan } = special::<S>();
        for end in [infinity, -infinity] {
            for function in [S::sin, S::cos, S::tan, S::asin, S::acos] {
                expect(function(end), nan);
            }
            expect(S::sin_cos(end).0, nan);
            expect(S::sin_cos(end).1, nan);
        }
        expect(S::cos(zero), one);
        expect(S::sin_cos(zero).1, one);
        expect(S::acos(one), zero);
        expect_near(S::acos(-one), PI);
        expect_near(S::asin(one), FRAC_PI_2);
        expect_near(S::atan(infinity), FRAC_PI_2);
        expect_near(S::atan(-infinity), -FRAC_PI_2);
        let outside = S::from_f64(1.0 + 1e-6);
        for function in [S::asin, S::acos] {
            expect(function(outside), nan);
            expect(function(-outside), nan);
        }
    }

    pub(super) fn hyperbolic_functions_at_the_edges<S: Scalar>() {
        let Special { zero, one, infinity, .. } = special::<S>();
        expect(S::sinh(infinity), infinity);
        expect(S::sinh(-infinity), -infinity);
        expect(S::cosh(infinity), infinity);
        expect(S::cosh(-infinity), infinity);
        expect(S::cosh(zero), one);
        expect(S::tanh(infinity), one);
        expect(S::tanh(-infinity), -one);
    }

    pub(super) fn roots_and_logarithms_at_the_edges<S: Scalar>() {
        let Special { zero, one, infinity, nan } = special::<S>();
        expect(S::exp(zero), one);
        expect(S::exp(-infinity), zero);
        expect(S::exp(infinity), infinity);
        expect(S::ln(one), zero);
        expect(S::ln(zero), -infinity);
        expect(S::ln(-zero), -infinity);
        expect(S::ln(infinity), infinity);
        expect(S::ln(-one), nan);
        expect(S::sqrt(infinity), infinity);
        expect(S::sqrt(-one), nan);
        expect(S::hypot(-infinity, zero), infinity);
        expect(S::hypot(S::NAN, infinity), infinity);
        expect(S::hypot(-zero, -zero), zero);
        let (three, four) = (S::from_f64(3e30), S::from_f64(4e30));
        assert!(S::hypot(three, four).is_finite());
    }

    pub(super) fn atan2_follows_signs_of_zero<S: Scalar>() {
        let Special { zero, one, infinity, .. } = special::<S>();
        expect(S::atan2(zero, one), zero);
        expect(S::atan2(-zero, one), -zero);
        expect(S::atan2(zero, zero), zero);
        expect_near(S::atan2(zero, -one), PI);
        expect_near(S::atan2(-zero, -one), -PI);
        expect_near(S::atan2(-zero, -zero), -PI);
        expect_near(S::atan2(-one, zero), -FRAC_PI_2);
        expect_near(S::atan2(infinity, infinity), PI / 4.0);
        expect_near(S::atan2(infinity, -infinity), 0.75 * PI);
        expect(S::atan2(one, infinity), zero);
    }

    pub(super) fn signs_and_magnitudes<S: Scalar>() {
        let Special { zero, one, infinity, .. } = special::<S>();
        expect(S::sign(infinity), one);
        expect(S::sign(-infinity), -one);
        expect(S::sign(S::from_f64(-1e-30)), -one);
        expect(S::abs(-zero), zero);
        expect(S::abs(-infinity), infinity);
        expect(S::abs(-one), one);
    }

    pub(super) fn extrema_propagate_nan<S: Scalar>() {
        let Special { zero, one, infinity, .. } = special::<S>();
        expect(S::min(one, -infinity), -infinity);
        expect(S::max(one, infinity), infinity);
        expect(S::min(-one, one), -one);
        expect(S::max(-one, one), one);
        expect(S::min(-zero, zero), -zero);
        expect(S::max(-zero, zero), -zero);
    }

    pub(super) fn powers<S: Scalar>() {
        let Special { zero, one, infinity, nan } = special::<S>();
        let (two, half) = (S::from_f64(2.0), S::from_f64(0.5));
        expect(S::powi(two, 10), S::from_f64(1024.0));
        expect(S::powi(-two, -3), S::from_f64(-0.125));
        expect(S::powi(nan, 0), one);
        expect(S::powi(zero, -1), infinity);
        expect(S::powi(-zero, -1), -infinity);
        expect(S::powi(-infinity, 3), -infinity);
        expect(S::powi(infinity, -1), zero);
        expect(S::powi(-one, i32::MIN), one);
        expect(S::powi(-one, i32::MAX), -one);
        expect(S::powi(two, i32::MIN), zero);
        expect(S::powf(two, -one), half);
        expect(S::powf(-one, half), nan);
        expect(S::powf(-two, S::from_f64(3.0)), S::from_f64(-8.0));
        expect(S::powf(zero, zero), one);
        expect(S::powf(zero, -one), infinity);
        expect(S::powf(infinity, half), infinity);
        expect(S::powf(infinity, -half), zero);
    }

    pub(super) fn multiply_add_is_a_product_and_a_sum<S: Scalar>() {
        let Special { zero, one, infinity, nan } = special::<S>();
        let two = S::from_f64(2.0);
        expect(S::multiply_add(two, two, one), S::from_f64(5.0));
        expect(S::multiply_add(zero, infinity, one), nan);
        expect(S::multiply_add(one, infinity, -infinity), nan);
        expect(S::multiply_add(-zero, one, -zero), -zero);
    }
}

#[test]
fn multiply_add_is_fused_exactly_where_the_target_has_the_instruction() {
    let fused = cfg!(target_feature = "fma");
    // (1 + ε)² = 1 + 2ε + ε²; a rounded product loses the last term.
    let double = Number::multiply_add(1.0 + f64::EPSILON, 1.0 + f64::EPSILON, -(1.0 + 2.0 * f64::EPSILON));
    assert_eq!(double, if fused { f64::EPSILON * f64::EPSILON } else { 0.0 });
    let single = Number::multiply_add(1.0 + f32::EPSILON, 1.0 + f32::EPSILON, -(1.0 + 2.0 * f32::EPSILON));
    assert_eq!(single, if fused { f32::EPSILON * f32::EPSILON } else { 0.0 });
}

#[test]
fn angles_together_give_what_each_gives_alone() {
    let angles = [0.3, -2.0, 1e7, f64::INFINITY, -0.0];
    let singles = f32::sin_cos_each(angles.map(|angle| angle as f32));
    for ((together, angle), single) in f64::sin_cos_each(angles).into_iter().zip(angles).zip(singles) {
        let ([alone], platform) = (f64::sin_cos_each([angle]), Number::sin_cos(angle));
        expect(together.0, alone.0);
        expect(together.1, alone.1);
        assert!((together.0 - platform.0).abs() < 2e-16 || angle.is_infinite());
        assert!((f64::from(single.1) - platform.1).abs() < 1e-7 || angle.is_infinite());
    }
}

/// Each function of lanes equals that of one number, within the error bounds of both.
#[test]
fn lanes_give_what_each_gives_alone() {
    fn check<T: Scalar>() {
        let numbers = [0.3, 0.7, 1.0, -0.4].map(T::from_f64);
        let others = [0.6, -2.0, 0.5, -0.1].map(T::from_f64);
        let (x, y) = (Lanes::<T, 4>(numbers), Lanes::<T, 4>(others));
        macro_rules! check {
            ($($function:ident($x:ident $(, $y:ident)?) C $c:tt lanes $lanes:tt $method:tt)*) => {
                $(check!(@one $function $($y)?);)*
            };
            (@one $function:ident $($y:ident)?) => {
                let found = check!(@lanes $function $($y)?);
                for (i, found) in found.0.into_iter().enumerate() {
                    let expected = check!(@number $function i $($y)?);
                    let close = (found - expected).abs() <= T::from_f64(3.0) * T::epsilon() * expected.abs();
                    let is_nan = expected != expected && found != found;
                    assert!(close || is_nan, "{} of {:?}: {found:?}", stringify!($function), numbers[i]);
                }
            };
            (@lanes $function:ident) => { x.$function() };
            (@lanes $function:ident $y:ident) => { x.$function(y) };
            (@number $function:ident $i:ident) => { numbers[$i].$function() };
            (@number $function:ident $i:ident $y:ident) => { numbers[$i].$function(others[$i]) };
        }
        lagrange_math::functions!(check);
        check!(@one powf y);
        assert_eq!(x.powi(3).0, numbers.map(|number| number.powi(3)));
    }
    check::<f64>();
    check::<f32>();
}

mod libraries {
    /// Compares rows `function: name in libm for f64, for f32, over a range`.
    macro_rules! agree {
        ($($function:ident($($other:literal)?): $libm:ident $libmf:ident, $low:literal .. $high:literal;)*) => {
            $(
                #[test]
                fn $function() {
                    for sample in 0..=2000_i16 {
                        let x: f64 = $low + ($high - $low) * f64::from(sample) / 2000.0;
                        let (found, wanted) = (libm::$libm(x $(, $other)?), x.$function($($other)?));
                        let close = (found - wanted).abs() <= 4.0 * f64::EPSILON * wanted.abs();
                        assert!(close, "at {x:?}: {found:?} and {wanted:?}");
                        let x = x as f32;
                        let (found, wanted) = (libm::$libmf(x $(, $other)?), x.$function($($other)?));
                        let close = (found - wanted).abs() <= 4.0 * f32::EPSILON * wanted.abs();
                        assert!(close, "at {x:?}: {found:?} and {wanted:?}");
                    }
                }
            )*
        };
    }

    agree! {
        sin(): sin sinf, -100.0 .. 97.0;
        cos(): cos cosf, -100.0 .. 97.0;
        tan(): tan tanf, -100.0 .. 97.0;
        asin(): asin asinf, -1.0 .. 1.0;
        acos(): acos acosf, -1.0 .. 1.0;
        atan(): atan atanf, -30.0 .. 30.0;
        atan2(-0.7): atan2 atan2f, -3.0 .. 3.0;
        sinh(): sinh sinhf, -20.0 .. 20.0;
        cosh(): cosh coshf, -20.0 .. 20.0;
        tanh(): tanh tanhf, -20.0 .. 20.0;
        exp(): exp expf, -80.0 .. 80.0;
        ln(): log logf, 1e-3 .. 1e3;
        sqrt(): sqrt sqrtf, 0.0 .. 1e3;
        hypot(0.3): hypot hypotf, -10.0 .. 10.0;
        powf(2.7): pow powf, 0.0 .. 100.0;
    }

    #[test]
    fn sin_cos() {
        for sample in -1000..=1000_i16 {
            let x = f64::from(sample) / 7.0;
            assert_eq!(libm::sincos(x), (libm::sin(x), libm::cos(x)), "{x}");
            let x = f32::from(sample) / 7.0;
            assert_eq!(libm::sincosf(x), (libm::sinf(x), libm::cosf(x)), "{x}");
        }
    }
}

#[test]
fn epsilon_is_the_spacing_at_one() {
    assert_eq!(<f64 as Scalar>::epsilon(), f64::EPSILON);
    assert_eq!(<f32 as Scalar>::epsilon(), f32::EPSILON);
}
