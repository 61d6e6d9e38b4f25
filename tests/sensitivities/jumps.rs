//! Gradients backwards through events, switches, clocks and jumps at known times, against forward
//! derivatives.

use lagrange::Simulate;
use lagrange::integrate::{RungeKutta4, StepFailure};

lagrange::system! {
    /// A ball over a floor, in wind.
    #[derive(Clone, Debug)]
    struct Ball;
    param g = 9.81, e in 0..=1 = 0.8, c = 0.05;
    coord x, h;
    kinetic = 1/2 * (dot(x)^2 + dot(h)^2);
    potential = g * h;
    dissipation = 1/2 * c * (dot(x) - 1)^2 + 1/2 * c * dot(h)^2;
    event floor = h, falling => { dot(h) = -e * dot(h); }
    event top = dot(h), falling => record;
    emit { jacobian }
}

lagrange::system! {
    /// A mass between two springs that only push; one begins where the other ends.
    #[derive(Clone, Debug)]
    struct Gap;
    param left = 30, right = 50, width = 0, c = 0.1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * left * max(-x, 0)^2 + 1/2 * right * max(x - width, 0)^2;
    force x = -c * dot(x) + if x > 0 { 1 } else { -2 };
    emit { jacobian }
}

lagrange::system! {
    /// A heated room, and a mass pulled by a sampled force.
    #[derive(Clone, Debug)]
    struct Room;
    param low = 19.8, high = 20.2, power = 3, gain = 4, loss = 0.1;
    coord x = 0;
    state temperature = 20;
    discrete held = 0;
    mode heater = off | on;
    kinetic = 1/2 * dot(x)^2;
    force x = -held - 0.2 * dot(x);
    dot(temperature) = loss * (5 - temperature) + if heater == on { power } else { 0 };
    event cold = temperature - low, falling => { heater = on; }
    event warm = temperature - high, rising => { heater = off; }
    every 0.1 => { held = gain * x + dot(x); }
    emit { jacobian }
}

lagrange::system! {
    /// A force that begins at a time.
    #[derive(Clone, Debug)]
    struct Late;
    param f = 2, k = 3, from = 1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    force x = if t > 1 { f } else { 0 } + if t > from + 2 { 1 } else { 0 };
    emit { jacobian }
}

lagrange::system! {
    /// A mass that ends at a wall.
    struct Halted;
    param k = 3;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    event wall = x, falling => stop;
    emit { jacobian }
}

#[test]
fn impacts_change_adjoints() {
    let ball = Ball::default();
    let names = ["g", "e", "c"];
    let states = ["x", "h", "x_dot", "h_dot"];
    let start = [0.0, 1.0, 0.0, 0.3];
    let run = || ball.simulate(start).until(3.0).every(0.25).tolerance(1e-12);
    let gradient = compare!(run(), names, states, 1e-9);
    assert!(gradient.steps > 20);
    compare!(
        ball.simulate(start).until(3.0).every(0.25).method(RungeKutta4 { step: 1e-3 }),
        names,
        states,
        1e-8
    );
}

#[test]
fn switches_change_adjoints_when_they_are_passed_alone_or_together() {
    let states = ["x", "x_dot"];
    for width in [0.0, 0.3] {
        let gap = Gap { width, ..Gap::default() };
        compare!(
            gap.simulate([-0.5, 0.0]).until(4.0).every(0.5).tolerance(1e-12),
            ["left", "right", "c"],
            states,
            1e-8
        );
    }
    let apart = Gap { width: 0.3, ..Gap::default() };
    compare!(apart.simulate([0.5, 1.0]).until(4.0).every(0.5).tolerance(1e-12), ["width", "c"], states, 1e-8);
}

#[test]
fn clocks_modes_and_discrete_states_change_adjoints() {
    let room = Room::default();
    let names = ["low", "high", "power", "gain", "loss"];
    let start = room.start_with(0.7);
    let run = || room.simulate(start).until(3.0).tolerance(1e-12);
    // Samples at ticks have the state after them.
    let states = ["x", "temperature", "held", "heater", "x_dot"];
    compare!(run().every(0.3), names, states, 1e-8);
    compare!(run().every(0.37), names, states, 1e-8);
}

impl Room {
    fn start_with(&self, x: f64) -> [f64; 5] {
        let mut start = [0.0; 5];
        (start[0], start[1]) = (x, 20.0);
        start
    }
}

#[test]
fn equations_may_jump_at_known_times() {
    let late = Late::default();
    compare!(
        late.simulate([1.0, 0.0]).until(4.0).every(0.5).tolerance(1e-12),
        ["f", "k"],
        ["x", "x_dot"],
        1e-9
    );
    let simulation = late.simulate([1.0, 0.0]).until(4.0);
    let refusal = simulation.gradient(["from"], |_, y: &[f64; 2], _| y[0]).expect_err("moves a time");
    assert!(matches!(refusal, StepFailure::Setting(_)) && refusal.to_string().contains("from"), "{refusal}");
}

