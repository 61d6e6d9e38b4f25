//! Taylor series of declarations in text. Motions have the bits of compiled types, and refusals
//! their words.

mod record;
#[macro_use]
#[path = "systems/both_ways.rs"]
mod both_ways;

use lagrange::Simulate;
use lagrange::integrate::Taylor;
use lagrange_dynamic::{DynamicSystem, MethodChoice, RunSettings, Visitor};
use record::{Record, declared, record};

both_ways! {
    DoublePendulum = DOUBLE_PENDULUM {
        param m1: kg = 1.0, m2: kg = 1.0, l1: m = 1.0, l2: m = 1.0, g: m/s^2 = 9.81;
        coord theta1: rad, theta2: rad;
        let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
        let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
        kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
        potential = m1 * g * y1 + m2 * g * y2;
        emit { taylor }
    }

    Kepler = KEPLER {
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = -1 / hypot(x, y);
        output distance = hypot(x, y);
        emit { taylor }
    }

    Chain = CHAIN {
        const n = 7;
        param m[n] = 1, l[n] = 0.5, g = 9.81;
        coord q[n];
        for i in 0..n {
            let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
            kinetic = kinetic_energy(m[i], dot(p[i]));
            potential = gravitational_energy(m[i], g, p[i].y);
        }
        emit { taylor }
    }

    Rod = ROD {
        param m = 1.0, g = 9.81;
        coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
        potential = m * g * y;
        constraint length = x^2 + y^2 - 1;
        output tension = 2 * length;
        emit { taylor }
    }

    StabilisedRod = STABILISED_ROD {
        param m = 1.0, g = 9.81;
        coord x, y;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
        potential = m * g * y;
        constraint length = hypot(x, y) - 1;
        stabilise = 5;
        emit { taylor }
    }

    Skate = SKATE {
        coord x, y, phi;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/2 * dot(phi)^2;
        potential = 2 * y;
        constraint edge = dot(x) * sin(phi) - dot(y) * cos(phi);
        emit { taylor }
    }

    Planets = PLANETS {
        const n = 6;
        param m[n] = [1, 1e-3, 3e-4, 4e-5, 5e-5, 7e-9];
        coord x[n], y[n], z[n];
        kinetic = sum(i in 0..n, 1/2 * m[i] * (dot(x[i])^2 + dot(y[i])^2 + dot(z[i])^2));
        potential = -sum(i in 0..n, sum(j in 0..i,
            m[i] * m[j] / sqrt((x[i] - x[j])^2 + (y[i] - y[j])^2 + (z[i] - z[j])^2)));
        emit { taylor }
    }

    Rods = RODS {
        param m = 1.0, g = 9.81;
        coord x[2], y[2], s;
        kinetic = 1/2 * m * sum(i in 0..2, dot(x[i])^2 + dot(y[i])^2) + 1/2 * (1 + x[1]^2) * dot(s)^2;
        potential = m * g * (y[0] + y[1]) + s^2;
        constraint first = x[0]^2 + y[0]^2 - 1;
        constraint second = x[1]^2 + y[1]^2 - 1;
        emit { taylor }
    }

    Top = TOP {
        param m = 0.5, l = 0.1, i1 = 2e-3, i3 = 1e-3, g = 9.81;
        gravity = (0, 0, -g);
        body rotor { mass: m; centroid: (0, 0, l); inertia: (i1, i1, i3); }
        ball tip = ground to rotor;
        output height = rotor.center.z;
        emit { taylor }
    }

    Wind = WIND {
        table gust(time) = [(0, 0), (1, 2), (1.5, -1), (3, 0.5)], interpolation: monotone, outside: clamp;
        table spring(u, s) = [(-1, 0, -2), (-1, 1, -1), (0, 0, 0), (0, 1, 0.1), (1, 0, 2), (1, 1, 1)], interpolation: natural, outside: extend;
        coord x;
        kinetic = 1/2 * dot(x)^2;
        force x = gust(t) - spring(x, 0.5 + 0.2 * sin(x));
        emit { taylor }
    }

    Bounce = BOUNCE {
        param g: m/s^2 = 9.81, e = 0.8;
        coord h: m;
        kinetic = 1/2 * (1 [kg]) * dot(h)^2;
        potential = (1 [kg]) * g * h;
        event floor = h, falling => { dot(h) = -e * dot(h); }
        event top = dot(h), falling => record;
        event late = t - (3.2 [s]), rising => stop;
        emit { taylor }
    }

    Kinks = KINKS {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        potential = 3 * abs(x);
        force x = if t > 1.25 { 0.7 } else { -0.2 * max(dot(x), 0) };
        emit { taylor }
    }

    Room = ROOM {
        param period = 0.25;
        coord x;
        state warm = 20;
        discrete held = 0;
        mode heater = off | on;
        kinetic = 1/2 * dot(x)^2;
        force x = held - x^3;
        dot(warm) = 0.3 * (5 - warm) + if heater == on { 9 } else { 0 };
        event cold = warm - 19.8, falling => { heater = on; }
        event hot = warm - 20.2, rising => { heater = off; }
        every period => { held = warm - 20 - x - dot(x); }
        emit { taylor }
    }

    Implicit = IMPLICIT {
        coord x;
        solve y: 0 = y^3 + y - x, start: x;
        kinetic = 1/2 * dot(x)^2;
        potential = 2 * y^2;
        emit { taylor }
    }

    Motor = MOTOR {
        param j = 0.01, r = 0.5, l = 0.02, k = 0.05;
        input voltage = 6.0;
        coord phi;
        state current;
        kinetic = 1/2 * j * dot(phi)^2;
        force phi = k * current - 0.01 * tanh(dot(phi)) * exp(-phi^2);
        dot(current) = (voltage - r * current - k * dot(phi)) / l;
        emit { taylor }
    }

    Drain = DRAIN {
        state level = 1;
        dot(level) = -0.7 * sqrt(level);
        emit { taylor }
    }

    Still = STILL {
        coord x;
        kinetic = 1/2 * dot(x)^2;
        emit { taylor }
    }
}

