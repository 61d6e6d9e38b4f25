//! The cost that projection adds to a step, as rows of a Markdown table. The same steps run with
//! and without it, in alternation. Times are minima, ratios medians over rounds, so other load on
//! the machine has little effect.

#[path = "../tests/mechanisms/four_bar.rs"]
mod four_bar;
#[path = "../tests/mechanisms/squeezer.rs"]
mod squeezer;

use std::hint::black_box;
use std::time::Instant;

use four_bar::FourBar;
use lagrange::constraint::{ConstrainedSystem, Unprojected};
use lagrange::integrate::{Method, RungeKutta4, Stepper, Verner98};
use lagrange::system::OdeSystem;
use squeezer::Squeezer;

lagrange::system! {
    /// A point mass on a rod in the plane.
    #[derive(Clone, Debug)]
    struct Rod;

    param g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint rod = x^2 + y^2 - 1;
}

const ROUNDS: usize = 101;
const STEPS: u32 = 400;

/// Returns nanoseconds per step, over this number of steps from the same start.
#[inline(never)]
fn time<M, K>(system: &M, start: &M::State, method: &K) -> f64
where
    M: OdeSystem<Scalar = f64>,
    K: Method<M>,
{
    let mut stepper = method.start(system, 0.0, black_box(start), 1e3).expect("an admissible start");
    let began = Instant::now();
    for _ in 0..STEPS {
        stepper.step(black_box(system), 1e3).expect("a step");
    }
    black_box(stepper.state());
    began.elapsed().as_nanos() as f64 / f64::from(STEPS)
}

/// Prints a row: steps with projection, steps without, and their ratio.
fn row<M, K>(name: &str, system: &M, start: M::State, method: &K)
where
    M: ConstrainedSystem<Scalar = f64> + Clone,
    K: Method<M> + Method<Unprojected<M>>,
{
    let without = Unprojected(system.clone());
    let rounds = (0..ROUNDS).map(|_| [time(system, &start, method), time(&without, &start, method)]);
    let rounds = rounds.collect::<Vec<_>>();
    let least = |k: usize| rounds.iter().fold(f64::INFINITY, |least, times| least.min(times[k]));
    let mut ratios = rounds.iter().map(|[with, without]| with / without).collect::<Vec<_>>();
    ratios.sort_by(f64::total_cmp);
    let method = Method::<M>::name(method);
    println!("| {name} | {method} | {:.0} | {:.0} | {:.2} |", least(0), least(1), ratios[ROUNDS / 2]);
}

/// Prints rows of steps by both methods, of at most this length.
fn rows<M>(name: &str, system: &M, start: M::State, step: f64)
where
    M: ConstrainedSystem<Scalar = f64> + Clone,
{
    row(name, system, start, &RungeKutta4 { step });
    let adaptive = Verner98 { longest_step: Some(8.0 * step), ..Verner98::tolerance(1e-9) };
    row(name, system, start, &adaptive);
}

fn main() {
    println!("| system | method | projected, ns | not, ns | ratio |\n|---|---|---|---|---|");
    rows("rod", &Rod::default(), [0.6, -0.8, 0.8, 0.6], 2e-3);
    rows("four-bar linkage", &FourBar::default(), four_bar::START, 1e-4);

    rows("Andrews' squeezer", &Squeezer::default(), squeezer::START, 2e-6);
}
