//! The result of one run of a trade.

use std::string::String;

use crate::integrate::Work;

/// The result of one setting of a method.
#[derive(Clone, Debug)]
pub struct MeasuredRun {
    /// Name of the method.
    pub method: String,
    /// The number type.
    pub scalar: &'static str,
    /// Name of the variant.
    pub variant: String,
    /// True if `setting` is a tolerance; the length of a step otherwise.
    pub is_tolerance: bool,
    /// Setting of the method.
    pub setting: f64,
    /// Measurement, or the reason for its absence.
    pub outcome: Result<Measurement, String>,
}

impl MeasuredRun {
    /// Returns the name of the setting: `tolerance` or `step`.
    pub fn knob(&self) -> &'static str {
        if self.is_tolerance { "tolerance" } else { "step" }
    }
}

/// A run that reached its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Measurement {
    /// The largest error of a component of the state at the end, in its unit.
    pub error: f64,
    /// The shortest time of several runs.
    pub seconds: f64,
    /// Work of the run.
    pub work: Work,
}