/// The motion of a declared system from a state to a time.
struct Motion<'a> {
    start: &'a [f64],
    end: f64,
    method: Taylor<f64>,
}

impl Visitor for Motion<'_> {
    type Output = Record;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Record {
        let start = system.state(self.start);
        record(system.simulate(start).until(self.end).method(self.method).every(0.05).energy().run())
    }
}

/// Compares both forms from a state to a time, by default to 1e-9, including the kind of their end.
macro_rules! assert_same_bits {
    ($System:ident, $text:expr, $start:expr, $end:expr) => {
        assert_same_bits!($System, $text, $start, $end, Taylor::tolerance(1e-9), "Reached")
    };
    ($System:ident, $text:expr, $start:expr, $end:expr, $method:expr, $ending:expr) => {{
        let (start, end, method) = ($start, $end, Taylor { fused: false, ..$method });
        let compiled = $System::default();
        let expected = record(compiled.simulate(start).until(end).method(method).every(0.05).energy().run());
        let found = declared($text).visit(Motion { start: start.as_ref(), end, method });
        assert!(found.0[0].starts_with($ending), "{}", found.0[0]);
        assert_eq!(found, expected);
    }};
}

#[test]
fn free_systems_move_with_the_same_bits() {
    let start = [1.5, 1.5, 0.0, 0.0];
    for tolerance in [1e-2, 1e-6, 1e-12, 1e-15] {
        assert_same_bits!(
            DoublePendulum,
            DOUBLE_PENDULUM,
            start,
            3.0,
            Taylor::tolerance(tolerance),
            "Reached"
        );
    }
    assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, [0.0; 4], 1.0);
    assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, start, -2.0);
    assert_same_bits!(Kepler, KEPLER, [0.4, 0.0, 0.0, 2.0], 7.0);
    let chain = std::array::from_fn::<f64, 14, _>(|i| if i < 7 { 0.3 * i as f64 } else { 0.1 });
    assert_same_bits!(Chain, CHAIN, chain, 1.0);
    assert_same_bits!(Still, STILL, [1.0, 0.0], 1.0);
    assert_same_bits!(Still, STILL, [1.0, 2.0], 1.0);
}

