//! Discrete states, modes with named values, and clocks.

use lagrange::Simulate;
use lagrange::event::Direction;
use lagrange::integrate::RungeKutta4;

lagrange::system! {
    /// A room whose heater a thermostat switches, with a count of the switchings.
    #[derive(Clone, Debug)]
    pub struct Room;

    param low = 19, high = 21, outside = 5, power = 2, loss = 0.1;
    coord x;
    state temperature = 20;
    mode heater = off | on;
    discrete count = 0;
    kinetic = 1/2 * dot(x)^2;
    dot(temperature) = loss * (outside - temperature) + if heater == on { power } else { 0 };
    event cold = temperature - low, falling => { heater = on; count = count + 1; }
    event warm = temperature - high, rising => { heater = off; }
    output heat = if heater != off { power } else { 0 };
}

/// Returns the time in which the temperature passes from one value to another on its way to
/// `limit`.
fn duration(from: f64, to: f64, limit: f64) -> f64 {
    ((limit - from) / (limit - to)).ln() / 0.1
}

#[test]
fn a_thermostat_switches_when_its_equation_says() {
    let room = Room::default();
    let run = room.simulate(room.start()).until(40.0).every(0.5).tolerance(1e-12).outputs().run();
    let run = run.unwrap();
    let (cooling, heating) = (duration(21.0, 19.0, 5.0), duration(19.0, 21.0, 25.0));
    let first = duration(20.0, 19.0, 5.0);
    for (k, event) in run.events().iter().enumerate() {
        let period = (k / 2) as f64 * (cooling + heating);
        let expected = first + period + if k % 2 == 0 { 0.0 } else { heating };
        assert!((event.time - expected).abs() < 1e-9, "{event:?}, not at {expected}");
    }
    assert_eq!(run.events().len(), 15);
    let heat = run.column("heat").unwrap();
    for (k, &t) in run.times().iter().enumerate() {
        let since = (t - first).rem_euclid(cooling + heating);
        let is_on = t > first && since < heating;
        assert_eq!(run.heater()[k], f64::from(u8::from(is_on)), "at {t}");
        assert_eq!(heat[k], 2.0 * run.heater()[k]);
    }
    assert_eq!(run.count()[run.len() - 1], 8.0);
}

#[test]
fn discrete_states_have_no_rate() {
    let room = Room::default();
    let state = RoomState { heater: 1.0, count: 7.0, ..room.start() };
    let rates = room.rhs(0.0, &state.into());
    assert_eq!(rates[2..4], [0.0, 0.0]);
    // Rates accept any value, including those that no mode has.
    assert_eq!(room.rhs(0.0, &RoomState { heater: 0.5, ..state }.into())[1], -1.5);
}

lagrange::system! {
    /// A ball that gains mass at each bounce, and stops at the third.
    #[derive(Clone, Debug)]
    pub struct Growing<S>;

    param g = 9.81;
    coord y = 1;
    discrete mass = 1, bounces = 0;
    kinetic = kinetic_energy(mass, dot(y));
    potential = gravitational_energy(mass, g, y);
    event floor = y, falling => { dot(y) = -dot(y); mass = 2 * mass; bounces = bounces + 1; }
    event last = if bounces >= 2 { y } else { 1 }, falling => stop;
}

#[test]
fn masses_and_events_may_depend_on_discrete_states() {
    let ball = Growing::<f64>::default();
    let run = ball.simulate(ball.start()).until(10.0).tolerance(1e-12).energy().run().unwrap();
    let fall = (2.0_f64 / 9.81).sqrt();
    assert!((run.times()[run.len() - 1] - 5.0 * fall).abs() < 1e-10);
    let energy = run.column("energy").unwrap();
    for (energy, bounces) in energy.iter().zip(run.bounces()) {
        assert!((energy - 9.81 * 2_f64.powf(*bounces)).abs() < 1e-9);
    }
    let single = Growing::<f32>::default();
    let run = single.simulate(single.start()).until(3.0).run().unwrap();
    assert!((run.times()[run.len() - 1] - 5.0 * (2.0_f32 / 9.81).sqrt()).abs() < 1e-4);
}

lagrange::system! {
    /// A trolley with a sampled force, held between ticks.
    #[derive(Clone, Debug)]
    pub struct Held<S>;

    param kp = 4, kd = 2, period = 0.1;
    input push;
    coord x = 1;
    discrete u = 0, ticks = 0, seen = 0;
    kinetic = 1/2 * dot(x)^2;
    force x = u + push;
    every period => { u = -kp * x - kd * dot(x); ticks = ticks + 1; }
    every 2 * period => { seen = ticks; }
}

/// Returns the trolley after some ticks and a remaining time.
fn held(ticks: u32, rest: f64) -> [f64; 2] {
    let (mut x, mut v) = (1.0_f64, 0.0_f64);
    for tick in 1..=ticks {
        let (u, h) = (-4.0 * x - 2.0 * v, if tick == ticks { rest } else { 0.1 });
        (x, v) = (x + h * (v + 0.5 * h * u), v + h * u);
    }
    [x, v]
}

