//! The cost of event detection: a double pendulum for ten seconds with the adaptive method. The
//! variants are no events, some that are smooth along steps, and one that is much faster than the
//! motion.
//!
//! Steps without event functions to evaluate need no interpolant. All others need eleven further
//! evaluations of the right-hand side, and at least eight of the event functions.

use std::hint::black_box;
use std::time::Duration;

use criterion::{Criterion, criterion_group, criterion_main};
use lagrange::Simulate;
use lagrange::event::Direction;

lagrange::system! {
    pub struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

const SWING: [f64; 4] = [1.0, 1.5, 0.0, 0.0];

/// Counts the zero crossings of the functions.
fn crossings(functions: &[fn(f64, &[f64; 4]) -> f64]) -> usize {
    let pendulum = black_box(DoublePendulum::default());
    let mut run = pendulum.simulate(SWING).until(10.0).ends_only().tolerance(1e-9);
    for function in functions {
        run = run.event("crossing", Direction::Crossing, move |_, t, y| function(t, y));
    }
    run.run().expect("a finite motion").events().len()
}

fn events(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("events along ten seconds");
    group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(2));
    group.bench_function("none", |b| b.iter(|| crossings(&[])));
    group.bench_function("one, smooth", |b| b.iter(|| crossings(&[|_, y| y[0]])));
    group.bench_function("four, smooth", |b| {
        b.iter(|| crossings(&[|_, y| y[0], |_, y| y[1], |_, y| y[2], |_, y| y[3]]));
    });
    group.bench_function("one, sin 200 t", |b| b.iter(|| crossings(&[|t, _| (200.0 * t).sin()])));
    group.finish();
}

criterion_group!(benches, events);
criterion_main!(benches);
