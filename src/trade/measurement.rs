//! What one run of a trade gave.

use std::string::String;

use crate::integrate::Work;

/// What a setting of a method gave.
#[derive(Clone, Debug)]
pub struct Row {
    /// What the method is called.
    pub method: String,
    /// The number type.
    pub scalar: &'static str,
    /// Which of the systems.
    pub variant: String,
    /// Whether `setting` is a tolerance; the length of a step otherwise.
    pub is_tolerance: bool,
    /// What the method was told.
    pub setting: f64,
    /// What came of it, or why nothing did.
    pub outcome: Result<Measurement, String>,
}

/// A run that reached its end.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Measurement {
    /// The largest error of a component of the state at the end, in its unit.
    pub error: f64,
    /// The shortest time of several runs.
    pub seconds: f64,
    /// What it took.
    pub work: Work,
}
