//! A table of all solvers, timed in alternation.

use std::hint::black_box;
use std::time::Instant;

use crate::choose::{Choice, choose, least};
use crate::problem::{Case, Solver};

const ROUNDS: usize = 200;

/// Prints the table, in Markdown.
pub(crate) fn print(cases: &[Case]) {
    println!(
        "| case | error wanted | solver | tolerance | error | evaluations | µs at best | time over best peer |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for case in cases {
        for goal in case.goals {
            rows(case.name, &format!("{goal:.0e}"), &choose(case, *goal));
        }
        rows(case.name, "least", &least(case));
    }
}

fn rows(case: &str, goal: &str, chosen: &[(&Solver, Choice)]) {
    let times = in_turns(chosen);
    let peers = (0..chosen.len()).filter(|k| chosen[*k].0.is_peer);
    let best = peers.min_by(|a, b| shortest(&times[*a]).total_cmp(&shortest(&times[*b])));
    for ((solver, choice), own) in chosen.iter().zip(&times) {
        let Choice { tolerance, error, evaluations } = choice;
        let time = 1e6 * shortest(own);
        let ratio = best.map_or(f64::NAN, |best| median_ratio(own, &times[best]));
        println!(
            "| {case} | {goal} | {} | {tolerance:.1e} | {error:.1e} | {evaluations} | {time:.1} | {ratio:.2} |",
            solver.name
        );
    }
}

/// Returns seconds of each run of each solver. Rounds alternate, so that all of them see the same
/// load.
fn in_turns(chosen: &[(&Solver, Choice)]) -> Vec<Vec<f64>> {
    let mut times = vec![Vec::with_capacity(ROUNDS); chosen.len()];
    for _ in 0..ROUNDS {
        for ((solver, choice), times) in chosen.iter().zip(&mut times) {
            let began = Instant::now();
            black_box((solver.run)(black_box(choice.tolerance)));
            times.push(began.elapsed().as_secs_f64());
        }
    }
    times
}

fn shortest(times: &[f64]) -> f64 {
    times.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Returns the median over the rounds of one time over the other.
fn median_ratio(times: &[f64], others: &[f64]) -> f64 {
    let mut ratios = times.iter().zip(others).map(|(time, other)| time / other).collect::<Vec<_>>();
    ratios.sort_by(f64::total_cmp);
    ratios[ratios.len() / 2]
}
