//! Inputs set during a run: by a continuous law, or by sampled controllers.

use std::f64::consts::PI;

use lagrange::Simulate;
use lagrange::contact::Contact;
use lagrange::integrate::{GaussLegendre4, RungeKutta4, SettingError, Verner98};
use lagrange::simulate::{Ending, Trajectory};
use lagrange::system::{ControlledSystem, OdeSystem};

use crate::references::{Numbers, state};

lagrange::system! {
    /// A cart that carries a pendulum, pushed by a force u; θ is measured from the lower position.
    #[derive(Clone, Debug)]
    struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, c = 0.01, g = 9.81;
    coord x, theta;
    input u;

    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;
    force x = u;
    output tip = (px, py);
    output height = py;
    emit { momentum_rates, jacobian }
}

lagrange::system! {
    /// Two links of 1 m with point masses at their ends, angles relative to each other, torques in
    /// the joints.
    #[derive(Clone, Debug)]
    struct Arm;

    param m1 = 1.5, m2 = 1.25, g = 9.81;
    coord q1, q2;
    input u1, u2;

    let p1 = (cos(q1), sin(q1));
    let p2 = p1 + (cos(q1 + q2), sin(q1 + q2));
    kinetic = kinetic_energy(m1, dot(p1)) + kinetic_energy(m2, dot(p2));
    potential = gravitational_energy(m1, g, p1.y) + gravitational_energy(m2, g, p2.y);
    force q1 = u1;
    force q2 = u2;
}

lagrange::system! {
    /// A mass between a spring, a damper and an actuator.
    #[derive(Clone, Debug)]
    struct Axis;

    param m = 2, c = 0.5, k = 10;
    coord x;
    input u;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = u;
}

/// Force on the cart per deviation of x, θ, ẋ, θ̇ from rest at the upright position.
const GAINS: [f64; 4] = [1.8, -30.8, 3.1, -6.3];

fn balance(_: &CartPole, _: f64, state: CartPoleState) -> CartPoleInputs {
    let CartPoleState { x, theta, x_dot, theta_dot } = state;
    let deviation = [x, theta - PI, x_dot, theta_dot];
    CartPoleInputs { u: GAINS.iter().zip(deviation).map(|(gain, deviation)| gain * deviation).sum() }
}

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], expected: [f64; N], tolerance: f64) {
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance, "{found} is not {expected}");
    }
}

const TILTED: [f64; 4] = [0.0, PI - 0.3, 0.0, 0.0];

#[test]
fn a_feedback_balances_the_cart_as_the_reference_does() {
    let expected = state("controlled_cart_pole", Numbers::Decimal, 10.0);
    let cart = CartPole::default();
    let run = cart.simulate(TILTED).until(10.0).drive(balance);
    assert_near(run.tolerance(1e-13).run().expect("balanced").last(), expected, 1e-12);
}

/// A law is part of the equations, so all methods agree.
#[test]
fn all_methods_that_take_forces_of_velocities_follow_a_law() {
    let expected = state("controlled_cart_pole", Numbers::Decimal, 10.0);
    let cart = CartPole::default();
    let run = || cart.simulate(TILTED).until(10.0).drive(balance).ends_only();
    let by_rk4 = run().method(RungeKutta4 { step: 1e-3 }).run().expect("balanced");
    assert_near(by_rk4.last(), expected, 1e-9);
    let by_gauss = run().method(GaussLegendre4 { step: 2e-3 }).run().expect("balanced");
    assert_near(by_gauss.last(), expected, 1e-9);
    // Newton's method knows the derivatives of the law: two or three iterations a step.
    let work = by_gauss.work();
    assert!(work.iterations < 4 * work.steps, "{work:?}");
}

