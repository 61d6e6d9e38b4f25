//! The cost of accuracy levels and of `Portable` numbers on whole motions, as rows of a Markdown
//! table.
//!
//!     cargo bench -p lagrange-benches --bench portable
//!
//! Chains of point masses on massless rods, in equal steps and in steps by a tolerance. All
//! variants alternate. Times are minima, in microseconds for a motion, also divided by the time of
//! `standard`.

use std::hint::black_box;
use std::time::Instant;

use lagrange::integrate::{Method, RungeKutta4, Verner98, integrate};
use lagrange::system::{OdeSystem, StateVector};
use lagrange::{Number, Portable, Scalar};

const ROUNDS: usize = 40;

/// Declares a chain with this number of links at each level.
macro_rules! chains {
    ($($module:ident $n:literal;)*) => {
        $(mod $module {
            chains!(@level $n, Standard, standard);
            chains!(@level $n, Fast, fast);
            chains!(@level $n, Strict, strict);
        })*
    };
    (@level $n:literal, $name:ident, $level:ident) => {
        lagrange::system! {
            #[accuracy($level)]
            pub(super) struct $name<S>;
            const n = $n;
            param g = 9.81;
            coord q[n];
            for i in 0..n {
                let p[i] = if i > 0 { p[i-1] + (sin(q[i]), -cos(q[i])) } else { (sin(q[i]), -cos(q[i])) };
                kinetic = kinetic_energy(1, dot(p[i]));
                potential = gravitational_energy(1, g, p[i].y);
            }
        }
    };
}

chains! {
    chain_2 2;
    chain_5 5;
    chain_20 20;
}

/// Returns microseconds of a motion from rest.
fn time<M, K>(system: &M, end: f64, method: &K) -> f64
where
    M: OdeSystem,
    K: Method<M>,
{
    let mut start = M::State::ZERO;
    let half = start.as_ref().len() / 2;
    for (k, angle) in start.as_mut()[..half].iter_mut().enumerate() {
        *angle = M::Scalar::from_f64(1.0 - 0.1 * k as f64);
    }
    let (zero, end) = (M::Scalar::ZERO, M::Scalar::from_f64(end));
    let began = Instant::now();
    let state = integrate(black_box(system), zero, start, end, method, |_, _| {});
    assert!(black_box(state).is_ok(), "the motion ends early");
    began.elapsed().as_secs_f64() * 1e6
}

fn equal_steps<S: Scalar>() -> RungeKutta4<S> {
    RungeKutta4 { step: S::from_f64(1e-3) }
}

fn by_tolerance<S: Scalar>() -> Verner98<S> {
    Verner98::tolerance(S::from_f64(1e-9))
}

/// Times each variant in alternation, and prints a row.
fn report(chain: &str, method: &str, variants: &[&dyn Fn() -> f64]) {
    let mut least = vec![f64::INFINITY; variants.len()];
    for _ in 0..ROUNDS {
        for (least, variant) in least.iter_mut().zip(variants) {
            *least = least.min(variant());
        }
    }
    let others = least[1..].iter().map(|time| format!("{time:.0} ({:.2})", time / least[0]));
    println!("| {chain} | {method} | {:.0} | {} |", least[0], others.collect::<Vec<_>>().join(" | "));
}

/// Reports a chain with both kinds of steps.
macro_rules! report {
    ($($module:ident $chain:literal;)*) => {
        $(
            report!(@method $module, $chain, "equal steps", equal_steps);
            report!(@method $module, $chain, "tolerance 1e-9", by_tolerance);
        )*
    };
    (@method $module:ident, $chain:literal, $title:literal, $method:ident) => {
        report($chain, $title, &[
            &|| time(&$module::Standard::<f64>::default(), 1.0, &$method()),
            &|| time(&$module::Fast::<f64>::default(), 1.0, &$method()),
            &|| time(&$module::Strict::<f64>::default(), 1.0, &$method()),
            &|| time(&$module::Standard::<Portable>::default(), 1.0, &$method()),
            &|| time(&$module::Fast::<Portable>::default(), 1.0, &$method()),
        ]);
    };
}

fn main() {
    println!(
        "| chain | steps | `standard`, µs | `fast` | `strict` | portable `standard` | portable `fast` |"
    );
    println!("|---|---|---|---|---|---|---|");
    report! {
        chain_2 "of 2";
        chain_5 "of 5";
        chain_20 "of 20";
    }
}
