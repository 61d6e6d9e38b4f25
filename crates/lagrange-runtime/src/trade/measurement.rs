//! The result of one run of a trade.

use std::string::String;

use crate::integrate::Work;

/// The result of one setting of a method.
#[derive(Clone, Debug)]
pub struct MeasuredRun {
    /// Name of the method.
    pub method: String,
    /// The number type.
    pub scalar: String,
    /// Name of the variant.
    pub variant: String,
    /// Number of equal motions that ran together, in the lanes of an ensemble; otherwise one.
    pub motions: usize,
    /// True if `setting` is a tolerance; the length of a step otherwise.
    pub is_tolerance: bool,
    /// Setting of the method.
    pub setting: f64,
    /// The call that selects the method with this setting in a simulation or an ensemble, such as
    /// `.method(Taylor::tolerance(1e-9))`.
    pub line: String,
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
    /// The largest error of a component of the state at the end, in its unit or
    /// [size](super::Trade::sizes).
    pub error: f64,
    /// The shortest time of several runs, for each motion.
    pub seconds: f64,
    /// Work of the run; zero in lanes, which do not count it.
    pub work: Work,
}
