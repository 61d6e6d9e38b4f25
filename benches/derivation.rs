//! Time to derive the equations of pendulum chains, phase by phase: the share of the macro in a
//! user's build.
//!
//! Proc-macros run unoptimised in most builds, so the relevant figures are those of
//! `cargo bench --profile dev -p lagrange-benches --bench derivation`. `tools/compile_time.py`
//! measures a user's whole wait, including the compilation of the emitted code.

use criterion::{BatchSize, Criterion, SamplingMode, criterion_group, criterion_main};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Derived, System, parse};
use proc_macro2::TokenStream;

const ABSOLUTE: &str = include_str!("chains/absolute.lag");
const RELATIVE: &str = include_str!("chains/relative.lag");
const CHAINS: [(&str, &str, usize); 6] = [
    ("absolute 2", ABSOLUTE, 2),
    ("absolute 5", ABSOLUTE, 5),
    ("absolute 10", ABSOLUTE, 10),
    ("absolute 20", ABSOLUTE, 20),
    ("relative 4", RELATIVE, 4),
    ("relative 8", RELATIVE, 8),
];

fn system(text: &str) -> System {
    parse(text).expect("a correct declaration")
}

fn derived(system: System) -> Derived {
    system.derive(StrategyChoice::Cheapest).expect("a regular system")
}

/// Lowers, optimises and writes everything that the macro emits.
fn emitted(derived: Derived) -> TokenStream {
    derived.emit(&quote::quote!(::lagrange)).expect("representable constants")
}

fn phases(criterion: &mut Criterion) {
    for (name, declaration, links) in CHAINS {
        let text = &declaration.replace("n = N", &format!("n = {links}"));
        let mut group = criterion.benchmark_group(name);
        group.sample_size(10).sampling_mode(SamplingMode::Flat);
        group.bench_function("whole", |bencher| bencher.iter(|| emitted(derived(system(text)))));
        group.bench_function("parse and check", |bencher| bencher.iter(|| system(text)));
        group.bench_function("derive", |bencher| {
            bencher.iter_batched(|| system(text), derived, BatchSize::PerIteration);
        });
        group.bench_function("emit", |bencher| {
            bencher.iter_batched(|| derived(system(text)), emitted, BatchSize::PerIteration);
        });
    }
}

criterion_group!(benches, phases);
criterion_main!(benches);
