//! Mistakes in files: where they are, in which element, what is wrong and what helps.

use std::fmt;

/// A mistake, or a warning of something that was left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Line in the file, from one.
    pub line: u32,
    /// Column in that line, from one.
    pub column: u32,
    /// The element, such as `joint "elbow", <axis>`; empty where there is none.
    pub element: String,
    /// Message in one sentence without a full stop.
    pub message: String,
    /// Advice.
    pub help: Option<String>,
    /// Whether nothing can be imported for it; otherwise it is a warning.
    pub is_error: bool,
}

impl Mistake {
    pub(crate) fn help(&mut self, help: impl Into<String>) {
        self.help = Some(help.into());
    }
}

/// `12:5: error: joint "elbow", <axis>: …`, with help on a line of its own.
impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Mistake { line, column, element, message, help, is_error } = self;
        let severity = if *is_error { "error" } else { "warning" };
        let colon = if element.is_empty() { "" } else { ": " };
        write!(f, "{line}:{column}: {severity}: {element}{colon}{message}")?;
        help.iter().try_for_each(|help| write!(f, "\n  help: {help}"))
    }
}
