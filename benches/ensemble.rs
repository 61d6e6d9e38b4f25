//! Ensembles of 10 s, in lanes and one by one, beside a loop of single runs that is written by hand, and threads beside each other.
//!
//! Every way computes the same motions in each round, in turns, so that all see the same load: times are minima, ratios medians over the
//! rounds of the time of the first way over that of another.

use std::hint::black_box;
use std::time::Instant;

use lagrange::ensemble::{Ensemble, Moments, Random, SharedSystem};
use lagrange::integrate::{RungeKutta4, Verner98};
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
    emit { lanes }
}

lagrange::system! {
    #[derive(Clone)]
    pub struct CartPole;

    param m_cart = 1.0, m = 0.1, l = 0.5, g = 9.81;
    coord x, theta;

    let (x_bob, y_bob) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * m_cart * dot(x)^2 + 1/2 * m * (dot(x_bob)^2 + dot(y_bob)^2);
    potential = m * g * y_bob;
    emit { lanes }
}

const MOTIONS: usize = 1024;
const ROUNDS: usize = 21;
const UNTIL: f64 = 10.0;
const SEED: u64 = 7;
const STEP: f64 = 0.01;

fn start(_: usize, random: &mut Random) -> [f64; 4] {
    [2.0 + 0.1 * random.normal(), 2.0, 0.0, 0.0]
}

/// A system with two coordinates.
trait Subject: SharedSystem<Scalar = f64, State = [f64; 4]> {}

impl<M: SharedSystem<Scalar = f64, State = [f64; 4]>> Subject for M {}

/// Ends of single runs, one after the other.
fn by_hand<M: Subject>(system: &M, tolerance: f64) -> f64 {
    let ends = (0..MOTIONS).map(|index| {
        let run = system.simulate(start(index, &mut Random::new(SEED, index))).until(UNTIL);
        run.tolerance(tolerance).ends_only().run().expect("runs").last()
    });
    ends.collect::<Vec<_>>()[MOTIONS - 1][0]
}

fn ensemble<M: Subject>(system: &M, tolerance: f64, threads: usize) -> Ensemble<'_, M, Verner98<f64>> {
    system.ensemble(MOTIONS).start(start).until(UNTIL).tolerance(tolerance).seed(SEED).threads(threads)
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

/// The ways, in turns.
fn measure<const N: usize>(what: &str, ways: [(&str, &dyn Fn() -> f64); N]) {
    let rounds: Vec<_> = (0..ROUNDS).map(|_| ways.map(|(_, compute)| time(compute))).collect();
    for (index, (name, _)) in ways.iter().enumerate() {
        let least = rounds.iter().map(|times| times[index]).fold(f64::INFINITY, f64::min);
        let ratio = median(rounds.iter().map(|times| times[0] / times[index]).collect());
        println!("| {what:20} | {name:27} | {least:7.1} | {ratio:.2} |");
    }
}

fn measure_all<M: Subject>(name: &str, system: &M) {
    let last = |ends: lagrange::ensemble::Ends<M>| ends.state(MOTIONS - 1).expect("ended")[0];
    for tolerance in [1e-6, 1e-9] {
        let ends = |threads| last(ensemble(system, tolerance, threads).run().expect("runs"));
        let alone = || last(ensemble(system, tolerance, 1).one_by_one().run().expect("runs"));
        let reduced = || {
            let ensemble = ensemble(system, tolerance, 1);
            ensemble
                .reduce(Moments::new(), |moments, motion| moments.add(motion.end_time()))
                .expect("runs")
                .mean()
        };
        let ways: [(&str, &dyn Fn() -> f64); 5] = [
            ("loop of single runs", &|| by_hand(system, tolerance)),
            ("one by one, 1 thread", &alone),
            ("in lanes, 1 thread", &|| ends(1)),
            ("in lanes, 1 thread, reduced", &reduced),
            ("in lanes, 2 threads", &|| ends(2)),
        ];
        measure(&format!("{name}, {tolerance:.0e}"), ways);
    }
    let equal = || ensemble(system, 1e-9, 1).method(RungeKutta4 { step: STEP });
    let ways: [(&str, &dyn Fn() -> f64); 2] = [
        ("one by one, 1 thread", &|| last(equal().one_by_one().run().expect("runs"))),
        ("in lanes, 1 thread", &|| last(equal().run().expect("runs"))),
    ];
    measure(&format!("{name}, RK4"), ways);
}

fn main() {
    println!("| {MOTIONS} motions of {UNTIL} s | way | µs a motion | times as fast |\n|---|---|---|---|");
    measure_all("cart-pole", black_box(&CartPole::default()));
    measure_all("double pendulum", black_box(&DoublePendulum::default()));
}
