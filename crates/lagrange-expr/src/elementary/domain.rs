//! Domains of elementary functions.

/// Arguments for which a function is defined.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Domain {
    /// All of them.
    Everywhere,
    /// All but single points, which these words name.
    AwayFrom(&'static str),
    /// No number below zero.
    FromZero,
    /// Numbers above zero.
    AboveZero,
    /// A first argument above zero.
    BaseAboveZero,
    /// Numbers from −1 to 1.
    WithinOne,
}

impl Domain {
    /// Returns the domain in words for error messages and docs.
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
