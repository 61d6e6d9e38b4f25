//! Bodies at rest in contacts, where gaps and velocities are rounding errors.

use lagrange::Simulate;
use lagrange::contact::Contact;
use lagrange::integrate::{RungeKutta4, integrate};

lagrange::system! {
    /// A ball above a floor.
    #[derive(Clone, Debug)]
    struct Ball;

    param m = 2.0, g = 9.81, e = 0.8;
    coord y;
    kinetic = 1/2 * m * dot(y)^2;
    potential = m * g * y;
    event floor = y, falling => impact(e);
}

lagrange::system! {
    /// A point between a floor and a wall, off which it does not bounce.
    #[derive(Clone, Debug)]
    struct Corner;

    param g = 9.81, push = 0.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    force x = push * t;
    event floor = y, falling => impact(0);
    event wall = x - 1, rising => impact(0);
}

lagrange::system! {
    /// A bench on three legs, one more than needed, with friction at two of them.
    #[derive(Clone, Debug)]
    struct Bench;

    param m = 1.0, g = 9.81, j = 0.2, a = 0.5, mu = 0.3;
    coord x, y, th;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/2 * j * dot(th)^2;
    potential = m * g * y;
    event left = y - a * sin(th), falling => impact(0.3);
    event middle = y, falling => impact(0.3);
    event right = y + a * sin(th), falling => impact(0.3);
    friction rub_left = dot(x), mu * left;
    friction rub_right = dot(x), mu * right;
    output load = left + middle + right;
}

lagrange::system! {
    /// A pendulum that comes to lie on the floor, held by the rod, the floor and friction.
    #[derive(Clone, Debug)]
    struct Lying;

    param g = 9.81;
    coord x, y;
    kinetic = dot(x)^2 + dot(y)^2;
    potential = 2 * g * y;
    constraint rod = x^2 + y^2 - 1;
    event floor = y + 0.9, falling => impact(0.5);
    friction rub = dot(x), 0.1 * floor;
}

/// The remainder of a gap that is a coordinate has no other terms to which it could be compared.
#[test]
fn a_ball_at_rest_continues_from_the_end_of_its_run() {
    for m in [0.2, 1.0, 5.0] {
        let rested = Ball { m, ..Ball::default() }
            .simulate([1.0, 0.0])
            .until(6.0)
            .tolerance(1e-12)
            .run()
            .expect("runs");
        let ball = rested.system_at_end().expect("closed");
        let end = ball.simulate(rested.last()).until(1.0).run().expect("rests").last();
        assert!(end.iter().all(|entry| entry.abs() < 1e-15), "{end:?}");
    }
    let touching = Ball::default().simulate([-1e-20, 0.0]).until(1.0).run().expect("rests").last();
    assert!(touching.iter().all(|entry| entry.abs() < 1e-15), "{touching:?}");
    assert!(Ball::default().simulate([-1e-12, 0.0]).until(1.0).run().is_err());
}

/// At first nothing presses the point against the wall. Then the rounded gap must not cause
/// repeated impacts.
#[test]
fn a_point_that_touches_without_pressing_is_left_alone() {
    let corner = Corner { push: 0.0, ..Corner::default() };
    let start = [0.3, 0.6, 1.7, 0.4];
    let end = corner.simulate(start).until(20.0).tolerance(1e-10).run().expect("runs").last();
    assert!((end[0] - 1.0).abs() < 1e-12 && end[1..].iter().all(|entry| entry.abs() < 1e-12), "{end:?}");
    let pushed = Corner { push: 0.5, ..Corner::default() };
    let trajectory = pushed.simulate(start).until(20.0).tolerance(1e-10).run().expect("runs");
    assert!((trajectory.last()[0] - 1.0).abs() < 1e-12, "{:?}", trajectory.last());
    assert_eq!(trajectory.system_at_end().map(|corner| corner.wall), Some(Contact::Closed));
}

#[test]
fn a_bench_with_a_leg_too_many_comes_to_rest() {
    for start in [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.2], [0.0, 0.5, -0.3], [0.0, 2.0, 1e-3]] {
        let [x, y, th] = start;
        let run = Bench::default().simulate([x, y, th, 1.0, 0.0, 0.0]).until(4.0).tolerance(1e-10).run();
        let run = run.unwrap_or_else(|error| panic!("{error} from {start:?}"));
        let (bench, [_, rest @ ..]) = (run.system_at_end().expect("it touches"), run.last());
        assert!(rest.iter().all(|entry| entry.abs() < 1e-12), "{rest:?}");
        let [x, y, th, u, v, w] = run.last();
        crate::assert_close(bench.load(4.0, &[x, y, th], &[u, v, w]), 9.81);
    }
}

#[test]
fn velocities_that_are_rounding_do_not_turn_into_nan() {
    let end = integrate(
        &Lying::default(),
        0.0,
        [0.6, -0.8, 0.8, 0.6],
        10.0,
        &RungeKutta4 { step: 1e-2 },
        |_, _| {},
    );
    let [x, y, velocities @ ..] = end.expect("comes to rest");
    assert!((x - 0.19_f64.sqrt()).abs() < 1e-12 && (y + 0.9).abs() < 1e-12, "{x} {y}");
    assert!(velocities.iter().all(|v| v.abs() < 1e-15), "{velocities:?}");
}