/// Equations in blocks: six bodies with 18 of one unknown each, and two rods with one of three
/// unknowns each, beside a coordinate alone.
#[test]
fn uncoupled_equations_have_the_same_bits() {
    let start = std::array::from_fn::<f64, 36, _>(|entry| match entry / 6 {
        axis @ 0..3 => ((entry % 6) as f64 * (1.0 + axis as f64)).sin() * (1 + entry % 6) as f64,
        axis => 0.2 * ((entry % 6) as f64 - axis as f64).cos(),
    });
    for tolerance in [1e-3, 1e-9, 1e-14] {
        assert_same_bits!(Planets, PLANETS, start, 2.0, Taylor::tolerance(tolerance), "Reached");
    }
    let start = [0.6, 0.0, -0.8, 1.0, 0.3, 0.0, 0.5, 0.0, 0.0, 0.4];
    assert_same_bits!(Rods, RODS, start, 2.0);
}

#[test]
fn all_orders_have_the_same_bits() {
    for order in [4, 5, 6, 7, 23, 40] {
        let method = Taylor { order: Some(order), ..Taylor::tolerance(1e-7) };
        assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, [1.5, 1.5, 0.0, 0.0], 0.5, method, "Reached");
    }
    let method = Taylor { order: Some(3), ..Taylor::tolerance(1e-7) };
    assert_same_bits!(DoublePendulum, DOUBLE_PENDULUM, [1.5, 1.5, 0.0, 0.0], 0.5, method, "Failed");
}

#[test]
fn constraints_and_quaternions_hold_with_the_same_bits() {
    assert_same_bits!(Rod, ROD, [0.6, -0.8, 0.0, 0.0], 3.0);
    assert_same_bits!(Rod, ROD, [0.6, -0.7, 0.0, 0.0], 3.0, Taylor::tolerance(1e-9), "Failed");
    assert_same_bits!(StabilisedRod, STABILISED_ROD, [0.6, -0.8, 0.0, 0.0], 1.0);
    assert_same_bits!(Skate, SKATE, [0.0, 0.0, 0.0, 1.0, 0.0, 2.0], 1.0);
    assert_same_bits!(Top, TOP, [1.0, 0.0, 0.0, 0.0, 0.1, 3.0, 0.2], 2.0);
}

#[test]
fn tables_unknowns_and_states_move_with_the_same_bits() {
    assert_same_bits!(Wind, WIND, [0.0, 0.5], 4.0);
    assert_same_bits!(Wind, WIND, [3.0, 0.0], 4.0);
    assert_same_bits!(Implicit, IMPLICIT, [0.4, 0.0], 1.0);
    assert_same_bits!(Motor, MOTOR, [0.0, 0.2, 0.0], 2.0);
    // It is empty at 20/7, where the series ends.
    assert_same_bits!(Drain, DRAIN, [1.0], 4.0);
}

#[test]
fn interruptions_come_at_the_same_times() {
    assert_same_bits!(Bounce, BOUNCE, [1.0, 0.0], 5.0, Taylor::tolerance(1e-9), "Stopped");
}

#[test]
fn switches_change_sides_at_the_same_times() {
    assert_same_bits!(Kinks, KINKS, [1.0, 0.0], 4.0);
}

#[test]
fn clocks_and_modes_act_with_the_same_bits() {
    let start = [0.1, 20.0, 0.0, 0.0, 0.0];
    assert_same_bits!(Room, ROOM, start, 3.0);
    // Discrete states are held between ticks, which other methods do by themselves.
    let room = Room::default();
    let series = room.simulate(start).until(3.0).method(Taylor::tolerance(1e-11)).run().expect("a motion");
    let pair = room.simulate(start).until(3.0).tolerance(1e-12).run().expect("a motion");
    for (found, wanted) in series.last().iter().zip(pair.last()) {
        assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
    }
}

/// The end of a motion by name of the method, or its failure.
struct ByName(MethodChoice, Vec<f64>, f64);

