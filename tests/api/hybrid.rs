//! Motions with contacts, friction and events of declarations.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction, Happening};
use lagrange::event::Direction;
use lagrange::integrate::{RungeKutta4, integrate};
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
    let Some(Happening::Closed { at, .. }) = trajectory.events().last().map(|event| event.happening) else {
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
    let rubbing: Vec<_> = trajectory.events().iter().filter(|event| event.name == "rub").collect();
    assert_eq!(rubbing[0].happening, Happening::Stuck);
    assert_eq!(rubbing[1].happening, Happening::Slipped);
    let gives_way = rubbing[1].time;
    assert!((gives_way - 1.2 * 0.25 * 2.0 * 9.81).abs() < 1e-11, "{gives_way}");
    let end = trajectory.system_at_end().expect("switched");
    assert_eq!((end.floor, end.rub), (Contact::Closed, Friction::SlipsForwards));
}

/// The bead's speed along the wire is turned round without loss, and it stays on the wire.
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
                lagrange::event::Reaction::Continue
            },
        )
        .run()
        .expect("runs");
    assert_eq!(modes, [Contact::Open, Contact::Closed]);
}
