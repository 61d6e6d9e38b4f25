//! Errors in the style of the compiler, and as JSON.

use std::io::{IsTerminal, stderr};

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Renderer, Snippet};
use lagrange_core::diagnostics::{Diagnostic, Origin, Report, Severity};
use lagrange_dynamic::Source;
use serde_json::{Value, json};

use crate::console;

/// Prints all errors of a file to the standard error, in colour if it is a terminal.
pub(crate) fn print(source: &Source, report: &Report) {
    let is_coloured = stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    let renderer = if is_coloured { Renderer::styled() } else { Renderer::plain() };
    for diagnostic in report.diagnostics() {
        console::report(&format!("{}\n\n", renderer.render(&[group(source, diagnostic)])));
    }
}

fn group<'a>(source: &'a Source, diagnostic: &'a Diagnostic) -> Group<'a> {
    let level = if diagnostic.severity == Severity::Error { Level::ERROR } else { Level::WARNING };
    let title = level.primary_title(diagnostic.message.as_str());
    let main = annotation(AnnotationKind::Primary, diagnostic.origin);
    let related = diagnostic.related.iter().filter_map(|(origin, note)| {
        Some(annotation(AnnotationKind::Context, *origin)?.label(note.as_str()))
    });
    let annotations = main.into_iter().chain(related).collect::<Vec<_>>();
    let help = diagnostic.help.as_ref().map(|help| Level::HELP.message(help.as_str()));
    match annotations.is_empty() {
        true => Group::with_title(title).elements(help),
        false => {
            let snippet = Snippet::source(source.text.as_str()).path(source.name.as_str());
            title.element(snippet.annotations(annotations)).elements(help)
        }
    }
}

/// Marks a range of the text, if its position is known.
fn annotation<'a>(kind: AnnotationKind, origin: Origin) -> Option<Annotation<'a>> {
    Some(kind.span(origin.bytes()?))
}

/// Returns the errors of a file as JSON objects with `file`, `severity`, `message`, `help` and
/// `notes`. Each error and note has the fields `line` and `column`, one-based and in characters. It
/// also has `bytes`, a zero-based half-open range. Unknown or missing values are null.
pub(crate) fn as_json(source: &Source, report: &Report) -> Vec<Value> {
    report.diagnostics().iter().map(|diagnostic| value(source, diagnostic)).collect()
}

fn value(source: &Source, diagnostic: &Diagnostic) -> Value {
    let severity = if diagnostic.severity == Severity::Error { "error" } else { "warning" };
    let notes =
        diagnostic.related.iter().map(|(origin, note)| with_place(json!({ "message": note }), *origin));
    let value = json!({
        "file": source.name,
        "severity": severity,
        "message": diagnostic.message,
        "help": diagnostic.help,
        "notes": notes.collect::<Vec<_>>(),
    });
    with_place(value, diagnostic.origin)
}

fn with_place(mut value: Value, origin: Origin) -> Value {
    let position = origin.position();
    value["line"] = json!(position.map(|[line, _]| line));
    value["column"] = json!(position.map(|[_, column]| column));
    value["bytes"] = json!(origin.bytes().map(|bytes| [bytes.start, bytes.end]));
    value
}
