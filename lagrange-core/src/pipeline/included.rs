//! Locations in included files, for compiler messages.
//!
//! The compiler assigns the location of the macro to all tokens of a text that the macro reads.
//! After an error in a declaration with such files, everything is therefore read again with the
//! fallback of `proc_macro2`, which counts lines and columns. It finds the errors in the same
//! order. Each error takes the message of its twin, with file, line and column, and is reported
//! where the file is included.

use lagrange_expr::diagnostics::{Diagnostic, Origin, Report};
use lagrange_language::syntax::ast::{IncludedFile, PlacedInstance};
use lagrange_language::tables::Reader;
use proc_macro2::fallback;

use super::{Expanded, expanded};

/// Guard that enables the fallback until it goes out of scope.
struct Fallback;

impl Fallback {
    fn begin() -> Fallback {
        fallback::force();
        Fallback
    }
}

impl Drop for Fallback {
    fn drop(&mut self) {
        fallback::unforce();
    }
}

/// The texts of an error: its message and the notes on related places.
struct Words {
    message: String,
    notes: Vec<String>,
}

impl Words {
    fn of(diagnostic: &Diagnostic) -> Words {
        let notes = diagnostic.related.iter().map(|(_, note)| note.clone()).collect();
        Words { message: diagnostic.message.clone(), notes }
    }
}

/// Adds the file, line and column to errors in included files. The declaration and the path of the
/// crate are given as text.
pub(super) fn name_included(
    (tokens, krate): (&str, &str),
    read: Reader<'_>,
    expanded: &Expanded,
    report: &mut Report,
) {
    let words = words(tokens, krate, read);
    if words.len() != report.diagnostics().len() {
        return;
    }
    let mut words = words.into_iter();
    report.revise(|diagnostic| {
        let Some(twin) = words.next() else { return true };
        rename(&mut diagnostic.origin, &mut diagnostic.message, twin.message, &expanded.included);
        for ((origin, note), other) in diagnostic.related.iter_mut().zip(&twin.notes) {
            rename(origin, note, other.clone(), &expanded.included);
        }
        // The part that contains an error is only known if locations are known.
        for note in twin.notes.into_iter().skip(diagnostic.related.len()) {
            let is_named = |instance: &&PlacedInstance| note.contains(&format!("`{}`", instance.name));
            let origin = expanded.placed.iter().find(is_named).map(|instance| instance.origin);
            let (mut origin, mut words) = (origin.unwrap_or(diagnostic.origin), String::new());
            rename(&mut origin, &mut words, note.clone(), &expanded.included);
            diagnostic.related(origin, note);
        }
        true
    });
}

/// Returns the texts of all errors, with locations in files.
fn words(tokens: &str, krate: &str, read: Reader<'_>) -> Vec<Words> {
    let _fallback = Fallback::begin();
    let (Ok(tokens), Ok(krate)) = (tokens.parse(), krate.parse()) else { return Vec::new() };
    let mut report = Report::default();
    expanded(tokens, &krate, read, &mut report);
    report.diagnostics().iter().map(Words::of).collect()
}

fn rename(origin: &mut Origin, words: &mut String, twin: String, included: &[IncludedFile]) {
    let is_of = |file: &&IncludedFile| twin.starts_with(&format!("{}:", file.path));
    if let Some(file) = included.iter().find(is_of) {
        *origin = file.root;
        *words = twin;
    }
}
