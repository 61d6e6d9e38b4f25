//! Jacobians of right-hand sides: emitted ones against differences of the right-hand side.
//!
//! Differences take one evaluation for each entry of the state beside the one at the state itself,
//! and lose half of the digits. Each case is one Jacobian at a state unknown to the compiler.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use lagrange::system::OdeSystem;

lagrange::system! {
    pub struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    emit { jacobian, no parameter_jacobian }
}

lagrange::system! {
    /// Five links in absolute angles.
    pub struct Chain;

    param m = 1.0, l = 0.5, g = 9.81;
    coord q1, q2, q3, q4, q5;

    let p1 = (l * sin(q1), -l * cos(q1));
    let p2 = p1 + (l * sin(q2), -l * cos(q2));
    let p3 = p2 + (l * sin(q3), -l * cos(q3));
    let p4 = p3 + (l * sin(q4), -l * cos(q4));
    let p5 = p4 + (l * sin(q5), -l * cos(q5));
    kinetic = kinetic_energy(m, dot(p1)) + kinetic_energy(m, dot(p2)) + kinetic_energy(m, dot(p3));
    kinetic = kinetic_energy(m, dot(p4)) + kinetic_energy(m, dot(p5));
    potential = gravitational_energy(m, g, p1.y + p2.y + p3.y + p4.y + p5.y);
    emit { jacobian, no parameter_jacobian }
}

/// Computes the Jacobian by first-order differences.
fn differences<M, const K: usize>(system: &M, y: &[f64; K]) -> [[f64; K]; K]
where
    M: OdeSystem<Scalar = f64, State = [f64; K]>,
{
    let rate = system.rhs(0.0, y);
    let mut jacobian = [[0.0; K]; K];
    for j in 0..K {
        let mut moved = *y;
        moved[j] += 1e-8 * y[j].abs().max(1.0);
        let step = moved[j] - y[j];
        for (row, (after, before)) in jacobian.iter_mut().zip(system.rhs(0.0, &moved).iter().zip(&rate)) {
            row[j] = (after - before) / step;
        }
    }
    jacobian
}

fn compare<M, const K: usize>(criterion: &mut Criterion, name: &str, system: &M)
where
    M: OdeSystem<Scalar = f64, State = [f64; K]>,
{
    let y = std::array::from_fn(|i| 0.3 + 0.17 * i as f64);
    let mut group = criterion.benchmark_group(name);
    group.bench_function("right-hand side", |bencher| {
        bencher.iter(|| black_box(system).rhs(0.0, black_box(&y)));
    });
    group.bench_function("emitted", |bencher| {
        bencher.iter(|| black_box(system).jacobian(0.0, black_box(&y)));
    });
    group.bench_function("differences", |bencher| {
        bencher.iter(|| differences(black_box(system), black_box(&y)));
    });
}

fn jacobians(criterion: &mut Criterion) {
    compare(criterion, "double pendulum", &DoublePendulum::default());
    compare(criterion, "chain of 5", &Chain::default());
}

criterion_group!(benches, jacobians);
criterion_main!(benches);
