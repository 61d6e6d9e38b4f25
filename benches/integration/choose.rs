//! The tolerance that reaches an error with the least work.

use crate::problem::{Case, Solver};

/// A tolerance with its result.
#[derive(Clone, Copy)]
pub(crate) struct Choice {
    pub(crate) tolerance: f64,
    pub(crate) error: f64,
    pub(crate) evaluations: u64,
}

/// Exponent of the largest tolerance. There are `PER_DECADE` in each decade, down to the least.
const LARGEST: i32 = -2;
const LEAST: i32 = -15;
const PER_DECADE: i32 = 16;

/// Returns, for each solver that reaches `goal`, the tolerance with the fewest evaluations.
pub(crate) fn choose(case: &Case, goal: f64) -> Vec<(&Solver, Choice)> {
    let reached = case.solvers.iter().filter_map(|solver| {
        let good = scan(case, solver).into_iter().filter(|choice| choice.error <= goal);
        Some((solver, good.min_by_key(|choice| choice.evaluations)?))
    });
    reached.collect()
}

/// Returns the smallest error that each solver can reach.
pub(crate) fn least(case: &Case) -> Vec<(&Solver, Choice)> {
    let best = case.solvers.iter().filter_map(|solver| {
        let choices = scan(case, solver).into_iter();
        Some((solver, choices.min_by(|a, b| a.error.total_cmp(&b.error))?))
    });
    best.collect()
}

fn scan(case: &Case, solver: &Solver) -> Vec<Choice> {
    let powers = (-LARGEST * PER_DECADE)..=(-LEAST * PER_DECADE);
    let tolerances = powers.map(|k| 10_f64.powf(-f64::from(k) / f64::from(PER_DECADE)));
    let runs = tolerances.filter_map(|tolerance| {
        let run = (solver.run)(tolerance)?;
        Some(Choice { tolerance, error: case.error(&run), evaluations: run.evaluations })
    });
    runs.collect()
}
