//! Errors in a declaration: their places, their descriptions for users, and help.
//!
//! A phase adds to a [`Report`] and continues as far as possible; the pipeline stops between
//! phases. The wording is in the `messages` file of the phase that finds the error.

mod rows;
mod spelling;

use std::fmt;
use std::ops::Range;

use proc_macro2::Span;

#[doc(inline)]
pub use crate::messages;
pub use spelling::nearest;

/// File names of tokens that are not in a file.
const NOWHERE: [&str; 2] = ["", "<unspecified>"];

/// A range of the user's source, from its first to its last token.
#[derive(Clone, Copy, Debug)]
pub struct Origin {
    /// Span of the first token.
    pub start: Span,
    /// Span of the last token.
    pub end: Span,
}

impl Origin {
    /// Returns the range from the start of `self` to the end of `other`.
    pub fn to(self, other: Origin) -> Origin {
        Origin { start: self.start, end: other.end }
    }

    /// Returns line and column of its first character, both counted from one. `None` if they are
    /// unknown, as in language servers.
    pub fn position(self) -> Option<[usize; 2]> {
        let start = self.start.start();
        let is_known = start.line > 0 && !NOWHERE.contains(&self.start.file().as_str());
        is_known.then_some([start.line, start.column + 1])
    }

    /// Returns its bytes in the parsed text, if [`Origin::position`] is known.
    pub fn bytes(self) -> Option<Range<usize>> {
        let (start, end) = (self.start.byte_range(), self.end.byte_range());
        self.position().map(|_| start.start..end.end.max(start.end))
    }

    /// Returns its position, `3:7`, preceded by the file name if it has one: `src/main.rs:3:7`.
    fn place(self) -> Option<String> {
        let [line, column] = self.position()?;
        let file = self.start.file();
        // Text without a file has a name such as `<parsed string 1>`.
        let file = if file.starts_with('<') { String::new() } else { format!("{file}:") };
        Some(format!("{file}{line}:{column}"))
    }
}

impl From<Span> for Origin {
    fn from(span: Span) -> Origin {
        Origin { start: span, end: span }
    }
}

/// Severity of a diagnostic.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Severity {
    /// The declaration is invalid; no equations are derived.
    Error,
    /// A warning: this name is declared but never used, which is probably unintended.
    Unused(String),
    /// A warning: this is intended, but takes long to compile.
    Expensive,
    /// A warning: the declaration contradicts itself, or a number is impossible, but equations can
    /// be derived.
    Doubtful,
}

/// One error or warning.
#[derive(Clone, Debug)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Message in one sentence without a full stop.
    pub message: String,
    /// The offending tokens.
    pub origin: Origin,
    /// Other relevant places, each with a description.
    pub related: Vec<(Origin, String)>,
    /// Advice.
    pub help: Option<String>,
}

impl Diagnostic {
    /// Adds a related place.
    pub fn related(&mut self, origin: Origin, note: impl Into<String>) -> &mut Self {
        self.related.push((origin, note.into()));
        self
    }

    /// Sets the help.
    pub fn help(&mut self, help: impl Into<String>) -> &mut Self {
        self.help = Some(help.into());
        self
    }
}

impl Diagnostic {
    /// Returns the message, then related places and help, each starting on a separate line.
    pub fn text(&self) -> String {
        let mut text = self.message.clone();
        for (origin, note) in &self.related {
            let at = origin.place().map_or_else(String::new, |place| format!(" at {place}"));
            text.push_str(&format!("\nnote{at}: {note}"));
        }
        if let Some(help) = &self.help {
            text.push_str(&format!("\nhelp: {help}"));
        }
        text
    }
}

/// `error at 3:7: unknown name …`, with related places and help on lines of their own.
impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let severity = match &self.severity {
            Severity::Error => "error",
            Severity::Unused(_) | Severity::Expensive | Severity::Doubtful => "warning",
        };
        let at = self.origin.place().map_or_else(String::new, |place| format!(" at {place}"));
        write!(f, "{severity}{at}: {}", self.text().replace('\n', "\n  "))
    }
}

/// The diagnostics of one declaration, in the order of discovery.
#[derive(Clone, Default, Debug)]
#[must_use = "mistakes must reach the user"]
pub struct Report {
    diagnostics: Vec<Diagnostic>,
}

impl Report {
    /// Adds an error; details can be chained.
    pub fn error(&mut self, origin: impl Into<Origin>, message: impl Into<String>) -> &mut Diagnostic {
        self.add(Severity::Error, origin.into(), message.into())
    }

    /// Adds a warning about an unused name; details can be chained.
    pub fn unused(
        &mut self,
        name: &str,
        origin: impl Into<Origin>,
        message: impl Into<String>,
    ) -> &mut Diagnostic {
        self.add(Severity::Unused(name.to_owned()), origin.into(), message.into())
    }

    /// Adds a warning about long compilation; details can be chained.
    pub fn expensive(&mut self, origin: impl Into<Origin>, message: impl Into<String>) -> &mut Diagnostic {
        self.add(Severity::Expensive, origin.into(), message.into())
    }

    /// Adds a warning about something that is hardly intended; details can be chained.
    pub fn doubtful(&mut self, origin: impl Into<Origin>, message: impl Into<String>) -> &mut Diagnostic {
        self.add(Severity::Doubtful, origin.into(), message.into())
    }

    fn add(&mut self, severity: Severity, origin: Origin, message: String) -> &mut Diagnostic {
        self.diagnostics.push(Diagnostic { severity, message, origin, related: Vec::new(), help: None });
        let last = self.diagnostics.len() - 1;
        &mut self.diagnostics[last]
    }

    /// Returns the diagnostic with this index, in the order of discovery, to add later findings.
    pub fn diagnostic_mut(&mut self, number: usize) -> Option<&mut Diagnostic> {
        self.diagnostics.get_mut(number)
    }

    /// Changes each diagnostic, and retains those for which `keep` is true.
    pub fn revise(&mut self, keep: impl FnMut(&mut Diagnostic) -> bool) {
        self.diagnostics.retain_mut(keep);
    }

    /// True if any diagnostic is an error.
    pub fn has_errors(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Error)
    }

    /// Returns the diagnostics found so far.
    pub fn diagnostics(&self) -> &[Diagnostic] {
        &self.diagnostics
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.diagnostics.iter().try_for_each(|diagnostic| writeln!(f, "{diagnostic}"))
    }
}

impl std::error::Error for Report {}

#[cfg(test)]
mod tests {
    use proc_macro2::{Span, TokenStream, TokenTree};

    use super::{Origin, Report};

    #[test]
    fn related_places_stand_in_the_text_if_they_are_known() {
        let tokens = "a\n  b".parse::<TokenStream>().expect("tokens");
        let spans = tokens.into_iter().map(|token: TokenTree| token.span()).collect::<Vec<_>>();
        let mut report = Report::default();
        let error = report.error(spans[1], "`b` is wrong").help("write `c`");
        error.related(Origin::from(spans[0]), "`a` is here");
        error.related(Origin::from(Span::call_site()), "something is elsewhere");
        let text = "`b` is wrong\nnote at 1:1: `a` is here\nnote: something is elsewhere\nhelp: write `c`";
        assert_eq!(report.diagnostics()[0].text(), text);
        assert_eq!(report.to_string(), format!("error at 2:3: {}\n", text.replace('\n', "\n  ")));
        let mut report = Report::default();
        report.error(Span::call_site(), "nobody knows where");
        assert_eq!(report.to_string(), "error: nobody knows where\n");
    }
}
