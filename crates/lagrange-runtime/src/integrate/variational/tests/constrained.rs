//! Order and structure with constraints.

use super::Variational;
use crate::integrate::doubles::canonical::checks::{distance, reached};
use crate::integrate::doubles::constrained::checks::{
    check_order, defect_of_symmetry, defect_of_symplecticity, residuals,
};
use crate::integrate::doubles::constrained::{
    Dragged, DrivenSlide, Pinned, PlanePendulum, Sleigh, SphericalPendulum, ThreeCranks, TurningWire,
    TwoRods, on_sphere,
};
use crate::integrate::{Method, Stepper};
use crate::run::integrate;
use crate::system::StepFailure;

const PENDULUM: [f64; 4] = [0.6, -0.8, 1.6, 1.2];
const SPHERICAL: [f64; 6] = [0.6, 0.0, -0.8, 0.4, 1.5, 0.3];
const RODS: [f64; 8] = [0.6, -0.8, 1.4, -1.4, 0.4, 0.3, 1.0, 1.1];
const SLEIGH: [f64; 6] = [0.1, 0.2, 0.5, 0.0, 0.0, 1.3];
const SPHERE: SphericalPendulum = SphericalPendulum { is_said_twice: false };

fn sleigh() -> [f64; 6] {
    let (s, c) = SLEIGH[2].sin_cos();
    [SLEIGH[0], SLEIGH[1], SLEIGH[2], 0.7 * c, 0.7 * s, SLEIGH[5]]
}

fn method(step: f64) -> Variational<f64> {
    Variational { step }
}

#[test]
fn the_order_is_four_under_constraints_on_positions() {
    check_order(&Pinned(PlanePendulum), PENDULUM, 2.0, 100, method);
    check_order(&Pinned(SPHERE), SPHERICAL, 2.0, 100, method);
    check_order(&Pinned(TwoRods), RODS, 1.0, 100, method);
}

#[test]
fn the_order_is_four_under_constraints_that_move() {
    check_order(&Pinned(TurningWire { rate: 1.5 }), [0.5, 0.0, 0.2, 0.75], 1.5, 40, method);
    check_order(&Pinned(DrivenSlide), [0.3, 0.0, 0.2, 1.0], 3.0, 40, method);
}

#[test]
fn the_order_is_four_under_constraints_on_velocities() {
    check_order(&Pinned(Sleigh { slope: 2.0 }), sleigh(), 2.0, 50, method);
    check_order(&Pinned(Dragged), [1.0, 0.0, 0.5, 0.4, 0.5, 0.4], 2.0, 50, method);
}

#[test]
fn a_bead_on_a_turning_wire_moves_as_a_hyperbolic_cosine() {
    let end = reached(&Pinned(TurningWire { rate: 1.5 }), 0.0, [0.5, 0.0, 0.0, 0.75], 1.0, &method(0.002));
    let (r, (s, c)) = (0.5 * 1.5_f64.cosh(), 1.5_f64.sin_cos());
    assert!((end[0] - r * c).abs() < 1e-11 && (end[1] - r * s).abs() < 1e-11, "{end:?}");
}

#[test]
fn constraints_hold_to_rounding() {
    let all = [
        residuals(&Pinned(PlanePendulum), PENDULUM, 10.0, &method(0.02)),
        residuals(&Pinned(SPHERE), SPHERICAL, 10.0, &method(0.02)),
        residuals(&Pinned(TwoRods), RODS, 10.0, &method(0.02)),
        residuals(&Pinned(Sleigh { slope: 2.0 }), sleigh(), 10.0, &method(0.02)),
        residuals(&Pinned(Dragged), [1.0, 0.0, 0.5, 0.4, 0.5, 0.4], 10.0, &method(0.02)),
        residuals(&Pinned(DrivenSlide), [0.3, 0.0, 0.2, 1.0], 10.0, &method(0.02)),
    ];
    for [positions, velocities] in all {
        assert!(positions < 2e-15 && velocities < 1e-14, "{positions:e} {velocities:e}");
    }
}