#[test]
fn a_sampled_feedback_is_held_as_in_the_reference() {
    let expected = state("controlled_sampled_cart_pole", Numbers::Decimal, 5.0);
    let cart = CartPole::default();
    let run = || cart.simulate(TILTED).until(5.0).sampled(0.02, balance);
    assert_near(run().tolerance(1e-13).run().expect("balanced").last(), expected, 1e-12);
    // Steps of a fixed length are cut at the instants.
    let coarse = run().method(RungeKutta4 { step: 7e-3 }).run().expect("balanced").last();
    let fine = run().method(RungeKutta4 { step: 3.5e-3 }).run().expect("balanced").last();
    let errors = [coarse, fine].map(|end| (end[1] - expected[1]).abs());
    assert!(errors[0] < 1e-6 && errors[0] / errors[1] > 10.0, "{errors:?}");
}

#[test]
fn computed_torque_follows_a_path_with_a_wrong_load_as_the_reference_does() {
    let expected = state("controlled_arm", Numbers::Decimal, 5.0);
    let (arm, known) = (Arm::default(), Arm { m2: 1.0, ..Arm::default() });
    let torques = |_: &Arm, t: f64, ArmState { q1, q2, q1_dot, q2_dot }| {
        let path = [0.5 * t.sin(), 0.3 * (2.0 * t).cos()];
        let rate = [0.5 * t.cos(), -0.6 * (2.0 * t).sin()];
        let acceleration = [-0.5 * t.sin(), -1.2 * (2.0 * t).cos()];
        let (q, v) = ([q1, q2], [q1_dot, q2_dot]);
        let wanted = |i: usize| acceleration[i] + 16.0 * (rate[i] - v[i]) + 64.0 * (path[i] - q[i]);
        ArmInputs::from(known.inverse_dynamics(t, &q, &v, &[wanted(0), wanted(1)]))
    };
    let run = arm.simulate([0.0; 4]).until(5.0).drive(torques).tolerance(1e-13).run().expect("moves");
    assert_near(run.last(), expected, 1e-12);
}

/// A PID controller whose output saturates and whose integral waits while it does.
#[test]
fn a_sampled_controller_with_a_memory_and_saturation_agrees_with_the_reference() {
    let expected = state("controlled_pid", Numbers::Decimal, 6.0);
    let axis = Axis::default();
    let (mut integral, mut calls) = (0.0, 0);
    let pid = |_: &Axis, t: f64, AxisState { x, x_dot }| {
        assert!((t - 0.05 * f64::from(calls)).abs() < 1e-12, "once at each instant, in order");
        calls += 1;
        let deviation = 1.0 - x;
        let wanted = 40.0 * deviation + integral - 8.0 * x_dot;
        let force = f64::clamp(wanted, -15.0, 15.0);
        if force == wanted {
            integral += 60.0 * 0.05 * deviation;
        }
        AxisInputs { u: force }
    };
    let run = axis.simulate([0.0, 0.0]).until(6.0).sampled(0.05, pid).every(0.05).tolerance(1e-13);
    let motion = run.run().expect("moves");
    assert_near(motion.last(), expected, 1e-12);
    let forces = motion.column("u").expect("inputs are columns");
    assert_eq!((forces[0], forces.len()), (15.0, 121), "saturated at first");
    assert_eq!(forces[120], forces[119], "a controller is not asked at the end");
    assert_eq!(calls, 120);
}

lagrange::system! {
    /// A bead on a circle of 1 m, pushed, that ends at the level.
    #[derive(Clone, Debug)]
    struct Bead;

    param g = 9.81;
    coord x, y;
    input u;
    kinetic = kinetic_energy(2, dot((x, y)));
    potential = 2 * g * y;
    force x = u;
    constraint length = hypot(x, y) - 1;
    event level = y, rising => stop;
}