#[test]
fn clocks_sample_and_hold() {
    let system = Held::<f64>::default();
    let run = system.simulate(system.start()).until(0.95).every(0.05).tolerance(1e-12).run().unwrap();
    let end = run.last();
    let expected = held(10, 0.05);
    assert!((end[0] - expected[0]).abs() < 1e-13 && (end[4] - expected[1]).abs() < 1e-13, "{end:?}");
    // A sample at a tick shows the state after it; the clock declared first comes first.
    for (k, t) in run.times().iter().enumerate() {
        let ticks = (t / 0.1 + 1e-9).floor() + 1.0;
        assert_eq!(run.ticks()[k], ticks, "at {t}");
        assert_eq!(run.seen()[k], 2.0 * ((ticks - 1.0) / 2.0).floor() + 1.0, "at {t}");
    }
    let fixed = system.simulate(system.start()).until(0.95).method(RungeKutta4 { step: 0.03 }).run().unwrap();
    assert!((fixed.last()[0] - expected[0]).abs() < 1e-13);
    let single = Held::<f32>::default();
    let run = single.simulate(single.start()).until(0.95).run().unwrap();
    assert!((f64::from(run.last()[0]) - expected[0]).abs() < 1e-6);
    assert_eq!(run.last()[2], 10.0);
}

#[test]
fn a_run_in_parts_ticks_as_often_as_the_whole() {
    let system = Held::<f64>::default();
    let whole = system.simulate(system.start()).until(3.0).tolerance(1e-12).run().unwrap();
    let mut state: [f64; 5] = system.start().into();
    let parts = [0.0, 0.25, 0.3, 0.1 * 7.0, 1.55, 3.0];
    for part in parts.windows(2) {
        state = system.simulate(state).from(part[0]).until(part[1]).tolerance(1e-12).run().unwrap().last();
    }
    let difference = whole.last().iter().zip(state).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(difference < 1e-11, "{state:?}, not {:?}", whole.last());
    assert_eq!(state[2], 30.0);
}

#[test]
fn clocks_tick_at_multiples_of_their_period() {
    let system = Held::<f64>::default();
    let ticks = |from: f64, until: f64| {
        let run = system.simulate(system.start()).from(from).until(until).run().unwrap();
        run.last()[2]
    };
    assert_eq!(ticks(0.05, 0.25), 2.0);
    assert_eq!(ticks(-0.25, 0.25), 5.0);
    assert_eq!(ticks(-0.1, 0.1), 2.0);
    assert_eq!(ticks(0.11, 0.19), 0.0);
    assert_eq!(ticks(0.0, 0.0), 0.0);
    assert_eq!(ticks(1e6, 1e6 + 1.05), 11.0);
}

#[test]
fn clocks_and_controllers_act_in_one_run() {
    let system = Held::<f64>::default();
    let run = system
        .simulate(system.start())
        .until(0.95)
        .tolerance(1e-12)
        .sampled(0.1, |_, _, _| HeldInputs { push: 0.25 })
        .run()
        .unwrap();
    assert_eq!(run.last()[2], 10.0);
    let driven = system.simulate(system.start()).until(0.95).tolerance(1e-12);
    let driven = driven.drive(|_, _, _| HeldInputs { push: 0.25 }).run().unwrap();
    assert!((run.last()[0] - driven.last()[0]).abs() < 1e-12);
    assert_eq!(driven.last()[2], 10.0);
}

#[test]
fn impossible_clocks_are_refused() {
    let error = |period: f64, from: f64, until: f64| {
        let system = Held { period, ..Held::default() };
        system.simulate(system.start()).from(from).until(until).run().unwrap_err().to_string()
    };
    for period in [0.0, -0.1, f64::NAN] {
        assert!(error(period, 0.0, 1.0).contains("the period of a clock must be positive"));
    }
    assert!(error(0.1, 1e16, 2e16).contains("longer than the spacing of times"));
    assert!(error(0.1, 1.0, 0.0).contains("clocks tick forwards in time only"));
}

lagrange::system! {
    /// Two relays of one kind, one of which drives the other.
    #[derive(Clone, Debug)]
    pub struct Relays;

    part Relay(signal, level) {
        mode contact = open | closed;
        event rises = signal - level, rising => { contact = closed; }
        event falls = signal - level / 2, falling => { contact = open; }
    }

    coord x = 0;
    start dot(x) = 1;
    mode valve[2] = closed | half | wide;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    first: Relay { signal: x; level: 0.5; }
    second: Relay { signal: -x; level: 0.5; }
    start second.contact = second.closed, valve[1] = wide;
    event half_way = x - 0.7, rising => { valve[0] = half; valve[1] = if valve[1] == wide { closed } else { half }; }
    output lamps = if first.contact == first.closed { 1 } else { 0 } + if second.contact == second.closed { 2 } else { 0 };
    output valves = valve[0] + 10 * valve[1];
}

