//! Motions with contacts, friction and events of declarations.

use lagrange::Simulate;
use lagrange::contact::{Contact, EventKind, Friction};
use lagrange::event::Direction;
use lagrange::integrate::{GaussLegendre4, Method, RungeKutta4, Variational, Verner98, integrate};
use lagrange::simulate::Ending;

lagrange::system! {
    /// A ball above a floor.
    #[derive(Clone, Debug)]
    struct Ball;

    param m = 2.0, g = 9.81, e = 0.8;
    coord y;
    kinetic = 1/2 * m * dot(y)^2;
    potential = m * g * y;
    event floor = y, falling => impact(e);
    output press = floor;
}

lagrange::system! {
    /// A block that slides on a floor, is stopped by a wall and turned back by a gate.
    #[derive(Clone, Debug)]
    struct Block;

    param m = 2.0, g = 9.81, mu = 0.25, pull = 0.0;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    force x = pull * t;
    event floor = y, falling => impact(0);
    event gate = x - 1, rising => { dot(x) = -dot(x) / 2; };
    event turn = dot(x), falling => record;
    event wall = x + 4, falling => stop;
    friction rub = dot(x), kinetic: mu * floor, static: 1.2 * mu * floor;
}

lagrange::system! {
    /// A bead on a parabola, with a stop.
    #[derive(Clone, Debug)]
    struct Bead;

    param m = 1.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint wire = y - x^2;
    event stop_block = x + 1/2, falling => impact(1);
}

#[test]
fn a_declared_ball_comes_to_rest_and_is_carried() {
    let ball = Ball::default();
    let run = ball
        .simulate([1.0, 0.0])
        .until(5.0)
        .tolerance(1e-12)
        .observe("press", |ball, t, y| ball.press(t, &[y[0]], &[y[1]]));
    let trajectory = run.run().expect("no hang and no error");
    let Some(EventKind::Closed { at, .. }) = trajectory.events().last().map(|event| event.kind) else {
        panic!("{:?}", trajectory.events().last())
    };
    assert!((at - 4.063_712_768_871_58).abs() < 1e-11, "{at}");
    assert_eq!(trajectory.system_at_end().map(|ball| ball.floor), Some(Contact::Closed));
    let force = trajectory.column("press").expect("observed");
    assert_eq!(force[0], 0.0);
    crate::assert_close(force[force.len() - 1], 2.0 * 9.81);
    let end = integrate(&ball, 0.0, [1.0, 0.0], 5.0, &RungeKutta4 { step: 1e-2 }, |_, _| {}).expect("runs");
    assert!(end.iter().all(|entry| entry.abs() < 1e-12), "{end:?}");
}

#[test]
fn declared_events_record_replace_and_stop() {
    let block = Block { mu: 0.0, pull: -0.5, ..Block::default() };
    let trajectory = block.simulate([0.0, 0.0, 2.0, 0.0]).until(20.0).tolerance(1e-12).run().expect("runs");
    let names: Vec<&str> = trajectory.events().iter().map(|event| event.name.as_str()).collect();
    assert_eq!(names, ["gate", "wall"]);
    assert_eq!(trajectory.ending(), Ending::Stopped);
    assert!((trajectory.last()[0] + 4.0).abs() < 1e-11);
    let before = trajectory.events()[0].state;
    let after =
        trajectory.iter().find(|(t, y)| *t == trajectory.events()[0].time && y[2] < 0.0).expect("a sample");
    crate::assert_close(after.1[2], -before[2] / 2.0);
}

#[test]
fn a_declared_block_stops_and_starts_again() {
    let block = Block { pull: 1.0, ..Block::default() };
    let trajectory = block.simulate([-3.0, 0.0, 1.0, 0.0]).until(7.0).tolerance(1e-12).run().expect("runs");
    // At rest, a rounding error of the velocity is no change of its sign.
    assert_eq!(
        trajectory.events().iter().map(|event| event.name.as_str()).collect::<Vec<_>>(),
        ["turn", "rub", "rub"]
    );
    let rubbing: Vec<_> = trajectory.events().iter().filter(|event| event.name == "rub").collect();
    assert_eq!(rubbing[0].kind, EventKind::Stuck);
    assert_eq!(rubbing[1].kind, EventKind::Slipped);
    let gives_way = rubbing[1].time;
    assert!((gives_way - 1.2 * 0.25 * 2.0 * 9.81).abs() < 1e-11, "{gives_way}");
    let end = trajectory.system_at_end().expect("switched");
    assert_eq!((end.floor, end.rub), (Contact::Closed, Friction::SlipsForwards));
}