/// From rest at the bottom it is pushed in its direction of motion, always along the circle, up to
/// the level.
#[test]
fn constraints_and_stops_are_kept_under_control() {
    let bead = Bead::default();
    let push = |_: &Bead, _, state: BeadState| BeadInputs { u: 4.0 * state.x_dot };
    let run = || bead.simulate([0.0, -1.0, 1e-3, 0.0]).until(60.0).tolerance(1e-11);
    let by_law = run().drive(push).run().expect("stops");
    let by_samples = run().sampled(0.01, push).run().expect("stops");
    for motion in [&by_law, &by_samples] {
        assert_eq!((motion.ending(), motion.events()[0].name.as_str()), (Ending::Stopped, "level"));
        let [_, y, ..] = motion.last();
        assert!(y.abs() < 1e-12);
        for [x, y, x_dot, y_dot] in motion.states() {
            assert!((x.hypot(y) - 1.0).abs() < 1e-14 && (x * x_dot + y * y_dot).abs() < 1e-13);
        }
    }
    // The work of the law, 4 ẋ² dt, along its motion: φ̈ = 2 φ̇ cos² φ − g sin φ.
    let reference = pushed_angle(by_law.end_time());
    assert!((reference - PI / 2.0).abs() < 1e-8, "{reference} at {}", by_law.end_time());
}

/// Integrates the angle of the pushed bead separately.
fn pushed_angle(end: f64) -> f64 {
    struct Angle;
    impl OdeSystem for Angle {
        type Scalar = f64;
        type State = [f64; 2];
        fn rhs(&self, _: f64, [phi, rate]: &[f64; 2]) -> [f64; 2] {
            [*rate, 2.0 * rate * phi.cos().powi(2) - 9.81 * phi.sin()]
        }
    }
    let method = Verner98::tolerance(1e-12);
    let end = lagrange::integrate::integrate(&Angle, 0.0, [0.0, 1e-3], end, &method, |_, _| {});
    end.expect("smooth")[0]
}

lagrange::system! {
    /// A crate of 2 kg on a rough floor, pulled sideways and upwards, that ends at a wall.
    #[derive(Clone, Debug)]
    struct Crate;

    param mu = 0.5;
    coord x, y;
    input side, up;
    kinetic = kinetic_energy(2, dot((x, y)));
    potential = 2 * 10 * y;
    force x = side;
    force y = up;
    event floor = y, falling => impact(0);
    friction rub = dot(x), mu * floor;
    event wall = x - 5, rising => stop;
    event strong = up - 25, rising => record;
}

const RESTING: [f64; 4] = [0.0; 4];

/// µ N = 10 N at rest. A ramp of 2 t breaks loose at 5 s and slides with ẍ = (2 t − 10)/2.
#[test]
fn a_law_breaks_friction_loose() {
    let at_rest = Crate::default();
    let ramp = |_: &Crate, t: f64, _| CrateInputs { side: 2.0 * t, up: 0.0 };
    let motion = at_rest.simulate(RESTING).until(8.0).drive(ramp).tolerance(1e-12).run().expect("slides");
    let slipped = motion.events().iter().find(|event| event.name == "rub").expect("it slips");
    assert!((slipped.time - 5.0).abs() < 1e-10, "{}", slipped.time);
    assert!((motion.last()[0] - 3.0_f64.powi(3) / 6.0).abs() < 1e-10);
    assert_eq!(motion.system_at_end().map(|crate_| crate_.floor), Some(Contact::Closed));
    // The law is not part of the returned system.
    assert_eq!(motion.system_at_end().map(|crate_| crate_.side), Some(0.0));
}

/// Held forces: zero for a second; 16 N for a second, which slides with 3 m/s²; 30 N upwards, which
/// lifts with 5 m/s².
#[test]
fn contacts_and_friction_follow_held_inputs_that_jump() {
    let forces = |_: &Crate, t: f64, _: CrateState| match t.round() as u32 {
        0 => CrateInputs { side: 0.0, up: 0.0 },
        1 => CrateInputs { side: 16.0, up: 0.0 },
        _ => CrateInputs { side: 0.0, up: 30.0 },
    };
    let at_rest = Crate::default();
    let run = || at_rest.simulate(RESTING).until(3.0).sampled(1.0, forces).ends_only();
    for motion in [run().tolerance(1e-10).run(), run().method(RungeKutta4 { step: 0.015 }).run()] {
        let motion = motion.expect("moves");
        let names = motion.events().iter().map(|event| (event.name.as_str(), event.time)).collect::<Vec<_>>();
        let [("rub", slip), (first, lift), (second, strong)] = names[..] else { panic!("{names:?}") };
        assert!([first, second].contains(&"floor") && [first, second].contains(&"strong"), "{names:?}");
        assert!((slip - 1.0).abs() < 1e-12 && (lift - 2.0).abs() < 1e-12 && strong == lift, "{names:?}");
        assert_near(motion.last(), [1.5 + 3.0, 2.5, 3.0, 5.0], 1e-9);
        assert_eq!(motion.system_at_end().map(|crate_| crate_.floor), Some(Contact::Open));
    }
}

