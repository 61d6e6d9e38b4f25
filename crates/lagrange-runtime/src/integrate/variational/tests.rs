//! Order and structure of the variational integrator.

mod constrained;

use super::Variational;
use crate::integrate::doubles::canonical::checks::{
    canonical, check_order, defect_of_symplecticity, distance, reached,
};
use crate::integrate::doubles::canonical::{
    DoublePendulum, HeavyTop, Kepler, Lagrangian, ShakenPendulum, SpringPendulum, System, opaque, smooth,
};
use crate::integrate::{GaussLegendre6, Method, Stepper};
use crate::run::integrate;
use crate::system::StepFailure;

const PENDULUM: [f64; 4] = [0.8, 1.1, 0.5, -0.4];
const TOP: [f64; 6] = [0.1, 0.6, 0.0, 1.0, 0.2, 30.0];
const ORBIT: [f64; 4] = [0.7, 0.0, 0.0, 1.3 / 0.7];

#[test]
fn the_order_is_four() {
    check_order(&smooth(DoublePendulum), PENDULUM, 2.0, 100, |step| Variational { step });
    check_order(&smooth(HeavyTop), TOP, 1.0, 100, |step| Variational { step });
    check_order(&opaque(Kepler), ORBIT, 2.0, 100, |step| Variational { step });
}

#[test]
fn the_order_holds_where_the_lagrangian_depends_on_time() {
    let system = smooth(ShakenPendulum { amplitude: 0.3, frequency: 3.0 });
    check_order(&system, [1.0, 0.0], 4.0, 100, |step| Variational { step });
}

/// A pendulum in a fluid whose drag grows faster than the rate.
struct Damped;

impl Lagrangian<1> for Damped {
    type Number = f64;
    type State = [f64; 2];

    fn mass(&self, _q: &[f64; 1], _v: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }

    fn rates(&self, _t: f64, [angle]: &[f64; 1], [w]: &[f64; 1]) -> [f64; 1] {
        [-angle.sin() - 0.2 * w - 0.1 * w * w * w]
    }

    fn drift(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn potential(&self, [angle]: &[f64; 1]) -> f64 {
        -angle.cos()
    }
}

#[test]
fn the_order_holds_under_forces_that_do_work() {
    check_order(&smooth(Damped), [1.0, 0.5], 4.0, 100, |step| Variational { step });
}

#[test]
fn steps_are_symplectic_in_coordinates_and_momenta() {
    let pendulum =
        defect_of_symplecticity(&smooth(DoublePendulum), PENDULUM, 0.1, &Variational { step: 0.1 });
    let top = defect_of_symplecticity(&smooth(HeavyTop), TOP, 0.02, &Variational { step: 0.02 });
    assert!(pendulum < 1e-9 && top < 1e-9, "{pendulum:e} {top:e}");
}

#[test]
fn a_step_back_undoes_a_step() {
    let system = opaque(DoublePendulum);
    let there = reached(&system, 0.0, PENDULUM, 3.0, &Variational { step: 0.01 });
    let back = reached(&system, 3.0, there, 0.0, &Variational { step: 0.01 });
    assert!(distance(&there, &PENDULUM) > 0.1);
    assert!(distance(&back, &PENDULUM) < 1e-13, "{back:?}");
}

#[test]
fn momenta_of_cyclic_coordinates_are_kept() {
    let system = smooth(HeavyTop);
    let start = canonical(&system, 0.0, &TOP);
    let end = canonical(&system, 0.0, &reached(&system, 0.0, TOP, 20.0, &Variational { step: 0.01 }));
    for cyclic in [3, 5] {
        assert!((end[cyclic] - start[cyclic]).abs() < 4.0 * f64::EPSILON * start[cyclic].abs(), "{end:?}");
    }
}

#[test]
fn a_jacobian_saves_iterations() {
    let iterations = |system: System<DoublePendulum, 2>| {
        let mut stepper = Variational { step: 0.1 }.start(&system, 0.0, &PENDULUM, 10.0).expect("starts");
        while stepper.time() < 10.0 {
            stepper.step(&system, 10.0).expect("converges");
        }
        assert_eq!(stepper.work().steps, 100);
        stepper.work().iterations
    };
    let (known, unknown) = (iterations(smooth(DoublePendulum)), iterations(opaque(DoublePendulum)));
    assert!(known < unknown, "{known} {unknown}");
}

#[test]
fn single_precision_reaches_its_own_rounding() {
    let system = smooth(SpringPendulum { stiffness: 100.0_f32 });
    let end = integrate(&system, 0.0, [1.1, 0.4, 0.0, 0.0], 2.0, &Variational { step: 0.005 }, |_, _| {});
    let double = smooth(SpringPendulum { stiffness: 100.0_f64 });
    let start = [1.1_f32.into(), 0.4_f32.into(), 0.0, 0.0];
    let reference = reached(&double, 0.0, start, 2.0, &GaussLegendre6 { step: 0.005 });
    let end = end.expect("converges").map(f64::from);
    assert!(distance(&end, &reference) < 1e-5, "{end:?} {reference:?}");
}

#[test]
fn steps_that_do_not_resolve_a_vibration_are_refused() {
    let system = opaque(SpringPendulum { stiffness: 1e9 });
    let start = [1.0 + 1e-6, 0.5, 0.0, 0.0];
    let error =
        integrate(&system, 0.0, start, 1.0, &Variational { step: 0.01 }, |_, _| {}).expect_err("refused");
    assert!(matches!(error.cause, StepFailure::NotConverged { .. } | StepFailure::NotFinite), "{error}");
    assert!(error.time < 0.1 && error.state.iter().all(|entry: &f64| entry.is_finite()), "{error:?}");
}