/// The bead's speed along the wire is reversed without loss, and the bead stays on the wire.
#[test]
fn an_impact_within_a_mechanism_keeps_its_constraints() {
    let bead = Bead::default();
    let trajectory =
        bead.simulate([1.0, 1.0, 0.0, 0.0]).until(5.0).tolerance(1e-12).energy().run().expect("runs");
    assert_eq!(trajectory.events().len(), 3);
    for (t, [x, y, u, v]) in trajectory.iter() {
        assert!((y - x * x).abs() < 1e-10 && (v - 2.0 * x * u).abs() < 1e-9, "off the wire at {t}");
    }
    let energy = trajectory.column("energy").expect("asked for");
    assert!(energy.iter().all(|now| (now - energy[0]).abs() < 1e-8), "an elastic impact loses nothing");
    assert!(trajectory.iter().all(|(_, [x, ..])| x > -0.5 - 1e-9));
}

/// The wire and its rate are zero up to rounding, whose sign changes at random. The bead passes the
/// lowest point, which is counted, once in half a period.
#[test]
fn what_a_constraint_holds_at_zero_has_no_events() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        let bead = Bead::default();
        let run = bead.simulate([0.4, 0.16, 0.0, 0.0]).until(5.0).tolerance(tolerance);
        let trajectory = run
            .event("wire", Direction::Crossing, |_, _, [x, y, ..]| y - x * x)
            .event("rate", Direction::Crossing, |_, _, [x, _, u, v]| v - 2.0 * x * u)
            .event("lowest", Direction::Crossing, |_, _, [x, ..]| *x)
            .run()
            .expect("runs");
        let sides: Vec<f64> = trajectory.iter().map(|(_, [x, ..])| x.signum()).collect();
        let passes = sides.windows(2).filter(|pair| pair[0] != pair[1]).count();
        let names: Vec<&str> = trajectory.events().iter().map(|event| event.name.as_str()).collect();
        assert!(passes >= 6, "{passes}");
        assert_eq!(names, vec!["lowest"; passes], "{tolerance}");
    }
}

#[test]
fn given_events_see_the_system_as_it_is_then() {
    let mut modes = Vec::new();
    Ball { e: 0.0, ..Ball::default() }
        .simulate([1.0, 0.0])
        .until(2.0)
        .event_with(
            "look",
            Direction::Rising,
            |_, t, _| (t - 0.3) * (t - 1.0) * (t - 1.5),
            |ball, _| {
                modes.push(ball.floor);
                lagrange::event::Action::Continue
            },
        )
        .run()
        .expect("runs");
    assert_eq!(modes, [Contact::Open, Contact::Closed]);
}

lagrange::system! {
    /// A block that falls onto a rough table and slides to rest, with momenta.
    #[derive(Clone, Debug)]
    struct Sliding;

    param m = 2.0, g = 9.81, mu = 0.25;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    event table = y - 5, falling => impact(0);
    friction rub = dot(x), mu * table;
    emit { momentum_rates }
}

/// Checks that a method that integrates momenta includes contacts and friction, or refuses.
fn comes_to_rest(method: impl Method<Sliding>) {
    let sliding = Sliding::default();
    let simulation = sliding.simulate([0.0, 6.0, 3.0, 0.0]).until(3.0).method(method);
    let trajectory = simulation.run().expect("runs");
    let found: Vec<_> = trajectory.events().iter().map(|event| event.name.as_str()).collect();
    assert_eq!(found, ["table", "rub"], "{}", trajectory.method());
    let [_, y, u, v] = trajectory.last();
    assert!((y - 5.0).abs() < 1e-9 && u.abs() < 1e-9 && v.abs() < 1e-9, "{:?}", trajectory.last());
    // The impact takes μ of the momentum that it stops, friction the rest: u = 3 − μ (√(2 g) + g
    // t).
    let fall = (2.0_f64 / 9.81).sqrt();
    let stop = fall + (3.0 - 0.25 * (2.0_f64 * 9.81).sqrt()) / (0.25 * 9.81);
    assert!((trajectory.events()[1].time - stop).abs() < 1e-10, "{}", trajectory.events()[1].time);
}

#[test]
fn every_family_of_methods_feels_contacts() {
    let step = 1e-2;
    comes_to_rest(Verner98::tolerance(1e-10));
    comes_to_rest(RungeKutta4 { step });
    comes_to_rest(GaussLegendre4 { step });
    comes_to_rest(GaussLegendre4 { step }.plain());
    comes_to_rest(Variational { step });
}

lagrange::system! {
    /// A ball above a shelf, in single precision.
    #[scalar(f32)]
    struct Light;

    param g = 9.81, e = 0.8;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event shelf = y - 5, falling => impact(e);
}

lagrange::system! {
    /// A ball above a shelf.
    struct Heavy;

    param g = 9.81, e = 0.8;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event shelf = y - 5, falling => impact(e);
}