/// A law that adds to the existing inputs adds once, however often contacts switch the system.
#[test]
fn a_law_builds_on_the_inputs_that_were_set() {
    let pulled = Crate { side: 6.0, ..Crate::default() };
    let more = |plant: &Crate, t: f64, _| CrateInputs { side: plant.side + 2.0 * t, up: plant.up };
    let motion = pulled.simulate([0.0, 1.0, 0.0, 0.0]).until(4.0).drive(more).run().expect("moves");
    let column = motion.column("side").expect("a column for each input");
    for (time, side) in motion.times().iter().zip(column) {
        assert!((side - 6.0 - 2.0 * time).abs() < 1e-12);
    }
    assert!(motion.events().iter().any(|event| event.name == "floor"));
}

/// A slow controller provides the setpoint of a law.
#[test]
fn a_law_follows_what_a_sampled_controller_sets() {
    let axis = Axis::default();
    let setting = |_: &Axis, t: f64, _: AxisState| AxisInputs { u: if t < 1.5 { 1.0 } else { -1.0 } };
    let follow =
        |plant: &Axis, _, state: AxisState| AxisInputs { u: plant.u + 10.0 * state.x + 0.5 * state.x_dot };
    let run = axis.simulate([0.0, 0.0]).until(4.0).sampled(1.0, setting).drive(follow).tolerance(1e-12);
    // ẍ = ±1/2, reversed at 2 s.
    let motion = run.run().expect("moves");
    assert_near(motion.last(), [1.0 + 2.0 - 1.0, 0.0], 1e-10);
}

#[test]
fn controllers_act_in_order_each_at_its_instants() {
    let arm = Arm { g: 0.0, ..Arm::default() };
    let log = std::cell::RefCell::new(Vec::new());
    let fast = |plant: &Arm, t: f64, _: ArmState| {
        log.borrow_mut().push((1, (t * 10.0).round() / 10.0));
        ArmInputs { u1: t, ..plant.inputs() }
    };
    let slow = |plant: &Arm, t: f64, _: ArmState| {
        log.borrow_mut().push((2, (t * 10.0).round() / 10.0));
        ArmInputs { u2: plant.u1, ..plant.inputs() }
    };
    // 3 · 0.1 is not 0.3: instants that differ by rounding are equal.
    let run = arm.simulate([0.0; 4]).until(0.95).sampled(0.1, fast).sampled(0.3, slow).every_step();
    let motion = run.run().expect("moves");
    let mut expected = vec![(1, 0.0), (2, 0.0)];
    for k in 1..10 {
        expected.push((1, f64::from(k) / 10.0));
        expected.extend((k % 3 == 0).then(|| (2, f64::from(k) / 10.0)));
    }
    assert_eq!(log.take(), expected);
    let (u1, u2) = (motion.column("u1").expect("an input"), motion.column("u2").expect("an input"));
    assert!(u2.iter().zip(u1).all(|(slow, fast)| *slow <= *fast && *slow >= *fast - 0.31));
    assert!(motion.times().windows(2).all(|pair| pair[1] - pair[0] > 1e-12), "one sample an instant");
    let sparse = arm.simulate([0.0; 4]).until(3.0).sampled(0.1, fast).every(0.3).run().expect("moves");
    for (time, u1) in sparse.times().iter().zip(sparse.column("u1").expect("an input")).take(10) {
        assert!((time - u1).abs() < 1e-12, "{u1} at {time}: the new value");
    }
}