impl Visitor for ByName {
    type Output = Result<Vec<f64>, String>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let ByName(method, start, until) = self;
        let settings = RunSettings { start, from: 0.0, until, every: None, method, has_energy: false };
        let motion = settings.run(system).map_err(|failure| failure.to_string())?;
        Ok(motion.last().as_ref().to_vec())
    }
}

fn by_name(text: &str, tolerance: Option<f64>, start: &[f64], until: f64) -> Result<Vec<f64>, String> {
    let method = MethodChoice::new(Some("taylor"), tolerance, None).expect("a method");
    declared(text).visit(ByName(method, start.to_vec(), until))
}

#[test]
fn ends_are_those_of_closed_forms() {
    // A revolution of a planet takes 2π a^(3/2); the drained level is (1 − 0.35 t)².
    let start = [0.4, 0.0, 0.0, 2.0];
    let end = by_name(KEPLER, Some(1e-15), &start, std::f64::consts::TAU).expect("a revolution");
    let error = end.iter().zip(start).fold(0.0_f64, |most, (found, wanted)| most.max((found - wanted).abs()));
    assert!(error < 1e-13, "{end:?}");
    let level = by_name(DRAIN, Some(1e-12), &[1.0], 2.0).expect("a level")[0];
    assert!((level - 0.09).abs() < 1e-12, "{level}");
    assert!((by_name(STILL, None, &[1.0, 2.0], 3.0).expect("a line")[0] - 7.0).abs() < 1e-14);
}

#[test]
fn systems_without_series_are_refused_with_the_reason() {
    let refused = |text: &str, start: &[f64]| by_name(text, None, start, 1.0).expect_err("refused");
    let plain = STILL.replace("emit { taylor }", "").replace("emit { taylor, }", "");
    assert!(refused(&plain, &[0.0; 2]).contains("does not emit `taylor`"), "{}", refused(&plain, &[0.0; 2]));
    let emit = "kinetic = 1/2 * dot(x)^2; emit { taylor }";
    for (part, word) in [
        ("coord x; noise push, density: 1; force x = push;", "noise"),
        ("coord x = 0; force x = -delay(x, 0.1);", "delay"),
    ] {
        let message = refused(&format!("{part} {emit}"), &[0.0; 2]);
        assert!(message.contains("`taylor` cannot be combined with") && message.contains(word), "{message}");
    }
    let redundant = "coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        constraint left = x; constraint below = y; constraint aslant = x + y; emit { taylor }";
    let message = refused(redundant, &[0.0; 4]);
    assert!(message.contains("constraints that follow from others"), "{message}");
    let indefinite =
        "coord x, y; lagrangian = dot(x) * dot(y) * (2 + sin(x)) + 1/2 * x * dot(x)^2; emit { taylor }";
    assert!(refused(indefinite, &[0.1; 4]).contains("`taylor` cannot be combined with"));
}

#[test]
fn settings_of_other_methods_are_refused() {
    let refused = |tolerance, step| {
        let error = MethodChoice::new(Some("taylor"), tolerance, step).expect_err("refused");
        error.to_string()
    };
    assert_eq!(refused(None, Some(0.1)), "the method `taylor` has no `step`");
    for tolerance in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let message = by_name(STILL, Some(tolerance), &[0.0; 2], 1.0).expect_err("no tolerance");
        assert!(message.contains("tolerance"), "{message}");
    }
}

/// A motion whose inputs come from a law.
struct Lawful;

impl Visitor for Lawful {
    type Output = String;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> String {
        let start = system.state(&[0.0; 3]);
        let simulation = system
            .simulate(start)
            .until(1.0)
            .drive(|_: &DynamicSystem<CAPACITY>, t, _| lagrange::system::StateVector::of(&[t]));
        let method = MethodChoice::Taylor { tolerance: 1e-9 };
        method.run(simulation).expect_err("refused").to_string()
    }
}

#[test]
fn laws_are_refused() {
    let message = declared(MOTOR).visit(Lawful);
    assert!(message.contains("inputs that change: take `verner`"), "{message}");
}