/// The rod and the floor share a force, half of which would exceed friction. Friction is at its
/// limit, but does not slip.
#[test]
fn friction_at_its_limit_where_a_contact_holds_the_slip_is_left_alone() {
    let start = [0.6, -0.8, 0.8, 0.6];
    let run = Lying::default().simulate(start).until(10.0).tolerance(1e-10).run().expect("comes to rest");
    assert!(run.events().len() < 60, "{} events", run.events().len());
    let [x, y, velocities @ ..] = run.last();
    assert!((x - 0.19_f64.sqrt()).abs() < 1e-12 && (y + 0.9).abs() < 1e-12, "{x} {y}");
    assert!(velocities.iter().all(|v| v.abs() < 1e-13), "{velocities:?}");
}

lagrange::system! {
    /// A parallelogram of cranks, which can be stretched into a line.
    #[derive(Clone, Debug)]
    struct Parallelogram;

    coord p, q, r;
    let (x1, y1) = (cos(p), sin(p));
    let (x2, y2) = (x1 + 2 * cos(q), y1 + 2 * sin(q));
    let (x3, y3) = (x2 + cos(r), y2 + sin(r));
    kinetic = 1/2 * (dot(x1)^2 + dot(y1)^2 + dot(x2)^2 + dot(y2)^2) + 1/20 * dot(q)^2;
    constraint across = x3 - 2;
    constraint up = y3;
}

/// In a line the gradient of a constraint vanishes up to rounding.
#[test]
fn a_start_is_not_refused_because_a_gradient_is_rounding() {
    let start = [0.0, 0.0, std::f64::consts::PI, 1.0, 0.0, 1.0];
    let run = Parallelogram.simulate(start).until(1.0).tolerance(1e-10).run().expect("starts");
    let [p, q, ..] = run.last();
    assert!((p - 1.0).abs() < 1e-6 && q.abs() < 1e-6, "{:?}", run.last());
}

lagrange::system! {
    /// A ball on a shelf whose height is a sum of lengths.
    #[derive(Clone, Debug)]
    struct Shelf;

    param g = 9.81, a = 0.1, b = 0.2, c = 0.3;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    event shelf = y + c - (a + b), falling => impact(1/2);
}

/// If the coordinates are zero, the gap is the rounding error of parameters that are lengths.
#[test]
fn a_start_where_all_coordinates_are_zero_may_be_rounding_below_the_floor() {
    for (a, b, c) in [(0.1, 0.2, 0.3), (0.1, 0.7, 0.8), (1.1, 2.2, 3.3), (0.3, 0.3, 0.6)] {
        let shelf = Shelf { a, b, c, ..Shelf::default() };
        let run = shelf.simulate([0.0; 4]).until(1.0).run();
        let end = run.unwrap_or_else(|error| panic!("{error} for {a}, {b}, {c}")).last();
        assert!(end.iter().all(|entry| entry.abs() < 1e-15), "{end:?}");
    }
    let below = Shelf { c: 0.3 - 1e-9, ..Shelf::default() };
    assert!(below.simulate([0.0; 4]).until(1.0).run().is_err());
}

lagrange::system! {
    /// A block that rocks on its two feet.
    #[derive(Clone, Debug)]
    struct Rocking;

    param m = 2.0, a = 0.3, b = 0.5, g = 9.81, mu = 1.5;
    coord x, y, phi;
    gravity = (0, -g);
    line floor { angle: 0; }
    body block { mass: m; center: (x, y); angle: phi; shape: rectangle(2 * a, 2 * b); }
    event left = floor.distance(block.point(-a, -b)), falling => impact(0);
    event right = floor.distance(block.point(a, -b)), falling => impact(0);
    friction rub_left = dot(floor.along(block.point(-a, -b))), mu * left;
    friction rub_right = dot(floor.along(block.point(a, -b))), mu * right;
}

/// A block that rocks without slipping keeps the fraction `r = 1 − 3/2 sin² α` of its rate at each
/// impact. Here α is the angle at its corner (Housner, *Bull. Seismol. Soc. Am.* 53 (1963)
/// 403–417). So it comes to rest on both feet after infinitely many impacts.
#[test]
fn a_block_that_rocks_from_foot_to_foot_comes_to_rest_on_both() {
    for (a, mu) in [(0.3_f64, 1.0), (0.3, 2.0), (0.15, 0.8), (0.15, 1.2)] {
        let block = Rocking { a, mu, ..Rocking::default() };
        let phi = 0.3 * a;
        let start = [0.0, 0.5 * f64::cos(phi) + a * f64::sin(phi), phi, 0.0, 0.0, 0.0];
        let run = block.simulate(start).until(6.0).tolerance(1e-12).max_steps(2_000).run();
        let run = run.unwrap_or_else(|error| panic!("{error} with {a} and {mu}"));
        let left = 1.0 - 1.5 * a * a / (a * a + 0.25);
        let rates = run.events().iter().map(|event| event.state[5].abs()).collect::<Vec<_>>();
        assert!(rates.len() > 20, "{} impacts", rates.len());
        for pair in rates[..rates.len() - 1].windows(2).filter(|pair| pair[1] > 1e-4) {
            // The rounding error of the energy weighs more, the less energy is left.
            let rounding = 1e-10 + 1e-13 / (pair[0] * pair[0]);
            assert!((pair[1] / pair[0] - left).abs() < rounding, "{} for {left}", pair[1] / pair[0]);
        }
        let [_, y, phi, velocities @ ..] = run.last();
        assert!((y - 0.5).abs() < 1e-12 && phi.abs() < 1e-12, "{y} {phi}");
        assert!(velocities.iter().all(|v| v.abs() < 1e-14), "{velocities:?}");
        let block = run.system_at_end().expect("it touches");
        assert_eq!((block.left, block.right), (Contact::Closed, Contact::Closed));
    }
}
