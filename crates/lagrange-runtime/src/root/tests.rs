use super::{coupled, newton};
use crate::scalar::{Lanes, Number, Scalar};

/// Solves Kepler's equation, y − e sin y − M = 0.
fn kepler<S: Number>(e: S, mean: S) -> S {
    newton(mean, 30, |y| {
        let (sine, cosine) = y.sin_cos();
        let slope = S::ONE - e * cosine;
        [y - e * sine - mean, slope, (y * slope).abs() + (e * sine).abs() + (e * sine).abs()]
    })
}

#[test]
fn zeros_are_found_to_rounding() {
    // Computed by mpmath with 30 digits.
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

/// Returns an intersection of the circle y² + z² = 2 r² and the line z = s y.
fn crossing<S: Number>(radius: S, slope: S, start: [S; 2]) -> [S; 2] {
    let two = S::from_f64(2.0);
    coupled(start, 40, |[y, z]| {
        let residuals = [y * y + z * z - two * radius * radius, slope * y - z];
        let rounding = [S::from_f64(3.0) * (y * y + z * z), two * (slope * y).abs() + z.abs()];
        (residuals, [[two * y, two * z], [slope, -S::ONE]], rounding)
    })
}

#[test]
fn coupled_zeros_are_found_to_rounding_and_each_lane_finds_its_own() {
    for (radius, slope) in [(1.0, 1.0), (3e8, 0.25), (1e-9, -40.0), (1.0, 1e9), (1.0, 0.0)] {
        let y = radius * (2.0 / (1.0 + slope * slope)).sqrt();
        let start = [1.3 * y, 0.8 * slope * y];
        let found: [f64; 2] = crossing(radius, slope, start);
        let single = crossing(radius as f32, slope as f32, start.map(|start| start as f32));
        for ((found, single), expected) in found.into_iter().zip(single).zip([y, slope * y]) {
            assert!((found - expected).abs() <= 4e-16 * expected.abs(), "{found} {expected}");
            assert!((f64::from(single) - expected).abs() <= 3e-7 * expected.abs(), "{single} {expected}");
        }
    }
    let (radii, slopes) = ([1.0, 1.0, f64::NAN, 2.0], [1.0, -3.0, 1.0, 0.0]);
    let starts = [[1.0, 0.0, 1.0, 5.0], [0.5, 0.0, 1.0, -2.0]];
    let found = crossing(Lanes::<f64, 4>(radii), Lanes(slopes), starts.map(Lanes));
    for lane in 0..4 {
        let alone = crossing(
            Lanes::<f64, 1>([radii[lane]]),
            Lanes([slopes[lane]]),
            starts.map(|start| Lanes([start[lane]])),
        );
        let bits = |found: [f64; 2]| found.map(f64::to_bits);
        assert_eq!(bits(found.map(|found| found.0[lane])), bits(alone.map(|found| found.0[0])), "{lane}");
    }
    assert!([0, 3].map(|lane| found[0].0[lane]).iter().all(|found| found.is_finite()));
    // The Jacobian is singular at the start of the second lane; the third contains NaN.
    assert!([1, 2].map(|lane| found[0].0[lane]).iter().all(|found| found.is_nan()));
}

#[test]
fn small_zeros_are_found_where_digits_cancel() {
    // ln(1 + y) = x: for x = 10⁻¹² the sum keeps four digits, and steps never become smaller than
    // this error.
    let x = 1e-12;
    let found: f64 = newton(0.0, 30, |y| {
        let logarithm = (1.0 + y).ln();
        [logarithm - x, 1.0 / (1.0 + y), 1.0 + (y / (1.0 + y)).abs() + logarithm.abs()]
    });
    assert!((found - x).abs() < 4.0 * f64::epsilon(), "{found}");
}

#[test]
fn equations_without_zero_or_slope_give_nan() {
    let without_zero =
        |y: f64| [(y - 1000.0).powi(2) + 1e-12, 2.0 * (y - 1000.0), 4.0 * (y - 1000.0).powi(2)];
    assert!(newton(1.0, 1000, without_zero).is_nan());
    assert!(newton(0.0, 30, |y: f64| [y * y - 1.0, 2.0 * y, 3.0 * y * y]).is_nan());
    assert!(newton(0.0, 30, |y: f64| [y * y, 2.0 * y, 3.0 * y * y]).is_nan());
    // If everything overflows, nothing counts as zero.
    assert!(newton(1.0, 30, |_: f64| [1.0, f64::INFINITY, f64::INFINITY]).is_nan());
    assert!(newton(1.0, 2, |y: f64| [y.powi(3) - 2.0, 3.0 * y * y, 4.0 * y.powi(3)]).is_nan());
}

/// Evaluates equations with one unknown y, each with its slope and a bound on its rounding error.
fn equation<S: Number>(name: &str, x: S, y: S) -> [S; 3] {
    let (one, two) = (S::ONE, S::from_f64(2.0));
    let terms = |terms: &[S], slope: S| {
        let sum = terms.iter().fold(S::ZERO, |sum, term| sum + *term);
        [sum, slope, terms.iter().fold((y * slope).abs(), |sum, term| sum + term.abs())]
    };
    match name {
        "below_root" => {
            let root = (y * y + one).sqrt();
            terms(&[root, -y, x], y / root - one)
        }
        "below_distance" => {
            let distance = (y - one).hypot(two);
            terms(&[distance, -S::from_f64(5.0).sqrt(), y, -x], (y - one) / distance + one)
        }
        "fold" => terms(&[y * y, -(two * y), one, x], two * y - two),
        "exponential" => terms(&[y.exp(), -x], y.exp()),
        "decay" => terms(&[(-y).exp(), x], -(-y).exp()),
        "cubic" => terms(&[y * y * y, y, -x], S::from_f64(3.0) * y * y + one),
        "logarithm" => {
            let [sum, slope, rounding] = terms(&[(one + y).ln(), -x], one / (one + y));
            [sum, slope, rounding + (one / (one + y)).abs()]
        }
        "saturation" => terms(&[y.tanh(), -x], one / (y.cosh() * y.cosh())),
        "angle" => terms(&[y.atan(), -x], one / (one + y * y)),
        "hump" => {
            let square = one + y * y;
            terms(&[y / square, -x], (one - y * y) / (square * square))
        }
        "kepler" => {
            let e = S::from_f64(0.75);
            terms(&[y, -(e * y.sin()), -x], one - e * y.cos())
        }
        "chain" => terms(&[y.cosh(), -x], y.sinh()),
        "kink" => terms(&[y.abs(), y / two, -x], y.sign() + one / two),
        "difference" => {
            let [short, long] = [one, two].map(|shift| (y * y + shift).sqrt());
            terms(&[short, -long, x], y / short - y / long)
        }
        _ => {
            let distance = y - one;
            let [sum, slope, rounding] =
                terms(&[distance * distance * distance, -x], S::from_f64(3.0) * distance * distance);
            [sum, slope, rounding + (slope * y).abs()]
        }
    }
}

/// Counts equations that are solved, and equations that are not solved although they have a
/// solution.
fn swept<S: Scalar>(start: f64, iterations: u32, epsilon: f64, to_f64: impl Fn(S) -> f64) -> [usize; 2] {
    let mut counts = [0; 2];
    for line in include_str!("solutions.csv").lines() {
        let cells = line.split(',').collect::<std::vec::Vec<_>>();
        let number = |cell: &str| cell.parse::<f64>().expect("a number");
        let (name, x) = (cells[0], S::from_f64(number(cells[1])));
        let found = to_f64(newton(S::from_f64(start), iterations, |y| equation(name, x, y)));
        let solutions = cells[2..].chunks(2).map(|cells| (number(cells[0]), number(cells[1])));
        let is_near = |(y, spread): (f64, f64)| {
            (found - y).abs() <= (64.0 * epsilon * spread).min(64.0 * epsilon + 0.25 * y.abs())
        };
        let is_found = { solutions }.any(is_near);
        assert!(found.is_nan() || is_found, "{line}: {found}");
        if cells.len() > 2 {
            counts[usize::from(!is_found)] += 1;
        }
    }
    counts
}

/// Solutions by mpmath, from `tools/algebraic_unknowns.py`. Every result is one of them, or NaN.
#[test]
fn what_is_found_is_a_solution() {
    for (start, iterations) in [(0.0, 30), (1.0, 30), (1.0, 100), (-3.0, 100), (1e8, 60)] {
        let double = swept::<f64>(start, iterations, f64::EPSILON, |y| y);
        let single = swept::<f32>(start, iterations, f32::EPSILON.into(), f64::from);
        // If Newton's method converges to a solution, it is returned.
        let is_handed_out = [double, single].iter().all(|[found, lost]| *found > 7 * lost);
        assert!(start != 0.0 || is_handed_out, "{double:?} {single:?}");
    }
}