/// No instant is lost among restarts and declared jumps that nearly coincide.
#[test]
fn instants_go_with_restarts_and_jumps_at_the_same_times() {
    lagrange::system! {
        struct Pushed;
        param begin = 0.3;
        coord x;
        input u;
        kinetic = 1/2 * dot(x)^2;
        force x = u + if t < begin { 0 } else { 100 };
    }
    // 3 · 0.1 is not 0.3, and neither is the number between them.
    for begin in [0.3, 0.1 * 3.0, 0.300_000_000_000_000_1] {
        let pushed = Pushed { begin, ..Pushed::default() };
        let steps = |_: &Pushed, t: f64, _| PushedInputs { u: (10.0 * t).round() };
        let run = || pushed.simulate([0.0, 0.0]).until(1.0).sampled(0.1, steps);
        for motion in
            [run().run(), run().restart_at([0.3, 0.5]).run(), run().method(RungeKutta4 { step: 0.07 }).run()]
        {
            // Σ k 0.1 for k = 0 … 9, and 100 for 0.7 s.
            assert!((motion.expect("moves").last()[1] - 4.5 - 70.0).abs() < 1e-11);
        }
    }
}

/// A declared saturation is located, so that fixed steps keep their order.
#[test]
fn saturation_that_is_declared_is_located() {
    lagrange::system! {
        struct Limited;
        coord x;
        input u;
        kinetic = 1/2 * dot(x)^2;
        force x = max(-1, min(u, 1));
    }
    let limited = Limited::default();
    let law = |_: &Limited, _, state: LimitedState| LimitedInputs { u: -9.0 * state.x - state.x_dot };
    let run = || limited.simulate([2.0, 0.0]).until(6.0).drive(law);
    let expected = run().tolerance(1e-13).run().expect("moves").last();
    let error = |step| {
        let [x, v] = run().method(RungeKutta4 { step }).run().expect("moves").last();
        (x - expected[0]).abs().max((v - expected[1]).abs())
    };
    let (coarse, fine) = (error(0.1), error(0.05));
    assert!(coarse < 1e-3 && coarse / fine > 12.0, "{coarse} {fine}");
}

#[test]
fn observers_events_and_outputs_know_the_inputs_of_a_law() {
    let cart = CartPole::default();
    let run = cart.simulate(TILTED).until(2.0).drive(balance).outputs();
    let run = run.observe("push", |cart, _, _| cart.u).accelerations().every(0.25);
    let motion =
        run.event("idle", lagrange::event::Direction::Crossing, |cart, _, _| cart.u).run().expect("moves");
    assert_eq!(motion.column("push"), motion.column("u"));
    for (index, (t, y)) in motion.iter().enumerate() {
        let state = CartPoleState::from(y);
        let driven = cart.with_inputs(balance(&cart, t, state));
        let (q, v) = (state.coordinates(), state.velocities());
        let expected = [driven.tip(t, &q, &v)[0], driven.tip(t, &q, &v)[1], driven.height(t, &q, &v)];
        let named = |name: &str| motion.column(name).expect("a column")[index];
        assert_near([named("tip.x"), named("tip.y"), named("height")], expected, 1e-15);
        assert_near([named("x_ddot"), named("theta_ddot")], driven.acceleration(t, &q, &v), 1e-12);
    }
    let idle = motion.events().first().expect("the force changes its sign");
    assert!(balance(&cart, idle.time, CartPoleState::from(idle.state)).u.abs() < 1e-9);
}

#[test]
fn outputs_are_columns_by_name() {
    let cart = CartPole::default();
    let names = |motion: Trajectory<CartPole>| motion.names()[4..].to_vec();
    let run = || cart.simulate(TILTED).until(0.1).ends_only();
    assert_eq!(names(run().outputs().run().expect("moves")), ["tip.x", "tip.y", "height"]);
    assert_eq!(names(run().record("tip").run().expect("moves")), ["tip.x", "tip.y"]);
    assert_eq!(names(run().record("tip.y").record("height").run().expect("moves")), ["tip.y", "height"]);
    let error = run().record("ti").run().expect_err("no such output");
    assert_eq!(
        error.to_string(),
        "there is no output `ti`; there are `tip.x`, `tip.y`, `height` (at time 0.0)"
    );
}

