//! First-order states of emitted systems: names, runs, events, kinks and reductions, beside
//! constraints and contacts.

use lagrange::Simulate;
use lagrange::integrate::{GaussLegendre, RungeKutta4, Verner98};
use lagrange::system::{
    ControlledSystem, Equations, KernelSystem, LanesSystem, MechanicalSystem, NamedSystem, OdeSystem,
};

use crate::assert_close;

lagrange::system! {
    /// A wheel on a motor with inductance, and the integral of its position.
    #[derive(Clone, Debug)]
    struct Servo;

    param j = 0.5, k = 0.3, r = 1.5, inductance = 0.05, hold = 2;
    /// States come after coordinates, wherever they are declared.
    state current, integral;
    coord theta;
    input voltage;
    kinetic = 1/2 * j * dot(theta)^2;
    potential = 1/2 * k * theta^2;
    force theta = k * current;
    dot(current) = (voltage - r * current - k * dot(theta)) / inductance;
    dot(integral) = theta;
    output power = voltage * current;
    emit { jacobian, prepared, lanes, kernel }
    /// The servo under a constant current.
    reduce Held { freeze current = hold; }
}

lagrange::system! {
    /// A heater that switches off at its limit, beside a mass at rest.
    struct Heater<S>;

    param limit = 2, loss = 0.5;
    coord x;
    input power = 3;
    state heat, warmth;
    kinetic = 1/2 * dot(x)^2;
    dot(heat) = power - loss * heat;
    dot(warmth) = max(heat - 1, 0);
    event off = heat - limit, rising => { heat = heat / 2; }
}

lagrange::system! {
    /// Three masses, each with a state that follows the next one.
    struct Ring;

    const n = 3;
    coord x[n];
    state memory[n];
    for i in 0..n {
        kinetic = 1/2 * dot(x[i])^2;
        potential = 1/2 * x[i]^2;
        dot(memory[i]) = x[(i + 1) % n] - (i + 1) * memory[i];
        force x[i] = memory[i];
    }
}

lagrange::system! {
    /// A pendulum in Cartesian coordinates, whose joint warms up.
    struct Rod;

    param g = 9.81;
    coord x, y;
    state heat;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint length = x^2 + y^2 - 1;
    dot(heat) = dot(x)^2 + dot(y)^2;
    force x = -heat / 100 * dot(x);
}

lagrange::system! {
    /// A bouncing ball, and the distance that it has travelled.
    struct Ball;

    param g = 9.81;
    coord y;
    state way;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event floor = y, falling => impact(0.5);
    dot(way) = abs(dot(y));
}

lagrange::system! {
    /// A sledge with a brake that is pressed harder and harder.
    struct Sledge;

    coord x;
    state pressure;
    kinetic = 1/2 * dot(x)^2;
    dot(pressure) = 2;
    friction brake = dot(x), pressure;
}

lagrange::system! {
    /// A square root whose domain ends.
    struct Ending;

    coord x;
    state s;
    kinetic = 1/2 * dot(x)^2;
    dot(s) = sqrt(x);
}

