//! Whole integrations by this crate and by others, each in the setting that reaches a stated error
//! fastest.
//!
//! `cargo bench -p lagrange-benches --bench integration -- table` prints the cost of each solver
//! for a bound on the final error, all solvers in alternation in one run. Without `table` criterion
//! times the same runs one after the other.
//!
//! The other crates get a handwritten, simplified right-hand side, with constants folded and one
//! sine and cosine for each angle. This crate gets its emitted code; all solvers return the last
//! state only.

#[path = "../../tests/references/mod.rs"]
mod references;

mod cases;
mod choose;
mod emitted;
mod peers;
mod problem;
mod table;

use criterion::Criterion;

use cases::cases;
use choose::choose;

fn with_criterion() {
    let mut criterion = Criterion::default().configure_from_args();
    for case in cases() {
        for goal in case.goals {
            let mut group = criterion.benchmark_group(format!("{} to {goal:e}", case.name));
            for (solver, choice) in choose(&case, *goal) {
                group.bench_function(solver.name, |b| b.iter(|| (solver.run)(choice.tolerance)));
            }
            group.finish();
        }
    }
    criterion.final_summary();
}

fn main() {
    if std::env::args().any(|argument| argument == "table") {
        table::print(&cases());
    } else {
        with_criterion();
    }
}
