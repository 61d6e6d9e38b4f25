//! Comparison of methods on a motion, and the best one for a given error.

use std::path::Path;

use lagrange_dynamic::{DeclaredSystem, trade};
use lagrange_runtime::trade::{MeasuredRun, Measurement, Report};

use crate::arguments::TradeOptions;
use crate::motions::{Failure, end, set, start, time};
use crate::values::value;

/// Duration of a run in seconds after which no finer setting is tried, by default.
const LONGEST: f64 = 0.2;
/// Motions with noise have no method with a tolerance as their reference.
const NOISE: &str = "methods are measured without noise only: compare ends of `lagrange ensemble --method stochastic` with other steps";
/// Runs of trades keep no past.
const DELAYS: &str =
    "methods are measured without delays only: delayed signals need a past, which is not kept here";

/// Measures methods, sets the parameters of the system, and returns the best option for one or
/// several error goals. All measurements are saved to a folder, if one is given.
///
/// # Errors
/// If an option is invalid, with the first one, or if no method reaches an error goal.
pub(crate) fn text(
    options: &TradeOptions,
    folder: Option<&Path>,
    system: &mut DeclaredSystem,
) -> Result<String, Failure> {
    let error =
        options.error.as_deref().map(|text| positive("error", value("--error", text, Some("1")), text));
    let longest =
        options.longest.as_deref().map(|text| positive("longest", Ok(time("longest", text)?), text));
    let (error, longest) = (error.transpose()?, longest.transpose()?);
    set(&options.values, system)?;
    let until = end(options.until.as_deref())?;
    if until == 0.0 {
        return Err(Failure::Usage("--until 0: the motion has no duration".to_owned()));
    }
    let start = start("start", &options.values, system)?;
    if !system.programs().noises.is_empty() {
        return Err(Failure::Ended(NOISE.to_owned()));
    }
    if !system.programs().delayed_inputs.is_empty() {
        return Err(Failure::Ended(DELAYS.to_owned()));
    }
    if let Some(reason) = &system.programs().variables.needs_steps {
        return Err(Failure::Ended(format!("{reason}, whose error is not compared")));
    }
    let report = trade(system, &start, until, longest.unwrap_or(LONGEST));
    if report.rows().is_empty() {
        let reason =
            "no method with a tolerance reaches the end: `lagrange simulate` shows where a motion fails";
        return Err(Failure::Ended(format!("{reason}{}", cut(&report))));
    }
    if let Some(folder) = folder {
        report.save(folder).map_err(|error| Failure::File(error.to_string()))?;
    }
    match error {
        Some(error) => proposal(&report, error),
        None => Ok(table(&report)),
    }
}

fn positive(option: &str, number: Result<f64, String>, text: &str) -> Result<f64, Failure> {
    match number {
        Ok(number) if number > 0.0 => Ok(number),
        Ok(_) => Err(Failure::Usage(format!("--{option} {text}: expected a positive number"))),
        Err(error) => Err(Failure::Usage(format!("--{option} {text}: {error}"))),
    }
}

/// Returns the options of the fastest run with at most this error, and its measurement.
fn proposal(report: &Report, error: f64) -> Result<String, Failure> {
    let Some((row, found)) = report.fastest(error) else {
        let errors = report.rows().iter().filter_map(|row| Some(row.outcome.as_ref().ok()?.error));
        let least = errors.fold(f64::INFINITY, f64::min);
        return Err(Failure::Ended(format!(
            "no method reaches an error of {error:e}; the smallest is {least:.1e}{}",
            cut(report)
        )));
    };
    let Measurement { error, seconds, work } = found;
    let (milliseconds, evaluations) = (1e3 * seconds, work.evaluations);
    Ok(format!(
        "{}\nerror {error:.1e}, {evaluations} evaluations, {milliseconds:.2} ms\nin Rust: {}\n",
        options_of(row),
        row.line
    ))
}

/// Returns a remark on errors if finer runs were omitted.
fn cut(report: &Report) -> &'static str {
    if report.is_cut() {
        "; finer settings than those of long runs were not tried: set a longer `--longest`"
    } else {
        ""
    }
}

/// Returns the options of the fastest run for each error.
fn table(report: &Report) -> String {
    let mut text =
        format!("{:<14}{:<44}{:>8}{:>14}{:>10}\n", "error wanted", "options", "error", "evaluations", "ms");
    for (goal, choice) in report.choices() {
        text += &match choice {
            Some((row, Measurement { error, seconds, work })) => format!(
                "{:<14}{:<44}{error:>8.1e}{:>14}{:>10.2}\n",
                format!("{goal:.0e}"),
                options_of(row),
                work.evaluations,
                1e3 * seconds
            ),
            None => format!("{:<14}not reached\n", format!("{goal:.0e}")),
        };
    }
    text + "errors are differences to the finest run\n"
}

/// Returns the options of `lagrange simulate` for a run, with the setting in full.
fn options_of(row: &MeasuredRun) -> String {
    format!("--method {} --{} {:e}", row.variant, row.knob(), row.setting)
}
