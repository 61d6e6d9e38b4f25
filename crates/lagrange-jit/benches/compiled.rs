//! Code of rustc, code of Cranelift and the interpreter in one run: rates, and ten seconds of
//! motion. `cargo xtask performance text` writes the tables of `docs/performance.md` and
//! `docs/command_line.md`.

#[allow(dead_code, clippy::assign_op_pattern, reason = "as the tests of lagrange-dynamic declare them")]
#[macro_use]
#[path = "../../lagrange-dynamic/tests/systems/mod.rs"]
mod systems;

use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use lagrange::Simulate;
use lagrange::system::{MechanicalSystem, OdeSystem};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};
use lagrange_dynamic::{DeclaredSystem, DynamicSystem, Visitor};
use lagrange_jit::Compiler;
use systems::{DOUBLE_PENDULUM, DoublePendulum, FIVE_MASSES, FiveMasses, ROD, Rod, TOP, Top};

both_ways! {
    Chain10 = CHAIN_10 {
        const n = 10;
        param m[n] = 1, l[n] = 0.5, g = 9.81;
        coord q[n];
        for i in 0..n {
            let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
            kinetic = kinetic_energy(m[i], dot(p[i]));
            potential = gravitational_energy(m[i], g, p[i].y);
        }
    }

    Chain30 = CHAIN_30 {
        const n = 30;
        param m[n] = 1, l[n] = 0.5, g = 9.81;
        coord q[n];
        for i in 0..n {
            let p[i] = if i > 0 { p[i-1] + l[i] * (sin(q[i]), -cos(q[i])) } else { l[i] * (sin(q[i]), -cos(q[i])) };
            kinetic = kinetic_energy(m[i], dot(p[i]));
            potential = gravitational_energy(m[i], g, p[i].y);
        }
    }

    Arm7 = ARM_7 {
        gravity = (0, 0, -9.81);
        for i in 0..7 {
            body link[i] { mass: 2; centroid: (0.1, 0.01, 0); inertia: (0.02, 0.03, 0.04); }
            if i == 0 { revolute q[i] = ground to link[i] { at: (0, 0, 0.3); } }
            if i > 0 { revolute q[i] = link[i-1] to link[i] { at: (0.3, 0, 0); turned: (pi/2, 0, 0); } }
        }
    }
}

const ROUNDS: usize = 30;
const END: f64 = 10.0;
/// Evaluations of the rates per round.
const EVALUATIONS: u32 = 2_000;

/// A motion: one run, which returns the number of evaluations.
struct Motion<'a>(&'a [f64]);

impl Visitor for Motion<'_> {
    type Output = u64;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> u64 {
        moved(system, system.state(self.0))
    }
}

/// Repeated evaluations of the rates.
struct Rates<'a>(&'a [f64]);

impl Visitor for Rates<'_> {
    type Output = Duration;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Duration {
        rates(system, system.state(self.0))
    }
}

fn moved<M: MechanicalSystem<Scalar = f64>>(system: &M, start: M::State) -> u64 {
    system.simulate(start).until(END).ends_only().run().expect("a motion").work().evaluations
}

fn rates<M: OdeSystem<Scalar = f64>>(system: &M, y: M::State) -> Duration {
    let began = Instant::now();
    for _ in 0..EVALUATIONS {
        black_box(system.rhs(0.0, black_box(&y)));
    }
    began.elapsed() / EVALUATIONS
}

fn timed<T>(run: impl FnOnce() -> T) -> (Duration, T) {
    let start = Instant::now();
    let result = run();
    (start.elapsed(), result)
}

fn read(text: &str) -> DeclaredSystem {
    let derived = parse(text).expect("a declaration").derive(StrategyChoice::Cheapest);
    DeclaredSystem::new(Programs::new(&derived.expect("regular"))).expect("runs")
}

/// The shortest times of three ways: rustc, Cranelift, interpreter.
#[derive(Clone, Copy)]
struct Least([Duration; 3]);

impl Least {
    fn see(&mut self, times: [Duration; 3]) {
        self.0.iter_mut().zip(times).for_each(|(least, time)| *least = time.min(*least));
    }

    /// Returns nanoseconds for each of a number of evaluations.
    fn columns(&self, evaluations: f64) -> String {
        let [rustc, cranelift, interpreter] = self.0.map(|time| time.as_secs_f64() * 1e9 / evaluations);
        format!("{rustc:.1} | {cranelift:.1} | {interpreter:.1}")
    }
}

/// Returns the time to compile the rates and evaluate them once.
fn to_compile(read: &DeclaredSystem, compiler: &Arc<Compiler>, y: &[f64]) -> Duration {
    let system = read.clone().compiled_by(compiler.clone());
    timed(|| system.numeric().rhs(0.0, y)).0
}

/// Returns the shortest of several times, in milliseconds.
fn least(time: impl Fn() -> Duration) -> f64 {
    (0..ROUNDS).map(|_| time()).min().expect("a round").as_secs_f64() * 1e3
}

macro_rules! compare {
    ($System:ident, $TEXT:ident, $start:expr) => {{
        let (start, by_rustc) = ($start, $System::default());
        let compiler = Compiler::for_this_processor().expect("a known processor");
        let interpreted = read($TEXT);
        let compiled = interpreted.clone().compiled_by(compiler.clone());
        let [mut rate, mut motion] = [Least([Duration::MAX; 3]); 2];
        let mut evaluations = 0;
        for _ in 0..ROUNDS {
            let of = |system: &DeclaredSystem| system.visit(Rates(start.as_ref()));
            rate.see([rates(&by_rustc, start), of(&compiled), of(&interpreted)]);
            let of = |system: &DeclaredSystem| timed(|| system.visit(Motion(start.as_ref())));
            let [(a, first), (b, second), (c, third)] =
                [timed(|| moved(&by_rustc, start)), of(&compiled), of(&interpreted)];
            motion.see([a, b, c]);
            assert_eq!([first, first], [second, third]);
            evaluations = first;
        }
        println!(
            "| {} | {} | {} | {} | {:.2} | {:.3} |",
            stringify!($System),
            start.len(),
            rate.columns(1.0),
            motion.columns(evaluations as f64),
            least(|| timed(|| read($TEXT)).0),
            least(|| to_compile(&interpreted, &compiler, start.as_ref()))
        );
    }};
}

fn main() {
    println!(
        "| system | entries | rates: rustc, ns | Cranelift | interpreter | motion: rustc, ns | Cranelift | interpreter | to read, ms | to compile, ms |"
    );
    compare!(DoublePendulum, DOUBLE_PENDULUM, [1.5, 1.5, 0.0, 0.0]);
    compare!(FiveMasses, FIVE_MASSES, [0.1, 0.2, 0.3, 0.4, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0]);
    compare!(Rod, ROD, [0.6, -0.8, 0.0, 0.0]);
    compare!(Top, TOP, [1.0, 0.0, 0.0, 0.0, 0.1, 3.0, 0.2]);
    compare!(Chain10, CHAIN_10, std::array::from_fn::<f64, 20, _>(|i| if i < 10 { 0.1 } else { 0.0 }));
    compare!(Chain30, CHAIN_30, std::array::from_fn::<f64, 60, _>(|i| if i < 30 { 0.1 } else { 0.0 }));
    compare!(Arm7, ARM_7, std::array::from_fn::<f64, 14, _>(|i| if i < 7 { 0.3 } else { 0.1 }));
}
