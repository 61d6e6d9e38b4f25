//! Known eigenvalues.

use super::{Watch, eigenvalue_at, largest_eigenvalue};

#[test]
fn oscillations_decay_and_growth_are_distinguished() {
    let largest =
        |rates: fn(&[f64; 2]) -> [f64; 2]| largest_eigenvalue(rates, &[0.3, 0.2], 0.1, &[1.0, -2.0]);
    assert!((largest(|[x, v]| [*v, -1e8 * x]) / 1e4 - 1.0).abs() < 1e-3);
    assert!((largest(|[x, y]| [-3e5 * x, -2.0 * y]) / 3e5 - 1.0).abs() < 1e-6);
    assert_eq!(largest(|[x, y]| [3e5 * x, -2.0 * y]), 0.0);
}

#[test]
fn units_do_not_matter() {
    let mixed = |[x, v]: &[f64; 2]| [1e7 * v, -1e-3 * x];
    assert!((largest_eigenvalue(mixed, &[1.0, 1.0], 0.1, &[1.0, 1.0]) / 100.0 - 1.0).abs() < 1e-6);
}

/// A pair of eigenvalues is found for any damping, any units of the rates, and any phase of the
/// motion.
#[test]
fn damped_oscillations_are_recognised_by_their_frequency() {
    for frequency in [0.01_f64, 3.0, 1e4] {
        for damping in [0.0, 0.1, 0.5, 0.7, 0.95] {
            let rates = |[x, v]: &[f64; 2]| [*v, -frequency * frequency * x - 2.0 * damping * frequency * v];
            for phase in 0..24 {
                let (sin, cos) = (f64::from(phase) * 0.2618).sin_cos();
                let y = [cos, frequency * sin];
                let watched = largest_eigenvalue(rates, &y, 0.1, &[-sin, frequency * cos]);
                let found = eigenvalue_at(rates, &y).expect("it moves");
                for found in [watched, found] {
                    assert!((found / frequency - 1.0).abs() < 1e-3, "{frequency} {damping} {phase}: {found}");
                }
            }
        }
    }
}

/// Beyond critical damping there are two decays, and in a chain many modes; the fastest one counts.
#[test]
fn the_fastest_of_several_is_found() {
    let overdamped = |[x, v]: &[f64; 2]| [*v, -1e4 * x - 500.0 * v];
    let fastest = 250.0 + (250.0_f64 * 250.0 - 1e4).sqrt();
    let found = eigenvalue_at(overdamped, &[0.3, -2.0]).expect("it moves");
    assert!((found / fastest - 1.0).abs() < 1e-3, "{found}");
    let slow_and_fast = |[x, u, v, w]: &[f64; 4]| [*v, *w, -x, -1e8 * u - 3e3 * w];
    let found = eigenvalue_at(slow_and_fast, &[1.0, 1e-3, 0.5, 2.0]).expect("it moves");
    assert!((found / 1e4 - 1.0).abs() < 1e-3, "{found}");
}

#[test]
fn undecidable_motions_are_not_judged() {
    let outside = largest_eigenvalue(|[x]: &[f64; 1]| [x.ln()], &[-1.0], 0.1, &[1.0]);
    let unmoved = largest_eigenvalue(|_: &[f64; 1]| [1.0], &[0.0], 0.0, &[0.0]);
    let free = largest_eigenvalue(|[_, v]: &[f64; 2]| [*v, 0.0], &[0.0, 0.0], 0.0, &[1.0, 1.0]);
    assert!([outside, unmoved, free].iter().all(|eigenvalue| eigenvalue.is_nan() || *eigenvalue == 0.0));
}

#[test]
fn empty_hints_are_followed_ever_more_rarely_but_never_ignored() {
    let mut watch = Watch::default();
    let looks = (0..320).filter(|_| watch.follows(true)).count();
    assert!((10..=16).contains(&looks), "{looks}");
    let mut watch = Watch::default();
    assert!((0..100).all(|_| !watch.follows(false)) && watch.follows(true));
}
