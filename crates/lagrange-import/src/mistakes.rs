//! Mistakes in files, with places, elements, messages and advice.

use std::fmt;

/// A mistake, or a warning about an omission.
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
    /// True if the mistake prevents the import; otherwise it is a warning.
    pub is_error: bool,
}

impl Mistake {
    pub(crate) fn help(&mut self, help: impl Into<String>) {
        self.help = Some(help.into());
    }
}

/// Maximum number of errors, and of warnings, in a listing.
const MAX_LISTED: usize = 50;

/// Lists mistakes in the format of compilers, each after the name of the file. The number of
/// omitted ones follows.
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

/// Formats a mistake as `12:5: error: joint "elbow", <axis>: …`, with help on a separate line.
impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Mistake { line, column, element, message, help, is_error } = self;
        let severity = if *is_error { "error" } else { "warning" };
        let colon = if element.is_empty() { "" } else { ": " };
        write!(f, "{line}:{column}: {severity}: {element}{colon}{message}")?;
        help.iter().try_for_each(|help| write!(f, "\n  help: {help}"))
    }
}