#[test]
fn a_motion_that_an_event_ends_has_no_fixed_end() {
    let cost = |_: f64, y: &[f64; 2], slope: &mut [f64; 2]| {
        slope[1] = 1.0;
        y[1]
    };
    let halted = Halted::default();
    let refusal = halted.simulate([1.0, 0.0]).until(4.0).gradient(["k"], cost).expect_err("ends early");
    assert!(refusal.to_string().contains("fixed end"), "{refusal}");
    assert!(halted.simulate([1.0, 0.0]).until(0.5).gradient(["k"], cost).is_ok());
}

lagrange::system! {
    /// A mass in a stream, which is reset when it has drifted too far.
    struct Drifting<S>;
    param v = 1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = v - dot(x);
    event far = x - 2, rising => { x = -v; dot(x) = 0; }
    emit { jacobian }
}

#[test]
fn a_parameter_in_a_reaction_and_in_a_force_has_its_derivative_in_both_precisions() {
    let drifting = Drifting::<f64>::default();
    let cost = |_: f64, y: &[f64; 2], slope: &mut [f64; 2]| {
        slope[0] = 1.0;
        y[0]
    };
    // x = 1.5 + v t for v = 1 reaches 2 at t = 1/2, and continues as −v + v (s − 1 + exp(−s)), s =
    // t − T. Its derivative is −1 + s − 1 + exp(−s) − v (1 − exp(−s)) dT/dv. T follows from 1.5 + v
    // T + (1 − v) (1 − exp(−T)) = 2, so dT/dv = 1 − exp(−T) − T at v = 1.
    let (passing, since) = (0.5_f64, 1.5_f64);
    let later = 1.0 - (-passing).exp() - passing;
    let expected = since - 2.0 + (-since).exp() - (1.0 - (-since).exp()) * later;
    let gradient = drifting.simulate([1.5, 1.0]).until(2.0).gradient(["v"], cost).expect("steep");
    assert!((gradient.by[0] - expected).abs() < 1e-8, "{} {expected}", gradient.by[0]);
    let single = Drifting::<f32>::default();
    let gradient = single.simulate([1.5, 1.0]).until(2.0).gradient(["v"], |_, y, slope| {
        slope[0] = 1.0;
        y[0]
    });
    let by_speed = f64::from(gradient.expect("steep").by[0]);
    assert!((by_speed - expected).abs() < 1e-4, "{by_speed} {expected}");
}

lagrange::system! {
    /// A mass that is reset where the event function is flat.
    struct Flat;
    param v = 1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = v - dot(x);
    event flat = (x - 1)^3, rising => { x = 0; }
    emit { jacobian }
}

#[test]
fn an_event_of_zero_rate_has_no_derivative_in_either_direction() {
    let flat = Flat::default();
    let run = || flat.simulate([0.0, 1.0]).until(1.5).tolerance(1e-12);
    let backwards = run().gradient(["v"], |_, y, slope| {
        slope[0] = 1.0;
        y[0]
    });
    let cause = backwards.expect_err("flat");
    assert!(matches!(cause, StepFailure::NotDifferentiable { variable: "v", .. }), "{cause}");
    let forwards = run().sensitivities(["v"]).run().expect_err("flat");
    assert!(matches!(forwards.cause, StepFailure::NotDifferentiable { .. }), "{forwards}");
}

lagrange::system! {
    /// A ball on a shaken table, beside an unrelated pressure.
    #[derive(Clone, Debug)]
    struct Shaken;
    param a = 0.1, w = 50, e = 0.6, g = 9.81;
    coord h;
    state p = 0;
    kinetic = 1/2 * dot(h)^2;
    potential = g * h;
    dot(p) = 0;
    event table = h - a * sin(w * t), falling => { dot(h) = (1 + e) * a * w * cos(w * t) - e * dot(h); }
    emit { jacobian }
}

#[test]
fn large_states_beside_small_ones_do_not_disturb_derivatives() {
    let shaken = Shaken::default();
    let start = |p: f64| [1.0, p, 0.0];
    let run = |p: f64| shaken.simulate(start(p)).until(0.7).tolerance(1e-12);
    let cost = |_: f64, y: &[f64; 3], slope: &mut [f64; 3]| {
        slope[0] = 1.0;
        y[0]
    };
    let height = |by: f64| {
        let shaken = Shaken { a: 0.1 + by, ..shaken.clone() };
        shaken.simulate(start(0.0)).until(0.7).tolerance(1e-13).run().unwrap().last()[0]
    };
    let central = |h: f64| (height(h) - height(-h)) / (2.0 * h);
    let difference = (4.0 * central(1e-5) - central(2e-5)) / 3.0;
    for p in [0.0, 300.0, 1e5, 1e9] {
        let gradient = run(p).gradient(["a"], cost).unwrap();
        assert!((gradient.by[0] / difference - 1.0).abs() < 1e-6, "{p}: {} {difference}", gradient.by[0]);
        let motion = run(p).sensitivities(["a"]).run().unwrap();
        let slope = *motion.column("d(h)/d(a)").unwrap().last().unwrap();
        assert!((slope / difference - 1.0).abs() < 1e-6, "{p}: {slope} {difference}");
    }
}
