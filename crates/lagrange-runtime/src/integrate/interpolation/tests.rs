//! Polynomials that are reproduced exactly.

use super::{Motion, Place, cubic, quintic};

#[test]
fn cubics_are_met() {
    let (h, y, f) =
        (2.0_f64, |t: f64| [1.0 + t * (2.0 + t * (3.0 - t))], |t: f64| [2.0 + t * (6.0 - 3.0 * t)]);
    for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
        let [found] = cubic(Place { h, s }, [&y(0.0), &y(h)], [&f(0.0), &f(h)]);
        assert!((found - y(s * h)[0]).abs() < 1e-14);
    }
}

#[test]
fn quintics_are_met_with_their_rates() {
    let h = 1.5_f64;
    let q = |t: f64| t * (1.0 + t * (0.5 + t * (-0.25 + t * (0.125 + t * 0.5))));
    let v = |t: f64| 1.0 + t * (1.0 + t * (-0.75 + t * (0.5 + t * 2.5)));
    let a = |t: f64| 1.0 + t * (-1.5 + t * (1.5 + t * 10.0));
    let motion = Motion { change: [q(h)], velocities: [[v(0.0)], [v(h)]], accelerations: [[a(0.0)], [a(h)]] };
    for s in [0.0, 0.2, 0.5, 0.9, 1.0] {
        let ([change], [velocity]) = quintic(Place { h, s }, &motion);
        assert!((change - q(s * h)).abs() < 1e-14 && (velocity - v(s * h)).abs() < 1e-13);
    }
}
