//! Ensembles of double pendulums of 10 s beside a loop of single runs that is written by hand, and threads beside each other.
//!
//! Every way computes the same motions in each round, in turns, so that all see the same load: times are minima, ratios medians over the
//! rounds of the time over that of the loop.

use std::hint::black_box;
use std::time::Instant;

use lagrange::ensemble::{Moments, Random};
use lagrange::{Ensembles, Simulate};

lagrange::system! {
    #[derive(Clone)]
    pub struct DoublePendulum;

    param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
    coord theta1, theta2;

    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

const MOTIONS: usize = 256;
const ROUNDS: usize = 61;
const UNTIL: f64 = 10.0;
const SEED: u64 = 7;

fn start(_: usize, random: &mut Random) -> [f64; 4] {
    [2.0 + 0.1 * random.normal(), 2.0, 0.0, 0.0]
}

/// Ends of single runs, one after the other.
fn by_hand(pendulum: &DoublePendulum, tolerance: f64) -> f64 {
    let ends = (0..MOTIONS).map(|index| {
        let run = pendulum.simulate(start(index, &mut Random::new(SEED, index))).until(UNTIL);
        run.tolerance(tolerance).ends_only().run().expect("runs").last()
    });
    ends.collect::<Vec<_>>()[MOTIONS - 1][0]
}

fn ends(pendulum: &DoublePendulum, tolerance: f64, threads: usize) -> f64 {
    let ensemble = pendulum.ensemble(MOTIONS).start(start).until(UNTIL).tolerance(tolerance);
    ensemble.seed(SEED).threads(threads).run().expect("runs").theta1()[MOTIONS - 1]
}

fn reduced(pendulum: &DoublePendulum, tolerance: f64) -> f64 {
    let ensemble = pendulum.ensemble(MOTIONS).start(start).until(UNTIL).tolerance(tolerance).seed(SEED);
    let reduced =
        ensemble.threads(1).reduce(Moments::new(), |moments, motion| moments.add(motion.end().theta1));
    reduced.expect("runs").mean()
}

/// Microseconds a motion.
fn time(compute: &dyn Fn() -> f64) -> f64 {
    let began = Instant::now();
    black_box(compute());
    began.elapsed().as_secs_f64() * 1e6 / MOTIONS as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn measure(tolerance: f64) {
    let pendulum = black_box(DoublePendulum::default());
    let ways: [(&str, &dyn Fn() -> f64); 4] = [
        ("loop of single runs", &|| by_hand(&pendulum, tolerance)),
        ("ensemble, 1 thread", &|| ends(&pendulum, tolerance, 1)),
        ("ensemble, 1 thread, reduced", &|| reduced(&pendulum, tolerance)),
        ("ensemble, 2 threads", &|| ends(&pendulum, tolerance, 2)),
    ];
    let rounds: Vec<_> = (0..ROUNDS).map(|_| ways.map(|(_, compute)| time(compute))).collect();
    for (index, (name, _)) in ways.iter().enumerate() {
        let least = rounds.iter().map(|times| times[index]).fold(f64::INFINITY, f64::min);
        let ratio = median(rounds.iter().map(|times| times[index] / times[0]).collect());
        println!("| {tolerance:.0e} | {name:27} | {least:7.1} | {ratio:.3} |");
    }
}

fn main() {
    println!(
        "| tolerance | {MOTIONS} double pendulums of {UNTIL} s | µs a motion | to the loop |\n|---|---|---|---|"
    );
    [1e-6, 1e-9].into_iter().for_each(measure);
}
