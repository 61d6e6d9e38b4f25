//! Mistakes in files: their places and elements, their description, and help.

use std::fmt;

/// A mistake, or a warning of something that was left out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// Line in the file, from one.
    pub line: u32,
    /// Column in that line, from one.
    pub column: u32,
    /// The element, such as `joint "elbow", <axis>`; empty for the whole file.
    pub element: String,
    /// Message in one sentence without a full stop.
    pub message: String,
    /// Advice.
    pub help: Option<String>,
    /// True if nothing can be imported for it; otherwise it is a warning.
    pub is_error: bool,
}

impl Mistake {
    pub(crate) fn help(&mut self, help: impl Into<String>) {
        self.help = Some(help.into());
    }
}

/// Errors, and warnings, that a listing shows at most.
const MAX_LISTED: usize = 50;

/// Lists mistakes as compilers do, each behind the name of the file, with the number of those that
/// are too many to read.
pub fn listing(file: &str, mistakes: &[Mistake]) -> String {
    let mut counts = [0, 0];
    let mut lines = String::new();
    for mistake in mistakes {
        let count = &mut counts[usize::from(mistake.is_error)];
        *count += 1;
        if *count <= MAX_LISTED {
            lines.push_str(&format!("{file}:{mistake}\n"));
        }
    }
    for (count, name) in counts.iter().zip(["warnings", "errors"]) {
        if *count > MAX_LISTED {
            lines.push_str(&format!("{file}: not shown: {} more {name}\n", count - MAX_LISTED));
        }
    }
    lines
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