#[test]
fn states_stand_between_coordinates_and_velocities() {
    assert_eq!(Servo::COORDINATES, ["theta", "current", "integral"]);
    assert_eq!((Servo::VELOCITIES, Servo::RATES_OF), (&["theta_dot"][..], &["theta"][..]));
    let state = ServoState { theta: 1.0, current: 2.0, integral: 3.0, theta_dot: 4.0 };
    assert_eq!(<[f64; 4]>::from(state), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!((state.coordinates(), state.velocities()), ([1.0, 2.0, 3.0], [4.0]));
    let servo = Servo { voltage: 6.0, ..Servo::default() };
    let current_dot = (6.0 - 1.5 * 2.0 - 0.3 * 4.0) / 0.05;
    for (found, expected) in servo.rhs(0.0, &state.into()).into_iter().zip([4.0, current_dot, 1.0, 0.6]) {
        assert_close(found, expected);
    }
    assert_close(servo.power(0.0, &state.coordinates(), &[4.0]), 12.0);
    let named: <Servo as NamedSystem>::NamedState = [1.0, 2.0, 3.0, 4.0].into();
    assert_eq!(named, state);
}

#[test]
fn displacements_leave_states_as_they_are() {
    let (servo, q) = (Servo::default(), [1.0, 2.0, 3.0]);
    assert_eq!(servo.position_change(0.0, &q, &[0.5]), [0.5, 0.0, 0.0]);
    assert_eq!(servo.displacement(0.0, &q, &[1.5, 7.0, 8.0]), [0.5]);
}

#[test]
fn columns_have_the_names_of_states() {
    let run = Servo::default().simulate([0.0, 1.0, 0.0, 0.0]).until(0.5).outputs().run().expect("runs");
    assert_eq!(run.names(), ["theta", "current", "integral", "theta_dot", "power"]);
    assert_eq!(run.column("integral"), Some(run.integral()));
    assert_eq!(run.current()[0], 1.0);
    let ring = Ring.simulate([0.5; 9]).until(1.0).run().expect("runs");
    assert_eq!(ring.column("memory[2]"), Some(ring.memory(2)));
    assert_eq!(Ring::COORDINATES, ["x[0]", "x[1]", "x[2]", "memory[0]", "memory[1]", "memory[2]"]);
    let rates = Ring.rhs(0.0, &[1.0, 2.0, 3.0, 0.5, 0.25, 0.125, 0.0, 0.0, 0.0]);
    assert_eq!(rates[3..], [1.5, 2.5, 0.625, -0.5, -1.75, -2.875]);
}

/// A wheel held fixed: i(t) = u/r (1 − e^(−r t/L)).
#[test]
fn a_current_rises_as_that_of_a_coil() {
    let held = Servo { j: 1e300, k: 0.0, ..Servo::default() };
    let exact = |t: f64| 6.0 / 1.5 * -(-1.5 * t / 0.05_f64).exp_m1();
    let drive = |_: &Servo, _, _| ServoInputs { voltage: 6.0 };
    let start = [0.25, 0.0, 0.0, 0.0];
    let driven = held.simulate(start).until(0.1).drive(drive).tolerance(1e-13).run().expect("runs");
    let sampled = held.simulate(start).until(0.1).sampled(0.01, drive).tolerance(1e-13).run().expect("runs");
    for run in [driven, sampled] {
        let [_, current, integral, _] = run.last();
        assert!((current - exact(0.1)).abs() < 1e-11 && (integral - 0.025).abs() < 1e-14, "{current}");
        assert_eq!(run.column("voltage").and_then(<[f64]>::last), Some(&6.0));
    }
}

#[test]
fn implicit_methods_know_the_derivatives_of_states() {
    let servo = Servo { voltage: 6.0, inductance: 1e-4, ..Servo::default() };
    let start = [0.1, 0.0, 0.0, 0.0];
    let exact = servo.simulate(start).until(2.0).method(Verner98::tolerance(1e-12)).run().expect("runs");
    let method = GaussLegendre::<_, 3> { step: 0.01 }.plain();
    let implicit = servo.simulate(start).until(2.0).method(method).run().expect("runs");
    for (found, expected) in implicit.last().iter().zip(exact.last()) {
        assert!((found - expected).abs() < 1e-6, "{found} {expected}");
    }
    let y = [0.3, 0.5, 0.7, -0.2];
    let (jacobian, by_fields) = (servo.jacobian(0.0, &y), servo.parameter_jacobian(0.0, &y));
    assert_close(jacobian[1][3], -0.3 / 1e-4);
    assert_close(jacobian[3][1], 0.3 / 0.5);
    assert_eq!(jacobian[2], [1.0, 0.0, 0.0, 0.0]);
    let voltage = Servo::PARAMETERS.iter().position(|name| *name == "voltage").expect("an input");
    assert_close(by_fields[1][voltage], 1.0 / 1e-4);
}

#[test]
fn prepared_systems_and_those_side_by_side_have_the_same_rates() {
    let servo = Servo { voltage: 6.0, ..Servo::default() };
    let (lanes, prepared) = (servo.lanes(|parameter| parameter), servo.prepared());
    for index in 0..50 {
        let y = [0.1, 0.37, -0.7, 1.3].map(|scale| f64::from(index) * scale);
        let expected = servo.rhs(0.5, &y);
        assert_eq!(lanes.rhs(0.5, &y), expected);
        for (found, expected) in prepared.rhs(0.5, &y).into_iter().zip(expected) {
            assert_close(found, expected);
        }
    }
    assert_eq!(<Servo as KernelSystem>::PARAMETERS.len(), 6);
    assert!(Servo::KERNEL_F64.contains("#define LAGRANGE_POSITIONS 3\n#define LAGRANGE_VELOCITIES 1"));
}

/// heat(t) = p/l + (heat₀ − p/l) e^(−l t) between resets.
#[test]
fn events_reset_states_and_kinks_of_rates_are_located() {
    let heater = Heater::<f64>::default();
    let rise = |from: f64, t: f64| 6.0 + (from - 6.0) * (-0.5 * t).exp();
    let until = |from: f64, to: f64| 2.0 * ((6.0 - from) / (6.0 - to)).ln();
    let (first, second) = (until(0.0, 2.0), until(1.0, 2.0));
    let end = first + 1.5 * second;
    let run = heater.simulate([0.0; 4]).until(end).tolerance(1e-12).run().expect("runs");
    let [_, heat, warmth, _] = run.last();
    assert!((heat - rise(1.0, 0.5 * second)).abs() < 1e-10, "{heat}");
    // ∫ (heat − 1) dt from where heat is one.
    let gained = |from: f64, t: f64| 5.0 * t + 2.0 * (from - 6.0) * -(-0.5 * t).exp_m1();
    let expected = gained(1.0, first - until(0.0, 1.0)) + gained(1.0, second) + gained(1.0, 0.5 * second);
    assert!((warmth - expected).abs() < 1e-10, "{warmth} {expected}");
    let times = run.events().iter().map(|event| event.time).collect::<Vec<_>>();
    assert!((times[0] - first).abs() < 1e-11 && (times[1] - first - second).abs() < 1e-11, "{times:?}");
    let narrow = Heater::<f32>::default().simulate([0.0; 4]).until(0.5).run().expect("runs");
    assert!((narrow.last()[1] - rise(0.0, 0.5) as f32).abs() < 1e-5);
}

#[test]
fn a_frozen_state_keeps_its_value() {
    let servo = Servo { voltage: 6.0, hold: 1.25, ..Servo::default() };
    let held = Held::from(&servo);
    assert_eq!(Held::COORDINATES, ["theta", "integral"]);
    let state = HeldState { theta: 0.5, integral: 0.25, theta_dot: -1.0 };
    let whole = ServoState { theta: 0.5, current: 1.25, integral: 0.25, theta_dot: -1.0 };
    assert_eq!((held.expand(state), HeldState::from(whole)), (whole, state));
    assert_eq!(held.deviation(ServoState { current: 2.0, ..whole }).current, 0.75);
    let [theta_dot, _, integral_dot, theta_ddot] = servo.rhs(0.0, &whole.into());
    assert_eq!(held.rhs(0.0, &state.into()), [theta_dot, integral_dot, theta_ddot]);
}

#[test]
fn projections_and_impacts_leave_states_as_they_are() {
    let (mut q, mut v) = ([0.61, -0.8, 7.25], [0.1, 0.2]);
    Rod::default().project(0.0, &mut q, &mut v).expect("near");
    assert!((q[0].hypot(q[1]) - 1.0).abs() < 1e-14 && q[2] == 7.25, "{q:?}");
    let run = Rod::default().simulate([1.0, 0.0, 0.0, 0.0, 0.0]).until(3.0).tolerance(1e-11).run();
    let [x, y, heat, ..] = run.expect("runs").last();
    assert!((x.hypot(y) - 1.0).abs() < 1e-14 && heat > 1.0);

    // Dropped from 1 m, at half the speed each time: after the second impact it has travelled 1 +
    // 2/4 m.
    let fall = (2.0 / 9.81_f64).sqrt();
    let run = Ball::default().simulate([1.0, 0.0, 0.0]).until(2.0 * fall + 1e-9).tolerance(1e-12).run();
    let way = run.expect("runs").last()[1];
    assert!((way - 1.5).abs() < 1e-7, "{way}");
}

/// v = v₀ − t² until it sticks.
#[test]
fn limits_of_friction_may_be_states() {
    let run = Sledge::default().simulate([0.0, 0.0, 4.0]).until(3.0).tolerance(1e-12).run().expect("runs");
    let [x, pressure, speed] = run.last();
    assert!((x - 16.0 / 3.0).abs() < 1e-9 && speed == 0.0, "{x} {speed}");
    assert_close(pressure, 6.0);
}

#[test]
fn states_that_are_not_finite_are_named() {
    let error = Ending.simulate([1.0, f64::NAN, -1.0]).until(2.0).run().expect_err("fails");
    assert_eq!(error.to_string(), "`s` of the state is NaN (at time 0.0)");
    for fixed in [false, true] {
        let run = Ending.simulate([1.0, 0.0, -1.0]).until(2.0);
        let error = match fixed {
            true => run.method(RungeKutta4 { step: 1e-2 }).run().expect_err("fails").to_string(),
            false => run.run().expect_err("fails").to_string(),
        };
        assert!(error.starts_with("the rate `s_dot` is NaN at time 1.0"), "{error}");
    }
}

#[test]
fn controls_change_the_rates_of_states() {
    let servo = Servo::default();
    let inputs = servo.with_inputs(ServoInputs { voltage: 3.0 });
    assert_close(OdeSystem::rhs(&inputs, 0.0, &[0.0; 4])[1], 3.0 / 0.05);
    assert_close(inputs.position_rates(0.0, &[0.0; 3], &[0.0])[1], 3.0 / 0.05);
}
