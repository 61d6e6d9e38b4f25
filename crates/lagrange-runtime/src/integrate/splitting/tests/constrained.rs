//! Constraints on positions.

use super::run;
use crate::integrate::doubles::canonical::checks::distance;
use crate::integrate::doubles::constrained::checks::{
    check_order, defect_of_symmetry, defect_of_symplecticity, residuals,
};
use crate::integrate::doubles::constrained::{
    Pinned, PlanePendulum, SphericalPendulum, TurningWire, TwoRods, on_sphere,
};
use crate::integrate::{Method, Stepper, StormerVerlet, SymplecticEuler};

const PENDULUM: [f64; 4] = [0.6, -0.8, 1.6, 1.2];
const SPHERICAL: [f64; 6] = [0.6, 0.0, -0.8, 0.4, 1.5, 0.3];
const RODS: [f64; 8] = [0.6, -0.8, 1.4, -1.4, 0.4, 0.3, 1.0, 1.1];
const WIRE: [f64; 4] = [0.5, 0.0, 0.2, 0.75];
const SPHERE: Pinned<SphericalPendulum, 3> = Pinned(SphericalPendulum { is_said_twice: false });

fn verlet(step: f64) -> StormerVerlet<f64> {
    StormerVerlet { step }
}

fn euler(step: f64) -> SymplecticEuler<f64> {
    SymplecticEuler { step }
}

#[test]
fn half_kicks_have_order_two() {
    check_order(&Pinned(PlanePendulum), PENDULUM, 2.0, 400, verlet);
    check_order(&SPHERE, SPHERICAL, 2.0, 400, verlet);
    check_order(&Pinned(TwoRods), RODS, 1.0, 400, verlet);
    check_order(&Pinned(TurningWire { rate: 1.5 }), WIRE, 1.5, 100, verlet);
}

#[test]
fn one_kick_has_order_one() {
    check_order(&Pinned(PlanePendulum), PENDULUM, 1.0, 800, euler);
    check_order(&SPHERE, SPHERICAL, 1.0, 800, euler);
}

#[test]
fn constraints_hold_to_rounding() {
    for [positions, velocities] in [
        residuals(&Pinned(PlanePendulum), PENDULUM, 10.0, &verlet(0.01)),
        residuals(&SPHERE, SPHERICAL, 10.0, &verlet(0.01)),
        residuals(&Pinned(TwoRods), RODS, 10.0, &verlet(0.01)),
        residuals(&Pinned(PlanePendulum), PENDULUM, 10.0, &euler(0.01)),
    ] {
        assert!(positions < 2e-15 && velocities < 1e-14, "{positions:e} {velocities:e}");
    }
}

#[test]
fn a_step_back_undoes_a_step() {
    for defect in [
        defect_of_symmetry(&Pinned(PlanePendulum), PENDULUM, 3.0, &verlet(0.01)),
        defect_of_symmetry(&SPHERE, SPHERICAL, 3.0, &verlet(0.01)),
        defect_of_symmetry(&Pinned(TurningWire { rate: 1.5 }), WIRE, 1.5, &verlet(0.01)),
    ] {
        assert!(defect < 1e-12, "{defect:e}");
    }
}

#[test]
fn steps_are_symplectic_on_the_constraints() {
    for defect in [
        defect_of_symplecticity(&SPHERE, on_sphere, [0.4, 0.7, 1.1, 0.5], 0.05, &verlet(0.05)),
        defect_of_symplecticity(&SPHERE, on_sphere, [0.4, 0.7, 1.1, 0.5], 0.05, &euler(0.05)),
    ] {
        assert!(defect < 1e-9, "{defect:e}");
    }
}

#[test]
fn angular_momentum_about_the_vertical_is_kept() {
    let momentum = |y: &[f64; 6]| y[0] * y[4] - y[1] * y[3];
    for end in [run(&SPHERE, SPHERICAL, 20.0, &verlet(0.01)), run(&SPHERE, SPHERICAL, 20.0, &euler(0.01))] {
        assert!((momentum(&end) - momentum(&SPHERICAL)).abs() < 1e-14, "{end:?}");
    }
}

#[test]
fn a_repeated_constraint_holds_once() {
    let once = run(&SPHERE, SPHERICAL, 2.0, &verlet(0.01));
    let twice = run(&Pinned(SphericalPendulum { is_said_twice: true }), SPHERICAL, 2.0, &verlet(0.01));
    assert!(distance(&once, &twice) < 1e-12, "{once:?} {twice:?}");
}

#[test]
fn few_iterations_take_a_step() {
    let mut stepper = verlet(0.01).start(&Pinned(PlanePendulum), 0.0, &PENDULUM, 10.0).expect("starts");
    while stepper.time() < 10.0 {
        stepper.step(&Pinned(PlanePendulum), 10.0).expect("converges");
    }
    let work = stepper.work();
    assert!(work.iterations <= 12 * work.steps, "{work:?}");
}
