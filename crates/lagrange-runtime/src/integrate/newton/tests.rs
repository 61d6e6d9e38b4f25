//! Iterations for equations with known solutions.

use super::{Equations, solve};
use crate::integrate::method::Work;
use crate::system::StepFailure;

/// The equations x² = target for every unknown, with the derivative 2x evaluated at a wrong place
/// and unknowns of several scales.
struct Roots {
    targets: [f64; 3],
    slopes: [f64; 3],
}

impl Equations<f64, [f64; 3], 1> for Roots {
    fn residual(&mut self, [x]: &[[f64; 3]; 1], work: &mut Work) -> [[f64; 3]; 1] {
        work.evaluations += 1;
        [core::array::from_fn(|i| self.targets[i] - x[i] * x[i])]
    }

    fn correction(&self, [residual]: &[[f64; 3]; 1]) -> [[f64; 3]; 1] {
        [core::array::from_fn(|i| residual[i] / self.slopes[i])]
    }

    fn magnitude(&self, [x]: &[[f64; 3]; 1]) -> [f64; 3] {
        core::array::from_fn(|i| x[i] * x[i])
    }
}

fn roots(slopes: [f64; 3]) -> Result<([f64; 3], Work), StepFailure<f64>> {
    let mut work = Work::default();
    let mut unknowns = [[1.5, 2e8, 4e-12]];
    let mut equations = Roots { targets: [2.0, 9e16, 1e-23], slopes };
    solve(&mut equations, &mut unknowns, crate::scalar::Scalar::epsilon(), &mut work)?;
    Ok((unknowns[0], work))
}

#[test]
fn unknowns_of_all_scales_are_found_to_rounding() {
    for (slopes, iterations) in [([2.9, 5.5e8, 6e-12], 20), ([4.0, 8e8, 9e-12], 60)] {
        let (found, work) = roots(slopes).expect("converges");
        for (found, expected) in found.iter().zip([2.0_f64.sqrt(), 3e8, 1e-23_f64.sqrt()]) {
            assert!((found / expected - 1.0).abs() < 4e-16, "{found}");
        }
        assert!(work.iterations < iterations, "{work:?}");
    }
}

#[test]
fn divergence_is_reported() {
    assert!(matches!(roots([1.0, 6e8, 6e-12]), Err(StepFailure::NotConverged { .. })));
    assert_eq!(roots([-3.0, 6e8, 6e-12]).err(), roots([-3.0, 6e8, 6e-12]).err());
    assert!(matches!(
        roots([-3.0, 6e8, 6e-12]),
        Err(StepFailure::NotConverged { .. } | StepFailure::NotFinite)
    ));
}

/// The equations x = 1 + y/100, y = x/100, each of which waits for the other.
struct Turns;

impl Equations<f64, [f64; 2], 1> for Turns {
    fn residual(&mut self, [[x, y]]: &[[f64; 2]; 1], _work: &mut Work) -> [[f64; 2]; 1] {
        [[1.0 + 0.01 * y - x, 0.01 * x - y]]
    }

    fn correction(&self, residual: &[[f64; 2]; 1]) -> [[f64; 2]; 1] {
        *residual
    }

    fn magnitude(&self, _unknowns: &[[f64; 2]; 1]) -> [f64; 2] {
        [1.0; 2]
    }
}

#[test]
fn unknowns_that_change_in_turns_converge() {
    let mut unknowns = [[1.0, 0.0]];
    solve(&mut Turns, &mut unknowns, f64::EPSILON, &mut Work::default()).expect("converges");
    let [[x, y]] = unknowns;
    assert!((x - 1.0 / 0.9999).abs() < 3e-16 && (y - 0.01 / 0.9999).abs() < 3e-18, "{x} {y}");
}

#[test]
fn nan_is_reported() {
    assert_eq!(roots([f64::NAN, 6e8, 6e-12]).err(), Some(StepFailure::NotFinite));
}

#[test]
fn rounding_is_that_of_the_number_type() {
    assert_eq!(<f64 as crate::scalar::Scalar>::epsilon(), f64::EPSILON);
    assert_eq!(<f32 as crate::scalar::Scalar>::epsilon(), f32::EPSILON);
}