/// Returns the time at which a ball dropped from 1 m comes to rest: √(2/g) (1 + e)/(1 − e).
fn rest(e: f64) -> f64 {
    (2.0 / 9.81_f64).sqrt() * (1.0 + e) / (1.0 - e)
}

#[test]
fn balls_come_to_rest_wherever_the_floor_is_and_however_they_bounce() {
    for e in [0.1, 0.5, 0.8, 0.95, 0.99] {
        let ball = Heavy { e, ..Heavy::default() };
        let end = rest(e) + 1.0;
        let trajectory =
            ball.simulate([6.0, 0.0]).until(end).tolerance(1e-12).ends_only().run().expect("runs");
        let Some(EventKind::Closed { at, .. }) = trajectory.events().last().map(|event| event.kind) else {
            panic!("{:?} for {e}", trajectory.events().last())
        };
        // Heights are rounded to 10⁻¹⁵. For small speeds this corresponds to longer times, which
        // accumulate over later bounces.
        assert!((at - rest(e)).abs() < 2e-9 / (1.0 - e), "{at} for {e}");
        assert_eq!(trajectory.last(), [5.0, 0.0]);
    }
}

#[test]
fn a_ball_in_single_precision_comes_to_rest() {
    let light = Light::default();
    let trajectory = light.simulate([6.0, 0.0]).until(6.0).run().expect("runs");
    let Some(EventKind::Closed { at, .. }) = trajectory.events().last().map(|event| event.kind) else {
        panic!("{:?}", trajectory.events().last())
    };
    assert!((f64::from(at) - rest(0.8)).abs() < 1e-3, "{at}");
    assert_eq!(trajectory.last(), [5.0, 0.0]);
}

lagrange::system! {
    /// A block that slides on a rough floor towards a wall.
    struct Walled;

    param m = 2.0, g = 9.81, mu = 0.25, e = 0.5;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    event floor = y, falling => impact(0);
    event wall = 1 - x, falling => impact(e);
    friction rub = dot(x), mu * floor;
}

#[test]
fn a_block_that_lies_is_thrown_back_by_a_wall() {
    let walled = Walled::default();
    let trajectory = walled.simulate([0.0, 0.0, 3.0, 0.0]).until(3.0).tolerance(1e-12).run().expect("runs");
    let names: Vec<_> = trajectory.events().iter().map(|event| event.name.as_str()).collect();
    assert_eq!(names, ["wall", "rub"]);
    let slowing = 0.25 * 9.81;
    let hit = (9.0_f64 - 2.0 * slowing).sqrt();
    let [x, y, u, v] = trajectory.last();
    assert!((x - (1.0 - 0.25 * hit * hit / (2.0 * slowing))).abs() < 1e-11, "{x}");
    assert!(y == 0.0 && u.abs() < 1e-15 && v.abs() < 1e-15);
    let EventKind::Impact(impact) = trajectory.events()[0].kind else { panic!("no impact") };
    assert!((impact.impulse - 2.0 * 1.5 * hit).abs() < 1e-11);
    assert!((impact.energy_loss - 0.75 * hit * hit).abs() < 1e-11);
    let end = trajectory.system_at_end().expect("switched");
    assert_eq!((end.floor, end.wall, end.rub), (Contact::Closed, Contact::Open, Friction::Sticks));
}

lagrange::system! {
    /// A block on a surface that is smooth up to x = 1 and increasingly rough beyond.
    struct Rougher;

    param m = 2.0, c = 3.0, pull = 0.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    force x = pull * t;
    friction rough = dot(x), if x < 1 { 0 } else { c * (x - 1) };
}

#[test]
fn friction_that_begins_on_the_way_is_met_and_is_no_event() {
    let rougher = Rougher::default();
    let trajectory = rougher.simulate([0.0, 2.0]).until(4.0).tolerance(1e-12).run().expect("runs");
    let [event] = trajectory.events() else { panic!("{:?}", trajectory.events()) };
    assert_eq!((event.name.as_str(), event.kind), ("rough", EventKind::Stuck));
    // A quarter period about x = 1 with ω = √(c/m).
    let omega = (3.0_f64 / 2.0).sqrt();
    assert!((trajectory.last()[0] - (1.0 + 2.0 / omega)).abs() < 1e-10);
    assert!((event.time - (0.5 + 0.5 * std::f64::consts::PI / omega)).abs() < 1e-9, "{}", event.time);
    // Any force moves a body that rests on the smooth part.
    let pulled = Rougher { pull: 1.0, ..rougher };
    let trajectory = pulled.simulate([0.0, 0.0]).until(1.5).tolerance(1e-12).run().expect("runs");
    assert!((trajectory.last()[0] - 1.5_f64.powi(3) / 12.0).abs() < 1e-12);
}
