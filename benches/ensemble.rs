//! Ensembles of 10 s, in lanes and one by one, against a handwritten loop of single runs, and with
//! different numbers of threads.
//!
//! All variants compute the same motions in each round, in alternation, so that all see the same
//! load. Times are minima. Ratios are medians over the rounds, of the time of the first variant
//! over that of another.

use std::hint::black_box;
use std::time::Instant;

use lagrange::ensemble::{Ends, Ensemble, Moments, Random, Samples, SharedSystem};
use lagrange::integrate::{BlanesMoan4, Method, RungeKutta4, StormerVerlet, Verner98};
use lagrange::simulate::Table;
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
    emit { jacobian, lanes }
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

lagrange::system! {
    #[derive(Clone)]
    pub struct Chain;

    const n = 10;
    param m[n] = 0.1, l[n] = 0.1, g = 9.81;
    coord theta[n];
    let p[0] = (0, 0);
    for i in 0..n {
        let p[i+1] = p[i] + l[i] * (sin(theta[i]), -cos(theta[i]));
        kinetic = kinetic_energy(m[i], dot(p[i+1]));
        potential = gravitational_energy(m[i], g, p[i+1].y);
    }
    emit { lanes }
}

lagrange::system! {
    /// The motion of a star in a galaxy (Hénon, Heiles 1964), which is separable.
    #[derive(Clone)]
    pub struct HenonHeiles;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * (x^2 + y^2) + x^2 * y - 1/3 * y^3;
    emit { lanes }
}

const MOTIONS: usize = 1024;
const ROUNDS: usize = 21;
const UNTIL: f64 = 10.0;
const SEED: u64 = 7;
const STEP: f64 = 0.01;
const INTERVAL: f64 = 0.1;

/// A system with the starts of its motions.
trait Subject: SharedSystem<Scalar = f64, Columns<Table<f64>>: Send> {
    /// Number of motions: few for a large system.
    const MOTIONS: usize = MOTIONS;

    fn start(random: &mut Random) -> Self::State;
}

impl Subject for DoublePendulum {
    fn start(random: &mut Random) -> [f64; 4] {
        [2.0 + 0.1 * random.normal(), 2.0, 0.0, 0.0]
    }
}

impl Subject for CartPole {
    fn start(random: &mut Random) -> [f64; 4] {
        DoublePendulum::start(random)
    }
}

impl Subject for HenonHeiles {
    fn start(random: &mut Random) -> [f64; 4] {
        [0.1 * random.normal(), 0.1, 0.1, 0.1]
    }
}

impl Subject for Chain {
    const MOTIONS: usize = 256;

    fn start(random: &mut Random) -> [f64; 20] {
        let angle = 0.5 + 0.1 * random.normal();
        std::array::from_fn(|index| if index < 10 { angle } else { 0.0 })
    }
}

/// Computes the ends of single runs, one after the other.
fn by_hand<M: Subject>(system: &M, tolerance: f64) -> f64 {
    let ends = (0..M::MOTIONS).map(|index| {
        let run = system.simulate(M::start(&mut Random::start(SEED, index))).until(UNTIL);
        run.tolerance(tolerance).ends_only().run().expect("runs").last()
    });
    ends.collect::<Vec<_>>()[M::MOTIONS - 1].as_ref()[0]
}

fn ensemble<M: Subject>(system: &M, tolerance: f64, threads: usize) -> Ensemble<'_, M, Verner98<f64>> {
    let motions = system.ensemble(M::MOTIONS).start(|_, random| M::start(random)).until(UNTIL);
    motions.tolerance(tolerance).seed(SEED).threads(threads)
}