#[test]
fn parts_and_arrays_have_modes() {
    let relays = Relays;
    let run = relays.simulate(relays.start()).until(7.0).every(0.01).tolerance(1e-12);
    let run = run.outputs().run().unwrap();
    let (lamps, valves) = (run.column("lamps").unwrap(), run.column("valves").unwrap());
    let (turn, low, high) = (std::f64::consts::TAU, 0.25_f64.asin(), 0.5_f64.asin());
    for (k, &t) in run.times().iter().enumerate() {
        // x = sin t
        let first = (high..0.5 * turn - low).contains(&(t % turn));
        let second = t < turn - low;
        assert_eq!(lamps[k], f64::from(u8::from(first)) + 2.0 * f64::from(u8::from(second)), "at {t}");
        assert_eq!(valves[k], if t > 0.7_f64.asin() { 1.0 } else { 20.0 }, "at {t}");
    }
}

lagrange::system! {
    /// Two discs in a central collision, with local names for the impact, and a clock with local
    /// names.
    #[derive(Clone, Debug)]
    pub struct Collision;

    param m[2] = [1, 3], e = 0.5;
    coord x[2] = [0, 1];
    start dot(x[0]) = 2;
    discrete energy, mean;
    kinetic = sum(i in 0..2, kinetic_energy(m[i], dot(x[i])));
    let (a, b) = ((x[0], dot(x[0])), (x[1], dot(x[1]), 0));
    event hit = x[1] - x[0], falling => {
        let (u, w) = dot(x);
        let common = (m[0] * u + m[1] * w) / (m[0] + m[1]);
        for i in 0..2 {
            let relative = dot(x[i]) - common;
            dot(x[i]) = common - e * relative;
        }
    }
    every 0.15 => { let square(v) = v^2; energy = (m[0] * square(a.y) + m[1] * square(b.y)) / 2; mean = (a.x + b.x) / 2; }
}

/// Newton's law of impact: velocities along the line are (m₁u + m₂w ∓ m e (u − w)) / (m₁ + m₂).
#[test]
fn handlers_have_local_names() {
    let system = Collision::default();
    let run = system.simulate(system.start()).until(1.2).every(0.3).tolerance(1e-12).run().unwrap();
    assert!((run.events()[0].time - 0.5).abs() < 1e-12);
    let [first, second] = [0, 1].map(|i| run.x_dot(i).last().copied().unwrap());
    assert!((first - (0.5 - 0.5 * 1.5)).abs() < 1e-12 && (second - (0.5 + 0.5 * 0.5)).abs() < 1e-12);
    let (before, after) = (run.energy()[1], run.energy()[4]);
    assert!((before - 2.0).abs() < 1e-12 && (after - (0.5 * 0.0625 + 1.5 * 0.5625)).abs() < 1e-12);
    assert!((run.mean()[1] - (0.6 + 1.0) / 2.0).abs() < 1e-12);
}

lagrange::system! {
    /// A body that passes an origin while a controller samples its position.
    #[derive(Clone, Debug)]
    pub struct Sampled;

    param period = 0.5, stiffness = 0;
    coord x = 1;
    start dot(x) = -2;
    discrete passed, held, mark;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * stiffness * x^2;
    event origin = x, crossing => { passed = passed + 1; }
    event marked = x - mark, falling => record;
    every period => { held = x; mark = if t < period { 0 } else { mark - 1 }; }
}

#[test]
fn zeros_at_ticks_are_events() {
    for period in [0.5, 0.25, 0.125, 0.1, 0.3, 0.7] {
        let sampled = Sampled { period, ..Sampled::default() };
        let start = sampled.start();
        let given = sampled.simulate(start).until(0.9).tolerance(1e-10);
        let given = given.event("given", Direction::Falling, |_, _, y| y[0]).run().unwrap();
        let at_origin = given.events().iter().filter(|event| event.name != "marked").collect::<Vec<_>>();
        assert_eq!(at_origin.len(), 2, "{period}: {at_origin:?}");
        assert!(at_origin.iter().all(|event| (event.time - 0.5).abs() < 1e-14), "{at_origin:?}");
        assert_eq!(given.passed().last(), Some(&1.0), "{period}");
    }
}

/// Steps of a uniform motion are exact in binary fractions.
#[test]
fn zeros_that_a_tick_moves_away_are_events_before_it() {
    let sampled = Sampled::default();
    let run = sampled.simulate(sampled.start()).until(3.2).method(RungeKutta4 { step: 0.125 }).run().unwrap();
    let marked = run.events().iter().filter(|event| event.name == "marked");
    let times = marked.map(|event| event.time).collect::<Vec<_>>();
    assert_eq!(times, [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]);
    assert_eq!(run.held().last(), Some(&-5.0));
}

#[test]
fn zeros_at_every_tick_do_not_accumulate() {
    let stiffness = std::f64::consts::TAU.powi(2);
    let sampled = Sampled { stiffness, ..Sampled::default() };
    let start = SampledState { x: 0.0, x_dot: 1.0, ..sampled.start() };
    let run = sampled.simulate(start).until(59.9).tolerance(1e-12).run().unwrap();
    assert_eq!(run.passed().last(), Some(&119.0));
}
