//! The report of a trade, and recommendations.

use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::measurement::{MeasuredRun, Measurement};
use crate::integrate::Work;
use lagrange_files::csv_cell;

/// Accuracies for which a choice is recommended.
const GOALS: [f64; 11] = [1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16, 1e-20, 1e-24];
/// Smallest goal, in units of the finest number type.
const ROUNDING: f64 = 1e3;

/// All runs of a [`Trade`](super::Trade).
#[derive(Clone, Debug)]
pub struct Report {
    pub(super) title: String,
    pub(super) has_own_reference: bool,
    /// Resolution of the finest number type.
    pub(super) epsilon: f64,
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

    /// Returns the fastest run of a single motion with at most this error.
    pub fn fastest(&self, error: f64) -> Option<(&MeasuredRun, Measurement)> {
        self.fastest_of(error, |row| row.motions == 1)
    }

    /// Returns the fastest run in lanes with at most this error.
    pub fn fastest_in_lanes(&self, error: f64) -> Option<(&MeasuredRun, Measurement)> {
        self.fastest_of(error, |row| row.motions > 1)
    }

    fn fastest_of(
        &self,
        error: f64,
        of: impl Fn(&MeasuredRun) -> bool,
    ) -> Option<(&MeasuredRun, Measurement)> {
        let good = self.measured().filter(|(row, found)| of(row) && found.error <= error);
        good.min_by(|(_, a), (_, b)| a.seconds.total_cmp(&b.seconds))
    }

    /// Returns accuracies, each with the fastest run of a single motion that reaches it, if there
    /// is one.
    pub fn choices(&self) -> impl Iterator<Item = (f64, Option<(&MeasuredRun, Measurement)>)> {
        self.goals().map(|goal| (goal, self.fastest(goal)))
    }

    /// Returns the accuracies that the finest number type allows.
    fn goals(&self) -> impl Iterator<Item = f64> + use<> {
        let finest = ROUNDING * self.epsilon;
        GOALS.into_iter().filter(move |goal| *goal >= finest)
    }

    /// True if finer settings of a method were skipped because a run took longer than
    /// [`longest`](super::Trade::longest) allows.
    pub fn is_cut(&self) -> bool {
        self.is_cut
    }

    /// Returns the fastest choice for each accuracy as a table in Markdown, with the line to write.
    /// A second table is for ensembles, if any ran in lanes.
    pub fn recommendation(&self) -> String {
        let mut text = table(self.choices());
        if self.rows.iter().any(|row| row.motions > 1) {
            let choices = self.goals().map(|goal| (goal, self.fastest_in_lanes(goal)));
            let reached = choices.filter(|(_, choice)| choice.is_some());
            text += &format!("\nIn an ensemble in lanes, for each motion:\n\n{}", table(reached));
        }
        if self.has_own_reference {
            text += "\nErrors are differences to the finest run.\n";
        }
        text
    }

    /// Returns all runs as comma-separated values, failed ones with their reason.
    pub fn csv(&self) -> String {
        let mut text = String::from(
            "method,numbers,variant,motions,knob,setting,error,microseconds,steps,rejections,evaluations,jacobians,iterations,failure\n",
        );
        for row in &self.rows {
            let knob = row.knob();
            let MeasuredRun { method, scalar, motions, setting, .. } = row;
            let variant = csv_cell(&row.variant);
            text += &format!("{},{scalar},{variant},{motions},{knob},{setting:e},", csv_cell(method));
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

/// Returns rows of choices in Markdown.
fn table<'a>(choices: impl Iterator<Item = (f64, Option<(&'a MeasuredRun, Measurement)>)>) -> String {
    let mut text = String::from(
        "| error wanted | line | numbers | variant | error | µs | evaluations |\n|---|---|---|---|---|---|---|\n",
    );
    for (goal, choice) in choices {
        text += &match choice {
            None => format!("| {goal:.0e} | not reached | | | | | |\n"),
            Some((row, Measurement { error, seconds, work })) => format!(
                "| {goal:.0e} | `{}` | {} | {} | {error:.1e} | {:.1} | {} |\n",
                row.line,
                row.scalar,
                row.variant,
                1e6 * seconds,
                // Lanes do not count their work.
                if row.motions > 1 { "–".into() } else { work.evaluations.to_string() }
            ),
        };
    }
    text
}
