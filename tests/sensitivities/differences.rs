//! Derivatives against extrapolated differences of motions.

use lagrange::system::{OdeSystem, ParametricSystem};
use lagrange::{Simulate, simulate::Trajectory};

const TOLERANCE: f64 = 1e-13;

/// Tolerance small enough that derivatives by differences do not show the errors of motions.
const WITH_CONTACTS: f64 = 1e-11;

/// Compares all derivatives at the end of a run with differences of runs, relative to the largest.
/// A variable is the name and, for initial values, the index in the state.
fn compare<M, const N: usize, const K: usize>(
    system: &M,
    start: [f64; N],
    end: f64,
    names: [&'static str; K],
    run: impl Fn(&M, [f64; N], Option<[&'static str; K]>) -> Trajectory<M>,
    tolerance: f64,
) where
    M: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]>,
{
    let motion = run(system, start, Some(names));
    assert_eq!(motion.end_time(), end);
    let found = motion.sensitivities(motion.len() - 1).unwrap();
    let states = motion.names()[..N].to_vec();
    for (name, found) in names.into_iter().zip(found) {
        let number = M::NUMBERS.iter().position(|number| *number == name);
        let at = |by: f64| match number {
            Some(index) => {
                let moved = system.with_number(index, system.number(index).unwrap() + by);
                run(&moved, start, None).last()
            }
            None => {
                let place = states.iter().position(|state| state == name).unwrap();
                let mut moved = start;
                moved[place] += by;
                run(system, moved, None).last()
            }
        };
        let central = |h: f64| {
            let (ahead, behind) = (at(h), at(-h));
            std::array::from_fn::<f64, N, _>(|i| (ahead[i] - behind[i]) / (2.0 * h))
        };
        let size = number.map_or(1.0, |index| system.number(index).unwrap());
        let (wide, middle, narrow) = (central(2e-3 * size), central(1e-3 * size), central(5e-4 * size));
        let wanted: [f64; N] = std::array::from_fn(|i| {
            let (first, second) = ((4.0 * middle[i] - wide[i]) / 3.0, (4.0 * narrow[i] - middle[i]) / 3.0);
            (16.0 * second - first) / 15.0
        });
        let size = wanted.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for (found, wanted) in found.iter().zip(wanted) {
            assert!((found - wanted).abs() < tolerance * size.max(1e-3), "{name}: {found} {wanted}");
        }
    }
}

macro_rules! run {
    ($end:expr) => {
        run!($end, TOLERANCE)
    };
    ($end:expr, $tolerance:expr) => {
        |system, start, names| {
            let run = system.simulate(start).until($end).tolerance($tolerance);
            match names {
                Some(names) => run.sensitivities(names).run(),
                None => run.run(),
            }
            .unwrap()
        }
    };
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct DoublePendulum;
    param m1 = 1.0, m2 = 1.5, l1 = 1.0, l2 = 0.8, g = 9.81, c = 0.1;
    coord theta1, theta2;
    input push = 0.3;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    dissipation = 1/2 * c * (dot(theta1)^2 + (dot(theta2) - dot(theta1))^2);
    force theta1 = push;
    emit { jacobian }
}

#[test]
fn a_double_pendulum() {
    let names = ["m1", "m2", "l1", "c", "push", "theta1", "theta2_dot"];
    let start = [1.2, -0.4, 0.0, 0.3];
    compare(&DoublePendulum::default(), start, 3.0, names, run!(3.0), 1e-8);
}

lagrange::system! {
    /// A block on a belt, with a spring, Coulomb-like friction and a stiffer spring beyond `edge`.
    #[derive(Clone, Debug)]
    struct Block;
    param m = 1.0, k = 5.0, mu = 0.4, edge = 0.2, stop = 30.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    force x = if x > edge { -stop * (x - edge) } else { 0 };
    force x = if dot(x) > 0 { -mu } else { mu };
    emit { jacobian }
}

/// The slip reverses, and the edge is passed, repeatedly.
#[test]
fn switches() {
    let names = ["m", "k", "mu", "edge", "stop", "x", "x_dot"];
    let motion = Block::default().simulate([1.0, 0.0]).until(2.5).tolerance(1e-10).run().unwrap();
    let speeds = motion.x_dot();
    let turns = speeds.windows(2).filter(|pair| pair[0] * pair[1] < 0.0).count();
    assert!(turns >= 2, "{turns}");
    compare(&Block::default(), [1.0, 0.1], 2.5, names, run!(2.5), 1e-7);
}

lagrange::system! {
    /// Dry friction that sticks and slips, on a moving belt.
    #[derive(Clone, Debug)]
    struct Stick;
    param m = 1.0, k = 4.0, limit = 1.0, belt = 0.3;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    potential = 1/2 * k * x^2;
    friction rub = dot(x) - belt, kinetic: limit, static: 1.5 * limit;
}

/// The block sticks, breaks loose and sticks again.
#[test]
fn stick_and_slip() {
    let motion = Stick::default().simulate([0.0, 0.0]).until(4.0).run().unwrap();
    assert!(motion.events().len() >= 3, "{:?}", motion.events());
    compare(
        &Stick::default(),
        [0.0, 0.0],
        4.0,
        ["m", "k", "limit", "belt", "x_dot"],
        run!(4.0, WITH_CONTACTS),
        1e-6,
    );
}

lagrange::system! {
    /// A pendulum in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Rod;
    param l = 1.0, g = 9.81, c = 0.2;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    dissipation = 1/2 * c * (dot(x)^2 + dot(y)^2);
    constraint length = hypot(x, y) - l;
    emit { jacobian }
}

/// Constraints apply to derivatives, too: x s_x + y s_y = 0 for all parameters except the length.
#[test]
fn a_constraint() {
    compare(&Rod::default(), [0.6, -0.8, 0.0, 0.0], 2.0, ["g", "c"], run!(2.0), 1e-8);
    let motion = Rod::default()
        .simulate([0.6, -0.8, 0.0, 0.0])
        .until(2.0)
        .tolerance(TOLERANCE)
        .sensitivities(["g", "l"])
        .run()
        .unwrap();
    for (row, [x, y, ..]) in motion.states().enumerate() {
        let [by_g, by_l] = motion.sensitivities(row).unwrap()[..] else { panic!() };
        assert!((x * by_g[0] + y * by_g[1]).abs() < 1e-9);
        assert!((x * by_l[0] + y * by_l[1] - 1.0).abs() < 1e-9, "{row}");
    }
}

lagrange::system! {
    /// Two balls that hit the floor at the same time, and a wall that both may hit.
    #[derive(Clone, Debug)]
    pub(crate) struct Pair;
    param g = 9.81, e = 0.8, f = 0.6;
    coord a, b;
    kinetic = 1/2 * (dot(a)^2 + dot(b)^2);
    potential = g * (a + b);
    event left = a, falling => impact(e);
    event right = b, falling => impact(f);
}

#[test]
fn impacts_at_the_same_time() {
    compare(&Pair::default(), [1.0, 1.0, 0.0, 0.0], 0.8, ["g", "e", "f"], run!(0.8, WITH_CONTACTS), 1e-7);
}

/// If one ball is moved, the other one hits at another time than it.
#[test]
fn impacts_that_a_variable_separates_are_refused_in_words() {
    let run = |a: f64| {
        let pair = Pair::default();
        pair.simulate([a, 1.0, 0.0, 0.0]).until(0.8).sensitivities(["a"]).run().map(|motion| {
            let [by_a] = motion.sensitivities(motion.len() - 1).expect("requested")[..] else { panic!() };
            by_a
        })
    };
    let refusal = run(1.0).expect_err("they are together").to_string();
    assert!(refusal.contains("contacts or friction change at the same time"), "{refusal}");
    for a in [1.0 - 1e-5, 1.0 + 1e-5] {
        let by_a = run(a).expect("one after the other");
        assert!(by_a[0].abs() > 0.1 && by_a[1].abs() < 1e-9 && by_a[3].abs() < 1e-9, "{by_a:?}");
    }
}

#[test]
fn a_law_of_inputs() {
    let run = |system: &DoublePendulum, start: [f64; 4], names: Option<[&'static str; 2]>| {
        let law = |system: &DoublePendulum, t: f64, state: DoublePendulumState| DoublePendulumInputs {
            push: system.m1 * (3.0 * t).sin() - 2.0 * state.theta1,
        };
        let run = system.simulate(start).until(2.0).tolerance(TOLERANCE).drive(law);
        match names {
            Some(names) => run.sensitivities(names).run(),
            None => run.run(),
        }
        .unwrap()
    };
    compare(&DoublePendulum::default(), [1.2, -0.4, 0.0, 0.3], 2.0, ["m1", "theta1"], run, 1e-7);
}

lagrange::system! {
    /// A room whose heater a thermostat switches.
    #[derive(Clone, Debug)]
    struct Room;
    param low = 19, high = 21, outside = 5, power = 2, loss = 0.1;
    coord x;
    state temperature = 20;
    mode heater = off | on;
    kinetic = 1/2 * dot(x)^2;
    dot(temperature) = loss * (outside - temperature) + if heater == on { power } else { 0 };
    event cold = temperature - low, falling => { heater = on; }
    event warm = temperature - high, rising => { heater = off; }
    emit { jacobian }
}

#[test]
fn a_thermostat() {
    let names = ["low", "high", "outside", "power", "loss", "temperature"];
    let start: [f64; 4] = Room::default().start().into();
    let motion = Room::default().simulate(start).until(20.0).run().unwrap();
    assert!(motion.events().len() >= 3);
    compare(&Room::default(), start, 20.0, names, run!(20.0), 1e-7);
}

lagrange::system! {
    /// A trolley whose force a clock holds between ticks.
    #[derive(Clone, Debug)]
    struct Trolley;
    param m = 2.0, gain = 3.0, damping = 1.5;
    coord x;
    discrete held = 0;
    kinetic = 1/2 * m * dot(x)^2;
    force x = -held;
    every 0.1 => { held = gain * x + damping * dot(x); }
    emit { jacobian }
}

#[test]
fn a_clock() {
    compare(&Trolley::default(), [1.0, 0.0, 0.2], 1.25, ["m", "gain", "damping", "x"], run!(1.25), 1e-8);
}

lagrange::system! {
    /// A cart on a spring, with a pendulum on a ball joint.
    #[derive(Clone, Debug)]
    struct Crane;
    param k = 20.0, load_mass = 1.0;
    gravity = (0, 0, -9.81);
    body cart { mass: 2; inertia: (0.1, 0.1, 0.1); }
    prismatic s = ground to cart { axis: (1, 0, 0); }
    potential = spring_energy(k, s);
    body load { mass: load_mass; centroid: (0.02, 0, -0.5); inertia: (0.1, 0.105, 0.01, 0.002, 0, 0); }
    ball hook = cart to load { at: (0, 0, -0.1); damping: 0.05; }
    emit { jacobian }
}

/// An orientation keeps unit length, and its derivatives preserve that.
#[test]
fn a_quaternion() {
    let start = [0.1, 0.8, 0.6, 0.0, 0.0, 0.2, 0.3, -0.4, 0.5];
    compare(&Crane::default(), start, 2.0, ["k", "load_mass", "s", "hook_wx"], run!(2.0), 1e-7);
    let motion = Crane::default().simulate(start).until(2.0).sensitivities(["k", "hook_wx"]).run().unwrap();
    for (row, state) in motion.states().enumerate() {
        for change in motion.sensitivities(row).unwrap() {
            let product: f64 = (1..5).map(|entry| state[entry] * change[entry]).sum();
            assert!(product.abs() < 1e-8, "{product}");
        }
    }
}

lagrange::system! {
    /// A brick that falls on a corner.
    #[derive(Clone, Debug)]
    struct Brick;
    param e = 0.5, mass = 1.0;
    gravity = (0, 0, -9.81);
    body brick { mass: mass; inertia: (0.01, 0.02, 0.025); }
    free brick;
    let corner = brick.point(0.1, 0.05, -0.05);
    event floor = corner.z, falling => impact(e);
}

#[test]
fn a_brick_on_its_corner() {
    let motion = Brick::default().simulate(BRICK).until(0.6).run().unwrap();
    assert!(!motion.events().is_empty());
    compare(&Brick::default(), BRICK, 0.6, ["e", "mass", "brick_wx"], run!(0.6, WITH_CONTACTS), 1e-6);
}

const BRICK: [f64; 13] = [0.0, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 0.1, 0.0, 0.0, 1.0, -0.5, 0.2];

lagrange::system! {
    /// A block that lies on the ground with dry friction, pulled by a growing force.
    #[derive(Clone, Debug)]
    struct Lying;
    param m = 1.0, mu = 0.3, pull = 2.0, g = 9.81;
    coord x, h;
    kinetic = 1/2 * m * (dot(x)^2 + dot(h)^2);
    potential = m * g * h;
    force x = pull * t;
    event ground = h, falling => impact(0);
    friction rub = dot(x), mu * ground;
}

/// The contact is closed from the start: a resting block stays on the ground, whatever its height.
#[test]
fn a_block_that_lies() {
    compare(&Lying::default(), [0.0; 4], 3.0, ["m", "mu", "pull"], run!(3.0, WITH_CONTACTS), 1e-7);
    let motion = Lying::default().simulate([0.0; 4]).until(3.0).sensitivities(["h"]).run().unwrap();
    assert!(motion.column("d(h)/d(start.h)").unwrap().iter().all(|slope| slope.abs() < 1e-12));
}
