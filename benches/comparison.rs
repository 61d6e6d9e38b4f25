//! Emitted code against the best by hand, in turns: a table of ratios that a busy machine hardly disturbs.
//!
//! Three ways by hand: straight-line assembly and factorisation of the mass matrix; articulated bodies as they
//! are written for any plane mechanism; and articulated bodies that use that rods have no mass, for which a
//! single number stands for a subtree. All of them are compared at two levels of accuracy: `standard`, where both
//! sides call the platform for sines and cosines, and `fast`, where both have the same inline function.
//!
//! Each round times both implementations for a few hundred microseconds, so that both see the same
//! load; the ratio is the median over the rounds, times are minima. `benches/evaluation.rs` has the statistics
//! of each implementation by itself.

mod chains;
mod fast_chains;
mod handwritten;

use std::array::from_fn;
use std::hint::black_box;
use std::time::Instant;

use lagrange::system::MechanicalSystem;

use chains::{absolute_2, absolute_5, absolute_10, absolute_20, relative_4, relative_8};
use handwritten::{
    Inline, Platform, absolute_chain, absolute_chain_articulated, absolute_chain_recursive, double_pendulum,
    relative_chain, relative_chain_articulated,
};

const GRAVITY: f64 = 9.81;
const ROUNDS: usize = 150;
const EVALUATIONS: usize = 3000;

/// Nanoseconds per evaluation, where each one waits for the one before.
#[inline(never)]
fn time<const N: usize>(mut accelerations: impl FnMut(&[f64; N], &[f64; N]) -> [f64; N]) -> f64 {
    let start: [f64; N] = black_box(from_fn(|k| 0.3 + 0.17 * k as f64));
    let v: [f64; N] = black_box(from_fn(|k| -0.5 + 0.23 * k as f64));
    let mut q = start;
    let began = Instant::now();
    for _ in 0..EVALUATIONS {
        let a = accelerations(&q, &v);
        q = from_fn(|k| start[k] + 1e-200 * a[k]);
    }
    black_box(q);
    began.elapsed().as_nanos() as f64 / EVALUATIONS as f64
}

type Parameters<const N: usize> = ([f64; N], [f64; N], f64);

fn time_by_hand<const N: usize>(
    parameters: &Parameters<N>,
    accelerations: &impl Fn(&[f64; N], &[f64; N], &[f64; N], &[f64; N], f64) -> [f64; N],
) -> f64 {
    time(|q, v| {
        let (m, l, g) = black_box(parameters);
        accelerations(q, v, m, l, *g)
    })
}

/// Times the emitted type that `build` makes, and a function.
fn compare<const N: usize, M>(
    name: &str,
    build: fn(&[f64; N], &[f64; N], f64) -> M,
    by_hand_name: &str,
    by_hand: impl Fn(&[f64; N], &[f64; N], &[f64; N], &[f64; N], f64) -> [f64; N],
) where
    M: MechanicalSystem<Scalar = f64, Coordinates = [f64; N]>,
{
    let parameters = (from_fn(|k| 1.0 + 0.1 * k as f64), from_fn(|k| 0.8 + 0.05 * k as f64), GRAVITY);
    let system = build(&parameters.0, &parameters.1, GRAVITY);
    let rounds = (0..ROUNDS).map(|_| {
        let emitted = time(|q, v| black_box(&system).acceleration(0.0, q, v));
        (emitted, time_by_hand(&parameters, &by_hand))
    });
    report(name, by_hand_name, &rounds.collect::<Vec<_>>());
}

fn report(name: &str, by_hand_name: &str, rounds: &[(f64, f64)]) {
    let fastest = |times: &mut dyn Iterator<Item = f64>| times.fold(f64::INFINITY, f64::min);
    let emitted = fastest(&mut rounds.iter().map(|(emitted, _)| *emitted));
    let by_hand = fastest(&mut rounds.iter().map(|(_, by_hand)| *by_hand));
    let mut ratios = rounds.iter().map(|(emitted, by_hand)| emitted / by_hand).collect::<Vec<_>>();
    ratios.sort_by(f64::total_cmp);
    let ratio = ratios[ratios.len() / 2];
    println!("{name:<12} {emitted:6.0} ns   {by_hand_name:<14} {by_hand:6.0} ns {ratio:6.2}");
}

const STRAIGHT: &str = "straight line";
const ARTICULATED: &str = "articulated";
const MASSLESS: &str = "massless rods";

