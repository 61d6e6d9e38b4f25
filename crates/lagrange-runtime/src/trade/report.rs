//! The report of a trade, and recommendations.

use std::format;
use std::string::String;
use std::vec::Vec;

use super::measurement::{MeasuredRun, Measurement};
use crate::integrate::Work;
use lagrange_files::csv_cell;

/// Accuracies for which a choice is recommended.
const GOALS: [f64; 7] = [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12];

/// All runs of a [`Trade`](super::Trade).
#[derive(Clone, Debug)]
pub struct Report {
    pub(super) title: String,
    pub(super) has_own_reference: bool,
    pub(super) rows: Vec<MeasuredRun>,
    pub(super) is_cut: bool,
}

impl Report {
    /// Returns the title.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Returns all runs, in order of execution; none if there was no reference and the finest run
    /// failed.
    pub fn rows(&self) -> &[MeasuredRun] {
        &self.rows
    }

    /// Returns the fastest run with at most this error.
    pub fn fastest(&self, error: f64) -> Option<(&MeasuredRun, Measurement)> {
        let good = self.measured().filter(|(_, found)| found.error <= error);
        good.min_by(|(_, a), (_, b)| a.seconds.total_cmp(&b.seconds))
    }

    /// Returns accuracies, each with the fastest run that reaches it, if there is one.
    pub fn choices(&self) -> impl Iterator<Item = (f64, Option<(&MeasuredRun, Measurement)>)> {
        GOALS.into_iter().map(|goal| (goal, self.fastest(goal)))
    }

    /// True if finer settings of a method were skipped because a run took longer than
    /// [`longest`](super::Trade::longest) allows.
    pub fn is_cut(&self) -> bool {
        self.is_cut
    }

    /// Returns the fastest choice for each accuracy as a table in Markdown.
    pub fn recommendation(&self) -> String {
        let mut text = String::from(
            "| error wanted | method | numbers | variant | setting | error | µs | evaluations |\n|---|---|---|---|---|---|---|---|\n",
        );
        for (goal, choice) in self.choices() {
            let Some((row, found)) = choice else {
                text += &format!("| {goal:.0e} | not reached | | | | | | |\n");
                continue;
            };
            let knob = row.knob();
            text += &format!(
                "| {goal:.0e} | {} | {} | {} | {knob} {:.1e} | {:.1e} | {:.0} | {} |\n",
                row.method,
                row.scalar,
                row.variant,
                row.setting,
                found.error,
                1e6 * found.seconds,
                found.work.evaluations
            );
        }
        if self.has_own_reference {
            text += "\nErrors are differences to the finest run.\n";
        }
        text
    }

    /// Returns all runs as comma-separated values, failed ones with their reason.
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "method,numbers,variant,knob,setting,error,microseconds,steps,rejections,evaluations,jacobians,iterations,failure\n",
        );
        for row in &self.rows {
            let knob = row.knob();
            let MeasuredRun { method, scalar, setting, .. } = row;
            text += &format!("{},{scalar},{},{knob},{setting:e},", csv_cell(method), csv_cell(&row.variant));
            text += &match &row.outcome {
                Ok(Measurement { error, seconds, work }) => {
                    let Work { steps, rejections, evaluations, jacobians, iterations, .. } = work;
                    let time = 1e6 * seconds;
                    format!(
                        "{error:e},{time:.3},{steps},{rejections},{evaluations},{jacobians},{iterations},\n"
                    )
                }
                Err(failure) => format!(",,,,,,,{}\n", csv_cell(failure)),
            };
        }
        text
    }

    /// Returns the title in lower-case letters, digits and underscores.
    pub fn file_name(&self) -> String {
        let words =
            self.title.split(|letter: char| !letter.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
        words.collect::<Vec<_>>().join("_").to_ascii_lowercase()
    }

    /// Returns the runs that reached the end.
    pub(super) fn measured(&self) -> impl Iterator<Item = (&MeasuredRun, Measurement)> {
        self.rows.iter().filter_map(|row| Some((row, *row.outcome.as_ref().ok()?)))
    }
}
