use super::newton;
use crate::scalar::{Lanes, Number, Scalar};

/// y − e sin y − M, Kepler's equation.
fn kepler<S: Number>(e: S, mean: S) -> S {
    newton(mean, 30, |y| {
        let (sine, cosine) = y.sin_cos();
        let slope = S::ONE - e * cosine;
        [y - e * sine - mean, slope, (y * slope).abs() + (e * sine).abs() + (e * sine).abs()]
    })
}

#[test]
fn zeros_are_found_to_rounding() {
    // By mpmath with 30 digits.
    let known = [(0.1, 0.5, 0.552_479_986_906_570_4), (0.9, 0.1, 0.630_843_527_563_153_5)];
    for (e, mean, expected) in known {
        let found: f64 = kepler(e, mean);
        assert!((found - expected).abs() < 4e-16, "{found} {expected}");
        let single = kepler(e as f32, mean as f32);
        assert!((f64::from(single) - expected).abs() < 4e-7, "{single}");
    }
}

#[test]
fn lanes_do_not_depend_on_each_other() {
    let (e, means) = (0.9, [0.0, 0.1, 1.5, f64::NAN]);
    let Lanes(found) = kepler(Lanes::<f64, 4>([e; 4]), Lanes(means));
    for (found, mean) in found.into_iter().zip(means) {
        let Lanes([alone]) = kepler(Lanes::<f64, 1>([e]), Lanes([mean]));
        assert_eq!(found.to_bits(), alone.to_bits(), "{mean}");
    }
    assert!(found[3].is_nan() && found[..3].iter().all(|found| found.is_finite()));
}

#[test]
fn small_zeros_are_found_where_digits_cancel() {
    // ln(1 + y) = x: of x = 10⁻¹² the sum keeps four digits, and steps never become smaller than that.
    let x = 1e-12;
    let found: f64 = newton(0.0, 30, |y| {
        let logarithm = (1.0 + y).ln();
        [logarithm - x, 1.0 / (1.0 + y), 1.0 + (y / (1.0 + y)).abs() + logarithm.abs()]
    });
    assert!((found - x).abs() < 4.0 * f64::epsilon(), "{found}");
}

#[test]
fn what_has_no_zero_or_no_slope_is_not_a_number() {
    let without_zero =
        |y: f64| [(y - 1000.0).powi(2) + 1e-12, 2.0 * (y - 1000.0), 4.0 * (y - 1000.0).powi(2)];
    assert!(newton(1.0, 1000, without_zero).is_nan());
    assert!(newton(0.0, 30, |y: f64| [y * y - 1.0, 2.0 * y, 3.0 * y * y]).is_nan());
    assert!(newton(0.0, 30, |y: f64| [y * y, 2.0 * y, 3.0 * y * y]).is_nan());
    // Where everything overflows nothing is zero.
    assert!(newton(1.0, 30, |_: f64| [1.0, f64::INFINITY, f64::INFINITY]).is_nan());
    assert!(newton(1.0, 2, |y: f64| [y.powi(3) - 2.0, 3.0 * y * y, 4.0 * y.powi(3)]).is_nan());
}