/// Both sides with the functions of the platform.
fn standard() {
    compare("absolute 2", absolute_2::chain, STRAIGHT, double_pendulum::<Platform>);
    compare("absolute 5", absolute_5::chain, STRAIGHT, absolute_chain::<Platform, 5>);
    compare("absolute 10", absolute_10::chain, STRAIGHT, absolute_chain::<Platform, 10>);
    compare("absolute 20", absolute_20::chain, STRAIGHT, absolute_chain::<Platform, 20>);
    compare("absolute 5", absolute_5::chain, ARTICULATED, absolute_chain_articulated::<Platform, 5>);
    compare("absolute 10", absolute_10::chain, ARTICULATED, absolute_chain_articulated::<Platform, 10>);
    compare("absolute 20", absolute_20::chain, ARTICULATED, absolute_chain_articulated::<Platform, 20>);
    compare("relative 4", relative_4::chain, ARTICULATED, relative_chain_articulated::<Platform, 4>);
    compare("relative 8", relative_8::chain, ARTICULATED, relative_chain_articulated::<Platform, 8>);
    compare("absolute 5", absolute_5::chain, MASSLESS, absolute_chain_recursive::<Platform, 5>);
    compare("absolute 10", absolute_10::chain, MASSLESS, absolute_chain_recursive::<Platform, 10>);
    compare("absolute 20", absolute_20::chain, MASSLESS, absolute_chain_recursive::<Platform, 20>);
    compare("relative 4", relative_4::chain, MASSLESS, relative_chain::<Platform, 4>);
    compare("relative 8", relative_8::chain, MASSLESS, relative_chain::<Platform, 8>);
}

/// Both sides with inline sines and cosines of several angles at a time.
fn fast() {
    compare("absolute 2", fast_chains::absolute_2::chain, STRAIGHT, double_pendulum::<Inline>);
    compare("absolute 5", fast_chains::absolute_5::chain, STRAIGHT, absolute_chain::<Inline, 5>);
    compare("absolute 10", fast_chains::absolute_10::chain, STRAIGHT, absolute_chain::<Inline, 10>);
    compare("absolute 20", fast_chains::absolute_20::chain, STRAIGHT, absolute_chain::<Inline, 20>);
    compare(
        "absolute 5",
        fast_chains::absolute_5::chain,
        ARTICULATED,
        absolute_chain_articulated::<Inline, 5>,
    );
    compare(
        "absolute 10",
        fast_chains::absolute_10::chain,
        ARTICULATED,
        absolute_chain_articulated::<Inline, 10>,
    );
    compare(
        "absolute 20",
        fast_chains::absolute_20::chain,
        ARTICULATED,
        absolute_chain_articulated::<Inline, 20>,
    );
    compare(
        "absolute 30",
        fast_chains::absolute_30::chain,
        ARTICULATED,
        absolute_chain_articulated::<Inline, 30>,
    );
    compare(
        "relative 4",
        fast_chains::relative_4::chain,
        ARTICULATED,
        relative_chain_articulated::<Inline, 4>,
    );
    compare(
        "relative 8",
        fast_chains::relative_8::chain,
        ARTICULATED,
        relative_chain_articulated::<Inline, 8>,
    );
    compare(
        "relative 20",
        fast_chains::relative_20::chain,
        ARTICULATED,
        relative_chain_articulated::<Inline, 20>,
    );
    compare("absolute 5", fast_chains::absolute_5::chain, MASSLESS, absolute_chain_recursive::<Inline, 5>);
    compare("absolute 10", fast_chains::absolute_10::chain, MASSLESS, absolute_chain_recursive::<Inline, 10>);
    compare("absolute 20", fast_chains::absolute_20::chain, MASSLESS, absolute_chain_recursive::<Inline, 20>);
    compare("absolute 30", fast_chains::absolute_30::chain, MASSLESS, absolute_chain_recursive::<Inline, 30>);
    compare("relative 4", fast_chains::relative_4::chain, MASSLESS, relative_chain::<Inline, 4>);
    compare("relative 8", fast_chains::relative_8::chain, MASSLESS, relative_chain::<Inline, 8>);
    compare("relative 20", fast_chains::relative_20::chain, MASSLESS, relative_chain::<Inline, 20>);
}

fn main() {
    for (level, compare_all) in [("standard", standard as fn()), ("fast", fast)] {
        println!("{level:<12} {:>9}   {:<14} {:>9} {:>6}", "emitted", "by hand", "", "ratio");
        compare_all();
    }
}
