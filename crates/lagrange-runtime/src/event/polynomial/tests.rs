//! Polynomials with known zeros.

use std::vec::Vec;

use super::{POINTS, Polynomial, SignChange, points};

fn of(function: impl Fn(f64) -> f64) -> Polynomial<f64> {
    Polynomial::new(&points().map(function))
}

/// Returns all changes of sign, as intervals.
fn changes(function: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let polynomial = of(&function);
    let (mut sign, mut x, mut found) = (function(0.0), 0.0, Vec::new());
    while let SignChange::Between(from, to) = polynomial.next_change(sign, x, false) {
        found.push((from, to));
        (sign, x) = (-sign, to);
    }
    found
}

#[test]
fn points_are_those_of_chebyshev() {
    for (j, point) in points::<f64>().into_iter().enumerate() {
        let exact = (1.0 - (core::f64::consts::PI * j as f64 / 8.0).cos()) / 2.0;
        assert!((point - exact).abs() < 3e-16, "{j}");
    }
}

#[test]
fn polynomials_of_degree_eight_come_back() {
    for power in 0..POINTS as i32 {
        let polynomial = of(|x| x.powi(power));
        for (x, width) in [(0.0, 1.0), (0.25, 0.5), (0.6, 0.001), (0.999, 0.001)] {
            let part = polynomial.part(1.0, x, x + width);
            assert!((part[0] - x.powi(power)).abs() < 1e-13, "{power} at {x}");
            assert!((part[POINTS - 1] - (x + width).powi(power)).abs() < 1e-13, "{power} after {x}");
        }
    }
}

#[test]
fn every_change_of_sign_has_an_interval_of_its_own() {
    let zeros = [0.03, 0.1, 0.1003, 0.7, 0.99, 0.995];
    let product = |count: usize| move |x: f64| zeros[..count].iter().map(|zero| x - zero).product::<f64>();
    for count in 1..=zeros.len() {
        let found = changes(product(count));
        assert_eq!(found.len(), count, "{found:?}");
        assert!(found.iter().zip(zeros).all(|((from, to), zero)| *from < zero && zero < *to), "{found:?}");
    }
}

#[test]
fn what_only_touches_zero_does_not_change() {
    for place in [0.0, 0.3, 0.5, 1.0] {
        let polynomial = of(|x| (x - place).powi(2));
        assert!(polynomial.is_exact());
        assert!(!matches!(polynomial.next_change(1.0, 0.0, false), SignChange::Between(..)), "{place}");
    }
    assert_eq!(of(|x| 1.0 + x).next_change(1.0, 0.0, false), SignChange::Nowhere);
    let nearly = of(|x| (x - 0.5).powi(2) + 1e-9);
    assert_eq!(
        nearly.next_change(1.0, 0.0, false),
        SignChange::Nowhere,
        "it stays clear of zero by more than rounding"
    );
}

#[test]
fn what_is_cut_off_shows() {
    assert!(of(f64::sin).is_trusted() && of(f64::exp).is_trusted());
    assert!(!of(|x| (40.0 * x).sin()).is_trusted() && !of(|x| (x - 0.4).abs() - 0.1).is_trusted());
    let touching = of(|x| 1.0 - (3.0 * (x - 0.5)).cos());
    assert!(touching.is_trusted() && !touching.is_exact());
    assert_eq!(touching.next_change(1.0, 0.0, false), SignChange::Unclear);
}

#[test]
fn where_it_heads_for_is_seen_at_its_start() {
    assert!(of(|x| x * (1e-3 - x)).rise(1.0) > 0.0 && of(|x| x * (1e-3 - x)).rise(-1.0) == 0.0);
    assert!((of(|x| -x).rise(-1.0) - 1.0).abs() < 1e-12);
    assert!([1.0, -1.0].iter().all(|sign| of(|x| -x * x).rise(*sign) == 0.0), "it starts at rest");
}

/// The spacing of `f32` near one is so coarse that a part could be too narrow to advance.
#[test]
fn the_search_ends_in_short_numbers_too() {
    let mut ends = 0;
    for bits in 0..2000_u16 {
        // A parabola that falls through zero within a few roundings of its end.
        let (drop, slope) = (f32::from(bits % 40) * 1e-5 - 2e-4, 0.01 + f32::from(bits) * 1e-4);
        let values = points::<f32>().map(|x| slope * (drop + (1.0 - x) * (1.0 + 0.02 * (1.0 - x))));
        for x in [0.0, 0.5, 0.999_937_3, 0.999_999_94] {
            if let SignChange::Between(from, to) = Polynomial::new(&values).next_change(1.0, x, false) {
                assert!(x <= from && from < to && to <= 1.0, "{drop} {slope}: {from} {to}");
                ends += 1;
            }
        }
    }
    assert!(ends > 100, "{ends}");
}
