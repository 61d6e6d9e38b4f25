//! Taylor series beside the default pair: emitted code, code of Cranelift and the interpreter, in
//! milliseconds of a whole motion.
//!
//! `cargo bench --bench series` in this folder. The ways alternate, and each time is the shortest
//! of many. Errors are those of the final state, in its largest component, against series of order
//! 36. Emitted and compiled code end in the same bits.

#[allow(clippy::assign_op_pattern, reason = "as the tests of lagrange-dynamic declare them")]
#[macro_use]
#[path = "../../lagrange-dynamic/tests/systems/both_ways.rs"]
mod both_ways;

use std::time::{Duration, Instant};

use lagrange::integrate::{Method, Stepper, Taylor, Verner98};
use lagrange::system::TaylorSystem;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Visitor};
use lagrange_jit::Compiler;

both_ways! {
    DoublePendulum = DOUBLE_PENDULUM {
        param m1 = 1.0, m2 = 1.0, l1 = 1.0, l2 = 1.0, g = 9.81;
        coord theta1, theta2;
        let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
        let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
        kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
        potential = m1 * g * y1 + m2 * g * y2;
        emit { taylor }
    }

    Kepler = KEPLER {
        coord r, phi;
        kinetic = 1/2 * (dot(r)^2 + (r * dot(phi))^2);
        potential = -1 / r;
        emit { taylor }
    }

    Chain = CHAIN {
        param m[3] = 1.0, l[3] = 1.0, g = 9.81;
        coord theta[3];
        for i in 0..3 {
            let x[i] = sum(j in 0..i + 1, l[j] * sin(theta[j]));
            let y[i] = -sum(j in 0..i + 1, l[j] * cos(theta[j]));
        }
        kinetic = sum(i in 0..3, 1/2 * m[i] * (dot(x[i])^2 + dot(y[i])^2));
        potential = sum(i in 0..3, m[i] * g * y[i]);
        emit { taylor }
    }
}

const ROUNDS: usize = 30;
const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];

/// A motion by one of the two methods.
#[derive(Clone, Copy)]
struct Motion<'a> {
    start: &'a [f64],
    end: f64,
    method: Either,
}

#[derive(Clone, Copy)]
enum Either {
    Series(Taylor<f64>),
    Pair(f64),
}

impl Visitor for Motion<'_> {
    type Output = (Duration, Vec<f64>);

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        self.run(system, system.state(self.start))
    }
}

impl Motion<'_> {
    fn run<M: TaylorSystem<Scalar = f64>>(self, system: &M, start: M::State) -> (Duration, Vec<f64>) {
        match self.method {
            Either::Series(method) => timed(system, &start, self.end, &method),
            Either::Pair(tolerance) => timed(system, &start, self.end, &Verner98::tolerance(tolerance)),
        }
    }
}

fn timed<M: TaylorSystem<Scalar = f64>>(
    system: &M,
    start: &M::State,
    end: f64,
    method: &impl Method<M>,
) -> (Duration, Vec<f64>) {
    let began = Instant::now();
    let mut stepper = method.start(system, 0.0, start, end).expect("starts");
    while stepper.time() < end {
        stepper.step(system, end).expect("goes on");
    }
    (began.elapsed(), stepper.state().as_ref().to_vec())
}

fn read(text: &str) -> DeclaredSystem {
    let derived = parse(text).expect("a declaration").derive(StrategyChoice::Cheapest);
    DeclaredSystem::new(Programs::new(&derived.expect("regular"))).expect("runs")
}

fn difference(found: &[f64], expected: &[f64]) -> f64 {
    found.iter().zip(expected).fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

/// Returns the shortest times of emitted, compiled and interpreted code in milliseconds, and the
/// final state.
fn measured<M: TaylorSystem<Scalar = f64>>(
    motion: Motion<'_>,
    emitted: &M,
    start: M::State,
    [compiled, interpreted]: [&DeclaredSystem; 2],
) -> ([f64; 3], Vec<f64>) {
    let (mut least, mut end) = ([f64::INFINITY; 3], Vec::new());
    for _ in 0..ROUNDS {
        let runs = [motion.run(emitted, start), compiled.visit(motion), interpreted.visit(motion)];
        let [first, ..] = &runs;
        assert!(runs.iter().all(|(_, state)| *state == first.1), "different bits");
        end.clone_from(&first.1);
        least
            .iter_mut()
            .zip(&runs)
            .for_each(|(least, (time, _))| *least = least.min(1e3 * time.as_secs_f64()));
    }
    (least, end)
}

fn compare<M: TaylorSystem<Scalar = f64>>(
    name: &str,
    (emitted, text): (&M, &str),
    start: M::State,
    end: f64,
) {
    let interpreted = read(text);
    let compiled = interpreted.clone().compiled_by(Compiler::for_this_processor().expect("known"));
    let state = start.as_ref().to_vec();
    let motion = |method| Motion { start: &state, end, method };
    let exact = Taylor { order: Some(36), ..Taylor::tolerance(1e-17) };
    let (_, reference) = motion(Either::Series(exact)).run(emitted, start);
    for tolerance in TOLERANCES {
        let methods = [Either::Pair(tolerance), Either::Series(Taylor::tolerance(tolerance))];
        let [pair, series] =
            methods.map(|method| measured(motion(method), emitted, start, [&compiled, &interpreted]));
        let columns = [pair, series].map(|(times, end)| {
            let [emitted, compiled, interpreted] = times;
            let error = difference(&end, &reference);
            format!("{error:.1e} | {emitted:.3} | {compiled:.3} | {interpreted:.2}")
        });
        println!("| {name} | {tolerance:e} | {} |", columns.join(" | "));
    }
}

fn main() {
    println!(
        "| motion | tolerance | `Verner98`: error | rustc, ms | Cranelift | interpreter | `Taylor`: error | rustc, ms | Cranelift | interpreter |"
    );
    compare("double pendulum", (&DoublePendulum::default(), DOUBLE_PENDULUM), [2.0, 1.5, 0.0, 0.0], 10.0);
    // Eccentricity 0.6, ten revolutions of length 2π.
    let revolutions = 20.0 * std::f64::consts::PI;
    compare("Kepler", (&Kepler, KEPLER), [0.4, 0.0, 0.0, 5.0], revolutions);
    compare("chain of three", (&Chain::default(), CHAIN), [1.0, 1.3, 1.6, 0.0, 0.0, 0.0], 5.0);
}