#[test]
fn mistakes_of_a_control_are_named() {
    let cart = CartPole::default();
    let bad = |_: &CartPole, t: f64, _| CartPoleInputs { u: if t < 0.25 { 0.0 } else { f64::NAN } };
    let error = cart.simulate(TILTED).until(1.0).sampled(0.1, bad).run().expect_err("NaN");
    assert!(error.to_string().starts_with("the input `u` is NaN at time 0.30000000000000004"), "{error}");
    assert!((error.time() - 0.3).abs() < 1e-15);
    assert!(error.trajectory.iter().all(|(_, y)| y.iter().all(|entry| entry.is_finite())));
    let root = |_: &CartPole, _, state: CartPoleState| CartPoleInputs { u: (state.theta - 2.5).sqrt() };
    let error = cart.simulate(TILTED).until(10.0).drive(root).run().expect_err("NaN");
    assert!(error.to_string().starts_with("the input `u` is NaN at time "), "{error}");
    for period in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let error = cart.simulate(TILTED).until(1.0).sampled(period, balance).run().expect_err("no period");
        assert_eq!(
            error.cause,
            SettingError::Invalid("the sampling interval must be positive and finite").into()
        );
    }
}

#[test]
fn a_run_backwards_asks_controllers_backwards() {
    let axis = Axis { c: 0.0, k: 0.0, ..Axis::default() };
    let hold = |_: &Axis, t: f64, _: AxisState| AxisInputs { u: if t > 0.75 { 2.0 } else { -2.0 } };
    let motion = axis.simulate([0.0, 0.0]).from(1.5).until(0.0).sampled(0.5, hold).run().expect("moves");
    // From 1.5 to 0.5 s the force is 2 N, from there to 0 s −2 N.
    assert_near(motion.last(), [0.5 - 1.0 * -0.5 - 0.125, -0.5], 1e-12);
}

/// Reduced types and generic scalars have inputs, too.
#[test]
fn reduced_and_generic_systems_are_driven() {
    lagrange::system! {
        struct Crane<S>;
        param m = 2;
        coord x, theta;
        input u;
        kinetic = kinetic_energy(m, dot(x)) + kinetic_energy(1, dot((x + sin(theta), -cos(theta))));
        potential = -9.81 * cos(theta);
        force x = u;
        reduce Braked { freeze theta = 0; }
    }
    let braked = Braked::from(&Crane::<f32>::default());
    let push = |_: &Braked<f32>, _, state: BrakedState<f32>| BrakedInputs { u: -3.0 * state.x };
    let motion = braked.simulate([1.0, 0.0]).until(2.0).drive(push).run().expect("swings");
    assert!((motion.last()[0] - 2.0_f32.cos()).abs() < 1e-5);
}

/// Dense output covers driven motions.
#[test]
fn dense_motions_are_driven_within_steps() {
    let cart = CartPole::default();
    let run = cart.simulate(TILTED).until(3.0).drive(balance).dense().tolerance(1e-11);
    let motion = run.run().expect("moves");
    let exact =
        cart.simulate(TILTED).until(1.234).drive(balance).tolerance(1e-13).run().expect("moves").last();
    assert_near(motion.at(1.234).expect("kept"), exact, 1e-9);
}