#[test]
fn a_step_back_undoes_a_step() {
    for defect in [
        defect_of_symmetry(&Pinned(PlanePendulum), PENDULUM, 3.0, &method(0.02)),
        defect_of_symmetry(&Pinned(SPHERE), SPHERICAL, 3.0, &method(0.02)),
        defect_of_symmetry(&Pinned(Sleigh { slope: 2.0 }), sleigh(), 3.0, &method(0.02)),
        defect_of_symmetry(&Pinned(TurningWire { rate: 1.5 }), [0.5, 0.0, 0.2, 0.75], 1.5, &method(0.02)),
    ] {
        assert!(defect < 1e-12, "{defect:e}");
    }
}

#[test]
fn steps_are_symplectic_on_the_constraints() {
    let defect = defect_of_symplecticity(&Pinned(SPHERE), on_sphere, [0.4, 0.7, 1.1, 0.5], 0.1, &method(0.1));
    assert!(defect < 1e-9, "{defect:e}");
}

#[test]
fn angular_momentum_about_the_vertical_is_kept() {
    let end = reached(&Pinned(SPHERE), 0.0, SPHERICAL, 20.0, &method(0.02));
    let momentum = |y: &[f64; 6]| y[0] * y[4] - y[1] * y[3];
    assert!((momentum(&end) - momentum(&SPHERICAL)).abs() < 1e-14, "{end:?}");
}

#[test]
fn a_repeated_constraint_holds_once() {
    let once = reached(&Pinned(SPHERE), 0.0, SPHERICAL, 2.0, &method(0.02));
    let twice = SphericalPendulum { is_said_twice: true };
    let twice = reached(&Pinned(twice), 0.0, SPHERICAL, 2.0, &method(0.02));
    assert!(distance(&once, &twice) < 1e-13, "{once:?} {twice:?}");
}

#[test]
fn few_iterations_take_a_step() {
    let mut stepper = method(0.02).start(&Pinned(PlanePendulum), 0.0, &PENDULUM, 10.0).expect("starts");
    while stepper.time() < 10.0 {
        stepper.step(&Pinned(PlanePendulum), 10.0).expect("converges");
    }
    let work = stepper.work();
    assert!(work.iterations <= 8 * work.steps, "{work:?}");
}

#[test]
fn a_pendulum_at_rest_stays_at_rest() {
    let rest = [0.0, -1.0, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0];
    let end = reached(&Pinned(TwoRods), 0.0, rest, 10.0, &method(0.1));
    assert!(distance(&end, &rest) < 1e-15, "{end:?}");
}

#[test]
fn steps_that_lose_their_way_leave_the_last_state() {
    let fast = PENDULUM.map(|entry| if entry.abs() > 1.0 { 50.0 * entry } else { entry });
    let error =
        integrate(&Pinned(PlanePendulum), 0.0, fast, 1.0, &method(0.5), |_, _| {}).expect_err("refused");
    assert!(matches!(error.cause, StepFailure::NotConverged { .. } | StepFailure::NotFinite), "{error}");
    assert_eq!((error.time, error.state), (0.0, fast));
}

/// Every crank rotates like a pendulum; when it is aligned with the bar, all constraints coincide.
#[test]
fn dependent_constraints_and_dead_points_do_not_matter() {
    let end = reached(&Pinned(ThreeCranks), 0.0, [0.0, -1.0, 0.0, 7.0, 0.0, 0.0], 4.0, &method(0.02));
    let pendulum = reached(&Pinned(PlanePendulum), 0.0, [0.0, -1.0, 7.0, 0.0], 4.0, &method(0.02));
    let found = [end[0], end[1], end[3], end[4]];
    assert!(distance(&found, &pendulum) < 1e-12, "{end:?} {pendulum:?}");
    assert!(end[2].abs() < 1e-13 && end[5].abs() < 1e-13, "{end:?}");
}
