//! Time of the macro for models of parts, compared with the same models written flat.
//!
//! The first column compares with the declaration whose parts are expanded, the second with its
//! plain statements, which have no bodies either. Both texts declare the same equations. The times
//! are those of parsing and checking, and of everything that the macro does.
//!
//! Proc-macros run unoptimised in most builds:
//! `cargo bench --profile dev -p lagrange-benches --bench composition`.

use std::hint::black_box;
use std::time::Instant;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::expand::without_arrays;
use lagrange_core::pipeline::parse;
use lagrange_core::syntax::{parse_text, print};

const QUADRUPED: &str = include_str!("composed/quadruped.lag");
const CAR: &str = concat!(
    include_str!("../parts/driveline.lag"),
    include_str!("../parts/strut.lag"),
    include_str!("composed/car.lag")
);
const ROUNDS: usize = 15;

/// A phase of the macro.
type Phase = fn(&str);

const PHASES: [(&str, Phase); 2] = [("parse and check", check), ("whole", expand)];

fn check(text: &str) {
    black_box(parse(text).expect("a correct declaration"));
}

fn expand(text: &str) {
    let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let tokens = derived.and_then(|derived| derived.emit(&quote::quote!(::lagrange)));
    black_box(tokens.expect("a regular system"));
}

/// Returns a declaration without parts and arrays.
fn written_flat(text: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("tokens");
    print::statements(&without_arrays(declaration, &mut report))
}

/// Returns the median times of a phase in milliseconds, of texts in turn.
fn times<const N: usize>(phase: Phase, texts: [&str; N]) -> [f64; N] {
    let mut rounds = texts.map(|_| Vec::with_capacity(ROUNDS));
    for _ in 0..ROUNDS {
        for (times, text) in rounds.iter_mut().zip(texts) {
            let began = Instant::now();
            phase(text);
            times.push(began.elapsed().as_secs_f64() * 1e3);
        }
    }
    rounds.map(|mut times| {
        times.sort_by(f64::total_cmp);
        times[ROUNDS / 2]
    })
}

fn main() {
    println!("| model | phase | of parts, ms | flat, ms | plain, ms | to flat | to plain |");
    println!("|---|---|---|---|---|---|---|");
    for (name, text) in [("quadruped", QUADRUPED), ("car", CAR)] {
        let flat = written_flat(text);
        let plain = parse(text).expect("a correct declaration").statements();
        for (phase, run) in PHASES {
            let [composed, flat, plain] = times(run, [text, &flat, &plain]);
            let ratios = [composed / flat, composed / plain];
            println!(
                "| {name} | {phase} | {composed:.1} | {flat:.1} | {plain:.1} | {:.2} | {:.2} |",
                ratios[0], ratios[1]
            );
        }
    }
}
