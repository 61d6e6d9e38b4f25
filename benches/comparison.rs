//! Emitted code against the best handwritten code, in alternation: rows of a Markdown table.
//!
//! Three implementations are handwritten:
//! - straight-line assembly and factorisation of the mass matrix;
//! - articulated bodies as usually written for any plane mechanism;
//! - articulated bodies specialised to massless rods, for which a single number represents a
//!   subtree.
//!
//! All of them are compared at two levels of accuracy. At `standard`, both sides call the platform
//! for sines and cosines; at `fast`, both have the same inline function. The level `strict` is
//! compared with `standard`.
//!
//! Times are minima, ratios medians (`timing.rs`). `benches/evaluation.rs` has separate statistics
//! of each implementation; `cargo xtask performance` runs this for several targets and writes
//! docs/performance.md.

#[macro_use]
#[path = "chains/declared.rs"]
mod declared;
mod handwritten;
mod timing;

use std::array::from_fn;
use std::hint::black_box;

use lagrange::system::MechanicalSystem;

use handwritten::{
    Inline, Platform, absolute_chain, absolute_chain_articulated, absolute_chain_recursive, double_pendulum,
    relative_chain, relative_chain_articulated,
};
use timing::{Times, in_turns};

/// Defines chains at a level of accuracy.
macro_rules! chains {
    ($chains:ident $(, $level:ident)?) => {
        mod $chains {
            absolute!(absolute_2, 2 $(, $level)?);
            absolute!(absolute_5, 5 $(, $level)?);
            absolute!(absolute_10, 10 $(, $level)?);
            absolute!(absolute_20, 20 $(, $level)?);
            absolute!(absolute_30, 30 $(, $level)?);
            absolute!(absolute_100, 100 $(, $level)?);
            relative!(relative_4, 4 $(, $level)?);
            relative!(relative_8, 8 $(, $level)?);
            relative!(relative_20, 20 $(, $level)?);
        }
    };
}

chains!(chains);
chains!(fast_chains, fast);

mod strict_chains {
    absolute!(absolute_5, 5, strict);
    absolute!(absolute_10, 10, strict);
    absolute!(absolute_20, 20, strict);
    relative!(relative_8, 8, strict);
    relative!(relative_20, 20, strict);
}

const GRAVITY: f64 = 9.81;

/// Masses, lengths and gravity.
type Parameters<const N: usize> = ([f64; N], [f64; N], f64);

fn parameters<const N: usize>() -> Parameters<N> {
    (from_fn(|k| 1.0 + 0.1 * k as f64), from_fn(|k| 0.8 + 0.05 * k as f64), GRAVITY)
}

/// Returns an emitted type with these parameters as a function.
fn emitted<const N: usize, M>(
    (m, l, g): &Parameters<N>,
    build: fn(&[f64; N], &[f64; N], f64) -> M,
) -> impl Fn(&[f64; N], &[f64; N]) -> [f64; N] + use<N, M>
where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let system = build(m, l, *g);
    move |q, v| black_box(&system).acceleration(0.0, q, v)
}

/// Times the emitted type that `build` makes, and a handwritten function.
fn beside_by_hand<const N: usize, M>(
    build: fn(&[f64; N], &[f64; N], f64) -> M,
    by_hand: impl Fn(&[f64; N], &[f64; N], &[f64; N], &[f64; N], f64) -> [f64; N],
) -> Times
where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let parameters = parameters();
    let by_hand = |q: &_, v: &_| {
        let (m, l, g) = black_box(&parameters);
        by_hand(q, v, m, l, *g)
    };
    in_turns(emitted(&parameters, build), by_hand)
}

/// Times two emitted types.
fn beside_emitted<const N: usize, M, O>(
    build: fn(&[f64; N], &[f64; N], f64) -> M,
    other: fn(&[f64; N], &[f64; N], f64) -> O,
) -> Times
where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
    O: MechanicalSystem<Scalar = f64, Coordinates = [f64; N], Velocities = [f64; N]>,
{
    let parameters = parameters();
    in_turns(emitted(&parameters, build), emitted(&parameters, other))
}

fn report(level: &str, chain: &str, other: &str, times: &Times) {
    println!("| {level:<8} | {:<12} | {other:<13} | {times} |", chain.replace('_', " "));
}

const STRAIGHT: &str = "straight line";
const ARTICULATED: &str = "articulated";
const MASSLESS: &str = "massless rods";

/// Compares chains at a level with handwritten functions that take their sines from one source.
macro_rules! beside_by_hand {
    ($level:literal, $chains:ident, $waves:ident:
     $($chain:ident, $n:literal: $($way:ident = $by_hand:ident),+;)*) => {
        let times = beside_by_hand($chains::absolute_2::chain, double_pendulum::<$waves>);
        report($level, "absolute_2", STRAIGHT, &times);
        $($(
            let times = beside_by_hand($chains::$chain::chain, $by_hand::<$waves, $n>);
            report($level, stringify!($chain), $way, &times);
        )+)*
    };
    ($level:literal, $chains:ident, $waves:ident) => {
        beside_by_hand! { $level, $chains, $waves:
            absolute_5, 5: STRAIGHT = absolute_chain,
                ARTICULATED = absolute_chain_articulated, MASSLESS = absolute_chain_recursive;
            absolute_10, 10: STRAIGHT = absolute_chain,
                ARTICULATED = absolute_chain_articulated, MASSLESS = absolute_chain_recursive;
            absolute_20, 20: STRAIGHT = absolute_chain,
                ARTICULATED = absolute_chain_articulated, MASSLESS = absolute_chain_recursive;
            absolute_30, 30: ARTICULATED = absolute_chain_articulated, MASSLESS = absolute_chain_recursive;
            absolute_100, 100: ARTICULATED = absolute_chain_articulated, MASSLESS = absolute_chain_recursive;
            relative_4, 4: ARTICULATED = relative_chain_articulated, MASSLESS = relative_chain;
            relative_8, 8: ARTICULATED = relative_chain_articulated, MASSLESS = relative_chain;
            relative_20, 20: ARTICULATED = relative_chain_articulated, MASSLESS = relative_chain;
        }
    };
}

/// Compares chains at the level `strict` with the same at `standard`.
macro_rules! beside_standard {
    ($($chain:ident),+) => {
        $(
            let times = beside_emitted(strict_chains::$chain::chain, chains::$chain::chain);
            report("strict", stringify!($chain), "standard", &times);
        )+
    };
}

fn main() {
    println!("| {:<8} | {:<12} | {:<13} | ns     | ns     | ratio |", "level", "emitted", "other");
    println!("|---|---|---|---|---|---|");
    beside_by_hand!("standard", chains, Platform);
    beside_by_hand!("fast", fast_chains, Inline);
    beside_standard!(absolute_5, absolute_10, absolute_20, relative_8, relative_20);
}
