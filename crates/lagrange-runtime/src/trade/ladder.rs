//! Runs of a contestant from coarse to fine settings.

use std::format;
use std::hint::black_box;
use std::string::String;
use std::time::Instant;
use std::vec::Vec;

use super::contestant::{Contestant, Knob, VectorEnd};
use super::digits::{self, Digits};
use super::measurement::{MeasuredRun, Measurement};

/// Number of coarsest steps in the run; each rung halves the step.
const COARSEST: f64 = 8.0;
const HALVINGS: i32 = 30;
/// A run is repeated for at least this many seconds, or as long as one run may take, but at most
/// `REPEATS` times.
const LONG_ENOUGH: f64 = 0.01;
const REPEATS: usize = 20;
/// Ratio to the least error above which rounding dominates: finer steps only increase it.
const RISEN: f64 = 8.0;
/// Number of such errors that end the search, since the least error may be accidental.
const OFTEN: u32 = 4;

/// Number of times as long that runs in lanes or in numbers wider than doubles may take.
const PATIENCE: f64 = 10.0;

/// The runs of a contestant.
pub(super) struct Climb {
    pub(super) rows: Vec<MeasuredRun>,
    /// True if the last run took too long for finer ones to be tried.
    pub(super) is_cut: bool,
}

/// The motion that all contestants run.
pub(super) struct Course<'a> {
    pub(super) start: &'a [f64],
    pub(super) end: f64,
    pub(super) reference: &'a [Digits],
    pub(super) sizes: &'a [f64],
    /// Number of seconds after which finer settings are not tried.
    pub(super) longest: f64,
}

/// Runs all settings, until a run takes too long or finer settings do not help.
pub(super) fn climb(contestant: &Contestant<'_>, course: &Course<'_>) -> Climb {
    let is_slow = contestant.motions > 1 || contestant.epsilon < f64::EPSILON;
    let longest = if is_slow { PATIENCE * course.longest } else { course.longest };
    let mut climb = Climb { rows: Vec::new(), is_cut: false };
    let (mut least, mut risen) = (f64::INFINITY, 0);
    for setting in settings(contestant, course.end) {
        let began = Instant::now();
        let outcome = measure(contestant, setting, course, longest);
        // Runs that fail late also take long.
        let seconds = outcome.as_ref().map_or_else(
            |_| began.elapsed().as_secs_f64(),
            |found| found.seconds * contestant.motions as f64,
        );
        if let Ok(found) = &outcome {
            least = least.min(found.error);
            let has_risen = contestant.knob == Knob::Step && found.error > RISEN * least;
            risen = if has_risen && least < f64::from(f32::EPSILON) { risen + 1 } else { 0 };
        }
        climb.is_cut = seconds > longest;
        climb.rows.push(row(contestant, setting, outcome));
        if climb.is_cut || risen >= OFTEN {
            break;
        }
    }
    climb
}

fn row(contestant: &Contestant<'_>, setting: f64, outcome: Result<Measurement, String>) -> MeasuredRun {
    MeasuredRun {
        method: contestant.method.clone(),
        scalar: contestant.scalar.clone(),
        variant: contestant.variant.clone(),
        motions: contestant.motions,
        is_tolerance: contestant.knob == Knob::Tolerance,
        setting,
        line: contestant.line(setting),
        outcome,
    }
}

/// Returns settings from coarse to fine. Tolerances have two digits, so that what is printed is
/// what was run; they end where the number type does.
fn settings(contestant: &Contestant<'_>, end: f64) -> Vec<f64> {
    match contestant.knob {
        Knob::Tolerance => {
            let rungs = (1..).flat_map(|n| [format!("1e-{n}"), format!("3.2e-{}", n + 1)]);
            let rungs = rungs.map_while(|rung| rung.parse().ok());
            rungs.take_while(|rung| *rung >= contestant.epsilon).collect()
        }
        Knob::Step => (0..HALVINGS).map(|k| end.abs() / COARSEST / 2_f64.powi(k)).collect(),
    }
}

/// Measures the error, and the shortest time of several runs. A run that takes too long is repeated
/// once, since another process may have held it up.
fn measure(
    contestant: &Contestant<'_>,
    setting: f64,
    course: &Course<'_>,
    longest: f64,
) -> Result<Measurement, String> {
    let mut best: Option<(f64, VectorEnd)> = None;
    let (mut total, mut repeats) = (0.0, 0);
    while repeats == 0
        || total < LONG_ENOUGH.min(longest) && repeats < REPEATS
        || total > longest && repeats == 1
    {
        let began = Instant::now();
        let run = black_box((contestant.run)(black_box(setting), course.start, course.end)?);
        let seconds = began.elapsed().as_secs_f64();
        total += seconds;
        repeats += 1;
        if best.as_ref().is_none_or(|(shortest, _)| seconds < *shortest) {
            best = Some((seconds, run));
        }
    }
    let (seconds, run) = best.ok_or("nothing was run")?;
    let error = digits::error(&run.state, course.reference, course.sizes);
    Ok(Measurement { error, seconds: seconds / contestant.motions as f64, work: run.work })
}
