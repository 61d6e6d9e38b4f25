//! Eigenvalues that are known.

use super::{Watch, largest_eigenvalue};

#[test]
fn oscillations_decay_and_growth_are_told_apart() {
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

#[test]
fn nothing_is_said_where_nothing_can_be_told() {
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
