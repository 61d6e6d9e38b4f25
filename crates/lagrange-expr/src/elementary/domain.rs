//! Domains of elementary functions.

/// Set of arguments for which a function is defined.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Domain {
    /// All numbers.
    Everywhere,
    /// All numbers except single points, described by this text.
    AwayFrom(&'static str),
    /// Nonnegative numbers.
    FromZero,
    /// Positive numbers.
    AboveZero,
    /// A positive first argument.
    BaseAboveZero,
    /// Numbers from −1 to 1.
    WithinOne,
}

impl Domain {
    /// Returns a description of the domain for error messages and documentation.
    pub fn words(self) -> String {
        match self {
            Domain::Everywhere => "everywhere".to_owned(),
            Domain::AwayFrom(points) => format!("away from {points}"),
            Domain::FromZero => "from 0 upwards".to_owned(),
            Domain::AboveZero => "above 0".to_owned(),
            Domain::BaseAboveZero => "bases above 0".to_owned(),
            Domain::WithinOne => "between -1 and 1".to_owned(),
        }
    }
}