/// Inputs that jump across several declared limits at once find each side.
#[test]
fn jumps_across_several_limits_find_all_sides() {
    lagrange::system! {
        struct Limited;
        coord x, y;
        input u, w;
        kinetic = kinetic_energy(1000, dot((x, y)));
        force x = max(-1000, min(u, 1000));
        force y = min(w, 1000);
    }
    let limited = Limited::default();
    let control = |_: &Limited, t: f64, _| match t < 0.5 {
        true => LimitedInputs { u: 5000.0, w: 0.0 },
        false => LimitedInputs { u: -5000.0, w: 5000.0 },
    };
    let run = || limited.simulate([0.0; 4]).until(2.0).sampled(1.0, control);
    for motion in [run().run(), run().method(RungeKutta4 { step: 0.3 }).run()] {
        let motion = motion.expect("moves");
        assert_near(motion.last(), [1.0, 0.5, 0.0, 1.0], 1e-12);
        assert!(motion.times().windows(2).all(|pair| pair[0] < pair[1]), "{:?}", motion.times());
    }
}

/// A limit keeps friction sticking where the input alone would break it loose.
#[test]
fn friction_feels_forces_on_the_right_side_of_their_limits() {
    lagrange::system! {
        struct Box;
        coord x, y;
        input side;
        kinetic = kinetic_energy(2, dot((x, y)));
        potential = 2 * 10 * y;
        force x = min(side, 8);
        event floor = y, falling => impact(0);
        friction rub = dot(x), 1/2 * floor;
    }
    let at_rest = Box::default();
    let push = |_: &Box, t: f64, _| BoxInputs { side: if t < 0.5 { 0.0 } else { 50.0 } };
    let motion = at_rest.simulate(RESTING).until(2.0).sampled(1.0, push).run().expect("stays");
    assert_near(motion.last(), RESTING, 1e-30);
    assert!(motion.events().is_empty(), "{:?}", motion.events());
}

/// A controller may evaluate the system for other inputs, beyond the limits of the present ones.
#[test]
fn controllers_see_a_system_with_its_sides_free() {
    lagrange::system! {
        struct Limited;
        coord x;
        input u;
        kinetic = 1/2 * dot(x)^2;
        force x = min(u, 10);
    }
    let limited = Limited::default();
    let tried = |plant: &Limited, t, state: LimitedState| {
        let strong = plant.with_inputs(LimitedInputs { u: 20.0 });
        let [acceleration] = strong.acceleration(t, &state.coordinates(), &state.velocities());
        LimitedInputs { u: acceleration - 8.0 }
    };
    let motion = limited.simulate([0.0; 2]).until(1.0).sampled(0.25, tried).run().expect("moves");
    assert!(motion.column("u").expect("an input").iter().all(|u| *u == 2.0));
}

/// An event caused by a jump of inputs occurs even if another event replaced the state at the same
/// instant.
#[test]
fn events_by_jumps_are_found_beside_others() {
    use lagrange::event::{Action, Direction};
    let axis = Axis::default();
    let jump = |_: &Axis, t: f64, _| AxisInputs { u: if t < 0.25 { 0.0 } else { 30.0 } };
    let run = axis.simulate([0.0; 2]).until(1.0).sampled(0.1, jump);
    let run =
        run.event_with("tick", Direction::Rising, |_, t, _| t - 0.3, |_, event| Action::Replace(event.state));
    let motion = run.event("strong", Direction::Rising, |axis, _, _| axis.u - 25.0).run().expect("moves");
    let mut names = motion.events().iter().map(|event| event.name.as_str()).collect::<Vec<_>>();
    names.sort_unstable();
    assert_eq!(names, ["strong", "tick"]);
}

/// A law may settle where its force has a kink.
#[test]
fn a_law_may_settle_on_a_kink() {
    lagrange::system! {
        struct Weaker;
        coord x;
        input u;
        kinetic = 1/2 * dot(x)^2;
        force x = if u > 0 { u } else { u / 2 };
    }
    let weaker = Weaker::default();
    let law =
        |_: &Weaker, _, state: WeakerState| WeakerInputs { u: -1e4 * (state.x - 1.0) - 200.0 * state.x_dot };
    let motion = weaker.simulate([0.0; 2]).until(1.0).drive(law).max_steps(20_000).run().expect("settles");
    assert_near(motion.last(), [1.0, 0.0], 1e-6);
}
