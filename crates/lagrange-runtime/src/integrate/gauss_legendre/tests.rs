//! Order, structure and limits of the Gauss methods.

use std::string::ToString;
use std::vec::Vec;

use super::{GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
use crate::integrate::doubles::canonical::checks::{
    canonical, check_order, defect_of_symplecticity, distance, reached,
};
use crate::integrate::doubles::canonical::{
    DoublePendulum, HeavyTop, Kepler, Lagrangian, ShakenPendulum, SpringPendulum, System, opaque, smooth,
};
use crate::integrate::doubles::constrained::{Pinned, PlanePendulum, checks as constrained};
use crate::integrate::{Method, RungeKutta4, Stepper};
use crate::run::integrate;
use crate::system::{EnergyFunction, StepFailure};

/// Starts of three systems whose mass matrices depend on the coordinates.
const PENDULUM: [f64; 4] = [0.8, 1.1, 0.5, -0.4];
const TOP: [f64; 6] = [0.1, 0.6, 0.0, 1.0, 0.2, 30.0];
const ORBIT: [f64; 4] = [0.7, 0.0, 0.0, 1.3 / 0.7];

#[test]
fn the_order_of_the_midpoint_rule_is_two() {
    let method = |step| ImplicitMidpoint { step };
    check_order(&smooth(DoublePendulum), PENDULUM, 2.0, 400, method);
    check_order(&smooth(HeavyTop), TOP, 1.0, 400, method);
    check_order(&opaque(Kepler), ORBIT, 2.0, 400, method);
}

#[test]
fn the_order_of_two_stages_is_four() {
    let method = |step| GaussLegendre4 { step };
    check_order(&smooth(DoublePendulum), PENDULUM, 2.0, 100, method);
    check_order(&smooth(HeavyTop), TOP, 1.0, 100, method);
    check_order(&opaque(Kepler), ORBIT, 2.0, 100, method);
}

#[test]
fn the_order_of_three_stages_is_six() {
    let method = |step| GaussLegendre6 { step };
    check_order(&smooth(DoublePendulum), PENDULUM, 2.0, 50, method);
    check_order(&smooth(HeavyTop), TOP, 1.0, 50, method);
    check_order(&opaque(Kepler), ORBIT, 2.0, 40, method);
}

/// Multipliers are functions of the state, like any force.
#[test]
fn constraint_forces_leave_the_order() {
    let (start, end) = ([0.6, -0.8, 1.6, 1.2], 2.0);
    constrained::check_order(&Pinned(PlanePendulum), start, end, 400, |step| ImplicitMidpoint { step });
    constrained::check_order(&Pinned(PlanePendulum), start, end, 100, |step| GaussLegendre4 { step });
    constrained::check_order(&Pinned(PlanePendulum), start, end, 40, |step| GaussLegendre6 { step });
}

#[test]
fn steps_are_symplectic_in_coordinates_and_momenta() {
    let (pendulum, top) = (smooth(DoublePendulum), smooth(HeavyTop));
    let defects = [
        defect_of_symplecticity(&pendulum, PENDULUM, 0.1, &ImplicitMidpoint { step: 0.1 }),
        defect_of_symplecticity(&pendulum, PENDULUM, 0.1, &GaussLegendre4 { step: 0.1 }),
        defect_of_symplecticity(&pendulum, PENDULUM, 0.1, &GaussLegendre6 { step: 0.1 }),
        defect_of_symplecticity(&top, TOP, 0.02, &ImplicitMidpoint { step: 0.02 }),
        defect_of_symplecticity(&top, TOP, 0.02, &GaussLegendre4 { step: 0.02 }),
        defect_of_symplecticity(&top, TOP, 0.02, &GaussLegendre6 { step: 0.02 }),
    ];
    assert!(defects.iter().all(|defect| *defect < 1e-9), "{defects:?}");
}

#[test]
fn steps_of_the_state_are_not_symplectic_where_the_mass_matrix_changes() {
    let pendulum = smooth(DoublePendulum);
    let defects = [
        defect_of_symplecticity(&pendulum, PENDULUM, 0.1, &ImplicitMidpoint { step: 0.1 }.plain()),
        defect_of_symplecticity(&pendulum, PENDULUM, 0.1, &GaussLegendre4 { step: 0.1 }.plain()),
        defect_of_symplecticity(&pendulum, PENDULUM, 0.1, &RungeKutta4 { step: 0.1 }),
    ];
    assert!(defects.iter().all(|defect| *defect > 1e-6), "{defects:?}");
}

#[test]
fn the_orders_hold_for_the_state_itself() {
    let pendulum = smooth(DoublePendulum);
    check_order(&pendulum, PENDULUM, 2.0, 400, |step| ImplicitMidpoint { step }.plain());
    check_order(&pendulum, PENDULUM, 2.0, 100, |step| GaussLegendre4 { step }.plain());
    check_order(&opaque(DoublePendulum), PENDULUM, 2.0, 80, |step| GaussLegendre6 { step }.plain());
}

#[test]
fn a_step_back_undoes_a_step() {
    let system = smooth(DoublePendulum);
    let there = reached(&system, 0.0, PENDULUM, 3.0, &GaussLegendre4 { step: 0.01 });
    let back = reached(&system, 3.0, there, 0.0, &GaussLegendre4 { step: 0.01 });
    assert!(distance(&there, &PENDULUM) > 0.1);
    assert!(distance(&back, &PENDULUM) < 1e-13, "{back:?}");
}

#[test]
fn momenta_of_cyclic_coordinates_are_kept() {
    let system = smooth(HeavyTop);
    let start = canonical(&system, 0.0, &TOP);
    let end = canonical(&system, 0.0, &reached(&system, 0.0, TOP, 20.0, &GaussLegendre6 { step: 0.01 }));
    for cyclic in [3, 5] {
        assert!((end[cyclic] - start[cyclic]).abs() < 4.0 * f64::EPSILON * start[cyclic].abs(), "{end:?}");
    }
}

#[test]
fn stiff_springs_neither_limit_steps_nor_disturb_slow_motion() {
    // A step spans about eighty periods of the spring, whose initial length balances the weight.
    let system = smooth(SpringPendulum { stiffness: 1e9 });
    let start = [1.0 + 9.81 * 0.5_f64.cos() / 1e9, 0.5, 0.0, 0.0];
    let end = reached(&system, 0.0, start, 10.0, &GaussLegendre6 { step: 0.016 });
    // A rod in place of the spring, in time units with a gravity of one.
    let unit = 9.81_f64.sqrt();
    let rod = smooth(ShakenPendulum { amplitude: 0.0, frequency: 0.0 });
    let [angle, rate] = reached(&rod, 0.0, [0.5, 0.0], 10.0 * unit, &GaussLegendre6 { step: 0.01 });
    assert!(distance(&end, &[1.0, angle, 0.0, rate * unit]) < 1e-6, "{end:?} {angle} {rate}");
    let energy = |y: [f64; 4]| system.energy(0.0, &[y[0], y[1]], &[y[2], y[3]]);
    assert!((energy(end) - energy(start)).abs() < 1e-7, "{:e}", energy(end) - energy(start));
}

#[test]
fn an_almost_upright_pendulum_falls_in_time() {
    // The quarter period is K(cos δ/2) = ln(4/sin(δ/2)) up to terms in δ², at the angle π − δ. The
    // rounding error of angles near π, 4e-16, grows in proportion to δ in this time, by nine powers
    // of ten.
    let angle = core::f64::consts::PI - 1e-9;
    let delta = (core::f64::consts::PI - angle) + 1.224_646_799_147_353e-16;
    let quarter = (4.0 / (delta / 2.0).sin()).ln();
    let rod = smooth(ShakenPendulum { amplitude: 0.0, frequency: 0.0 });
    let [angle, rate] = reached(&rod, 0.0, [angle, 0.0], quarter, &GaussLegendre6 { step: 0.02 });
    assert!(angle.abs() < 4e-6 && (rate + 2.0).abs() < 1e-10, "{angle:e} {rate}");
}

/// A mass that falls to a place where its force is undefined.
struct Edge;

impl Lagrangian<1> for Edge {
    type Number = f64;
    type State = [f64; 2];

    fn mass(&self, _q: &[f64; 1], _v: &[f64; 1]) -> [[f64; 1]; 1] {
        [[1.0]]
    }

    fn rates(&self, _t: f64, [x]: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [-1.0 - x.sqrt()]
    }

    fn drift(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn potential(&self, _q: &[f64; 1]) -> f64 {
        0.0
    }
}

#[test]
fn nan_stops_at_the_last_good_state() {
    for system in [smooth(Edge), opaque(Edge)] {
        let mut last = (0.0, [0.0; 2]);
        let method = GaussLegendre4 { step: 0.01 };
        let error =
            integrate(&system, 0.0, [1.0, 0.0], 9.0, &method, |t, y| last = (t, *y)).expect_err("stops");
        assert_eq!((error.time, error.state), last);
        let what = error.cause.to_string();
        assert!(
            what.starts_with("the acceleration `x_ddot` is NaN at time ") || what.contains("index 1"),
            "{what}"
        );
        assert!(error.time > 0.5 && error.state[0] > 0.0, "{error:?}");
    }
}

#[test]
fn a_singular_mass_matrix_is_named() {
    let system = opaque(SpringPendulum { stiffness: 10.0 });
    let start = [0.0, 0.3, 0.0, 0.0];
    let error =
        integrate(&system, 0.0, start, 1.0, &GaussLegendre4 { step: 0.01 }, |_, _| {}).expect_err("stops");
    assert_eq!((error.cause, error.time, error.state), (StepFailure::SingularMassMatrix, 0.0, start));
}

#[test]
fn without_a_jacobian_difference_quotients_take_stiff_springs() {
    let (start, method) = ([1.0 + 1e-6, 0.5, 0.0, 0.0], GaussLegendre4 { step: 0.01 });
    let unknown = reached(&opaque(SpringPendulum { stiffness: 1e9 }), 0.0, start, 1.0, &method);
    let known = reached(&smooth(SpringPendulum { stiffness: 1e9 }), 0.0, start, 1.0, &method);
    assert!(distance(&unknown[..2], &known[..2]) < 1e-7, "{unknown:?} {known:?}");
}

#[test]
fn single_precision_reaches_its_own_rounding() {
    let system = smooth(SpringPendulum { stiffness: 100.0_f32 });
    let end = integrate(&system, 0.0, [1.1, 0.4, 0.0, 0.0], 2.0, &GaussLegendre6 { step: 0.02 }, |_, _| {});
    let double = smooth(SpringPendulum { stiffness: 100.0_f64 });
    let start = [1.1_f32.into(), 0.4_f32.into(), 0.0, 0.0];
    let reference = reached(&double, 0.0, start, 2.0, &GaussLegendre6 { step: 0.02 });
    let end = end.expect("converges").map(f64::from);
    assert!(distance(&end, &reference) < 1e-5, "{end:?} {reference:?}");
}

#[test]
fn a_pendulum_shaken_a_thousand_times_a_second_stands_on_its_head() {
    let system = smooth(ShakenPendulum { amplitude: 1e-3, frequency: 2000.0 * core::f64::consts::PI });
    // It oscillates about the upright position with the frequency √(a²Ω²/2 − 1) of the averaged
    // motion, here 4.3.
    let (mut least, mut most) = (f64::INFINITY, f64::NEG_INFINITY);
    integrate(&system, 0.0, [3.0, 0.0], 2.0, &GaussLegendre4 { step: 1e-4 }, |_, [angle, _]| {
        (least, most) = (least.min(*angle), most.max(*angle));
    })
    .expect("converges");
    let reach = core::f64::consts::PI - 3.0;
    assert!((core::f64::consts::PI - least - reach).abs() < 0.01 * reach, "{least}");
    assert!((most - core::f64::consts::PI - reach).abs() < 0.01 * reach, "{most}");
}

/// Returns the order of the error at three tenths of a first step of length `h`.
fn order_within(h: f64, method: impl Fn(f64) -> Vec<f64>) -> f64 {
    let error = |h: f64| {
        let fine = GaussLegendre6 { step: h / 200.0 };
        distance(&method(h), &reached(&smooth(DoublePendulum), 0.0, PENDULUM, 0.3 * h, &fine))
    };
    (error(h) / error(h / 2.0)).log2()
}

/// Returns the state at three tenths of a first step.
fn within(method: &impl Method<System<DoublePendulum, 2>>, h: f64) -> Vec<f64> {
    let system = smooth(DoublePendulum);
    let mut stepper = method.start(&system, 0.0, &PENDULUM, 10.0).expect("starts");
    stepper.step(&system, 10.0).expect("converges");
    stepper.interpolate(&system, 0.3 * h).to_vec()
}

#[test]
fn states_within_a_step_have_the_order_of_the_method() {
    let orders = [
        order_within(0.01, |step| within(&ImplicitMidpoint { step }, step)),
        order_within(0.01, |step| within(&GaussLegendre4 { step }, step)),
        order_within(0.05, |step| within(&GaussLegendre6 { step }, step)),
    ];
    let plain = [
        order_within(0.01, |step| within(&ImplicitMidpoint { step }.plain(), step)),
        order_within(0.01, |step| within(&GaussLegendre4 { step }.plain(), step)),
        order_within(0.05, |step| within(&GaussLegendre6 { step }.plain(), step)),
    ];
    for (observed, order) in orders.iter().chain(&plain).zip([2.0, 4.0, 6.0, 2.0, 4.0, 5.0]) {
        assert!(*observed > order - 0.1, "{orders:?} {plain:?}");
    }
}