/// Returns a time in microseconds.
fn time(compute: &dyn Fn() -> f64) -> f64 {
    let began = Instant::now();
    black_box(compute());
    began.elapsed().as_secs_f64() * 1e6
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Measures several ways of computing motions, in alternation.
fn measure<const N: usize>(what: &str, motions: usize, ways: [(&str, &dyn Fn() -> f64); N]) {
    let rounds: Vec<_> = (0..ROUNDS).map(|_| ways.map(|(_, compute)| time(compute))).collect();
    for (index, (name, _)) in ways.iter().enumerate() {
        let least = rounds.iter().map(|times| times[index]).fold(f64::INFINITY, f64::min) / motions as f64;
        let ratio = median(rounds.iter().map(|times| times[0] / times[index]).collect());
        println!("| {what:20} | {name:27} | {least:7.1} | {ratio:.2} |");
    }
}

/// Returns a number of the last motion.
fn last<M: Subject>(ends: &Ends<M>) -> f64 {
    ends.state(M::MOTIONS - 1).expect("ended").as_ref()[0]
}

/// Returns a number of its trajectory.
fn last_sample<M: Subject>(samples: &Samples<M>) -> f64 {
    samples.iter().last().expect("ended").1.last().as_ref()[0]
}

fn measure_all<M: Subject>(name: &str, system: &M) {
    for tolerance in [1e-6, 1e-9] {
        let ends = |threads| last(&ensemble(system, tolerance, threads).run().expect("runs"));
        let alone = || last(&ensemble(system, tolerance, 1).one_by_one().run().expect("runs"));
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
        measure(&format!("{name}, {tolerance:.0e}"), M::MOTIONS, ways);
        let sampled = || ensemble(system, tolerance, 1).every(INTERVAL);
        let ways: [(&str, &dyn Fn() -> f64); 2] = [
            ("one by one, 1 thread", &|| last_sample(&sampled().one_by_one().run().expect("runs"))),
            ("in lanes, 1 thread", &|| last_sample(&sampled().run().expect("runs"))),
        ];
        measure(&format!("{name}, {tolerance:.0e}, samples"), M::MOTIONS, ways);
    }
    measure_equal(name, system, "RK4", RungeKutta4 { step: STEP });
}

/// Measures a method with equal steps.
fn measure_equal<M: Subject, K>(name: &str, system: &M, method: &str, settings: K)
where
    K: Method<M> + Copy + Sync,
{
    let equal = || ensemble(system, 1e-9, 1).method(settings);
    let ways: [(&str, &dyn Fn() -> f64); 2] = [
        ("one by one, 1 thread", &|| last(&equal().one_by_one().run().expect("runs"))),
        ("in lanes, 1 thread", &|| last(&equal().run().expect("runs"))),
    ];
    measure(&format!("{name}, {method}"), M::MOTIONS, ways);
    let ways: [(&str, &dyn Fn() -> f64); 2] = [
        ("one by one, 1 thread", &|| last_sample(&equal().one_by_one().every(INTERVAL).run().expect("runs"))),
        ("in lanes, 1 thread", &|| last_sample(&equal().every(INTERVAL).run().expect("runs"))),
    ];
    measure(&format!("{name}, {method}, samples"), M::MOTIONS, ways);
}

/// Measures derivatives of double pendulums by these variables.
macro_rules! measure_sensitivities {
    ($($name:literal)*) => {
        let (names, system) = ([$($name),*], black_box(DoublePendulum::default()));
        let sensitive = || ensemble(&system, 1e-9, 1).sensitivities(names);
        let ways: [(&str, &dyn Fn() -> f64); 2] = [
            ("one by one, 1 thread", &|| last(&sensitive().one_by_one().run().expect("runs"))),
            ("in lanes, 1 thread", &|| last(&sensitive().run().expect("runs"))),
        ];
        measure(&format!("double pendulum, 1e-09, by {}", names.len()), MOTIONS, ways);
    };
}

fn main() {
    println!("| motions of {UNTIL} s | way | µs a motion | times as fast |\n|---|---|---|---|");
    measure_all("cart-pole", black_box(&CartPole::default()));
    measure_all("double pendulum", black_box(&DoublePendulum::default()));
    measure_sensitivities!("m1");
    measure_sensitivities!("m1" "g" "theta1" "theta2");
    measure_all("chain of ten", black_box(&Chain::default()));
    measure_equal("Hénon–Heiles", black_box(&HenonHeiles), "Störmer–Verlet", StormerVerlet { step: STEP });
    measure_equal("Hénon–Heiles", black_box(&HenonHeiles), "Blanes–Moan", BlanesMoan4 { step: 6.0 * STEP });
}
