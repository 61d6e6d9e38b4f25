//! Runs of a contestant from coarse to fine settings.

use std::hint::black_box;
use std::string::String;
use std::time::Instant;
use std::vec::Vec;

use super::contestant::{Contestant, Knob, VectorEnd};
use super::measurement::{MeasuredRun, Measurement};

/// Number of tolerances per decade, from 10⁻¹ to 10⁻¹⁵.
const RUNGS_A_DECADE: i32 = 2;
const DECADES: (i32, i32) = (1, 15);
/// Number of coarsest steps in the run; each rung halves the step.
const COARSEST: f64 = 8.0;
const HALVINGS: i32 = 30;
/// A run is repeated for at least this many seconds, but at most `REPEATS` times.
const LONG_ENOUGH: f64 = 0.01;
const REPEATS: usize = 20;
/// Ratio to the least error above which rounding dominates: finer steps only increase it.
const RISEN: f64 = 8.0;
/// Number of such errors that end the search, since the least error may be accidental.
const OFTEN: u32 = 4;

/// The runs of a contestant.
pub(super) struct Climb {
    pub(super) rows: Vec<MeasuredRun>,
    /// True if the last run took too long for finer ones to be tried.
    pub(super) is_cut: bool,
}

/// Runs all settings, until a run takes longer than `longest` or finer settings do not help.
pub(super) fn climb(
    contestant: &Contestant<'_>,
    start: &[f64],
    end: f64,
    reference: &[f64],
    longest: f64,
) -> Climb {
    let mut climb = Climb { rows: Vec::new(), is_cut: false };
    let (mut least, mut risen) = (f64::INFINITY, 0);
    for setting in settings(contestant.knob, end) {
        let began = Instant::now();
        let outcome = measure(contestant, setting, start, end, reference);
        // Runs that fail late also take long.
        let seconds = outcome.as_ref().map_or_else(|_| began.elapsed().as_secs_f64(), |found| found.seconds);
        if let Ok(found) = &outcome {
            least = least.min(found.error);
            let has_risen = contestant.knob == Knob::Step && found.error > RISEN * least;
            risen = if has_risen && least < f64::from(f32::EPSILON) { risen + 1 } else { 0 };
        }
        climb.is_cut = seconds > longest;
        climb.rows.push(MeasuredRun {
            method: contestant.method.clone(),
            scalar: contestant.scalar,
            variant: contestant.variant.clone(),
            is_tolerance: contestant.knob == Knob::Tolerance,
            setting,
            outcome,
        });
        if climb.is_cut || risen >= OFTEN {
            break;
        }
    }
    climb
}

fn settings(knob: Knob, end: f64) -> Vec<f64> {
    let (coarse, fine) = DECADES;
    match knob {
        Knob::Tolerance => {
            let rungs = (RUNGS_A_DECADE * coarse)..=(RUNGS_A_DECADE * fine);
            rungs.map(|k| 10_f64.powf(-f64::from(k) / f64::from(RUNGS_A_DECADE))).collect()
        }
        Knob::Step => (0..HALVINGS).map(|k| end.abs() / COARSEST / 2_f64.powi(k)).collect(),
    }
}

/// Measures the error, and the shortest time of several runs.
fn measure(
    contestant: &Contestant<'_>,
    setting: f64,
    start: &[f64],
    end: f64,
    reference: &[f64],
) -> Result<Measurement, String> {
    let mut best: Option<(f64, VectorEnd)> = None;
    let (mut total, mut repeats) = (0.0, 0);
    while repeats == 0 || total < LONG_ENOUGH && repeats < REPEATS {
        let began = Instant::now();
        let run = black_box((contestant.run)(black_box(setting), start, end)?);
        let seconds = began.elapsed().as_secs_f64();
        total += seconds;
        repeats += 1;
        if best.as_ref().is_none_or(|(shortest, _)| seconds < *shortest) {
            best = Some((seconds, run));
        }
    }
    let (seconds, run) = best.ok_or("nothing was run")?;
    Ok(Measurement { error: error(&run.state, reference), seconds, work: run.work })
}

/// Computes the largest error of a component; NaN stays NaN.
fn error(state: &[f64], reference: &[f64]) -> f64 {
    let errors = state.iter().zip(reference).map(|(found, exact)| (found - exact).abs());
    errors.fold(0.0, |largest, error| if error <= largest { largest } else { error })
}
