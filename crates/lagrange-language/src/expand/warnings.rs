//! Warnings about a declaration with expanded arrays, in the words of the original.

use std::collections::BTreeSet;

use crate::syntax::ast::{ArrayElement, Declaration, DeclaredArray};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::{Diagnostic, Report, Severity};

/// Elements by their names in expanded declarations.
type ElementsByName<'d> = HashMap<&'d str, (&'d DeclaredArray, &'d ArrayElement)>;

/// Reports each mistake in a loop once, and as unused no constant by which was counted, nor an
/// array of which an element is used.
pub fn once_for_each_array(declaration: &Declaration, report: &mut Report) {
    let (elements, counted) = (elements(declaration), &declaration.counted);
    let unused =
        report.diagnostics().iter().filter_map(name_of_unused).map(str::to_owned).collect::<BTreeSet<_>>();
    let mut places = BTreeSet::new();
    report.revise(|diagnostic| {
        if diagnostic.severity == Severity::Error {
            return places.insert(place(diagnostic));
        }
        let Some(name) = name_of_unused(diagnostic).map(str::to_owned) else { return true };
        if counted.contains(&name) {
            return false;
        }
        let Some((array, _)) = elements.get(&&name[..]) else { return true };
        let is_first = array.elements.first().is_some_and(|first| first.name == name);
        let (element, whole) = (format!("`{name}`"), format!("`{}`", array.name.text));
        diagnostic.message = diagnostic.message.replace(&element, &whole);
        diagnostic.severity = Severity::Unused(array.name.text.clone());
        is_first
            && !counted.contains(&array.name.text)
            && array.elements.iter().all(|element| unused.contains(&element.name))
    });
}

/// Gives elements in messages the names of the declaration: `theta[2]`, not `theta_2`.
pub fn name_elements(declaration: &Declaration, report: &mut Report) {
    if declaration.arrays.is_empty() || report.diagnostics().is_empty() {
        return;
    }
    let elements = elements(declaration);
    report.revise(|diagnostic| {
        let Diagnostic { message, related, help, .. } = diagnostic;
        let notes = related.iter_mut().map(|(_, note)| note);
        for text in notes.chain([message]).chain(help) {
            *text = with_elements_as_written(text, &elements);
        }
        true
    });
}

fn elements(declaration: &Declaration) -> ElementsByName<'_> {
    let arrays = declaration.arrays.iter();
    let elements = arrays.flat_map(|array| array.elements.iter().map(move |element| (array, element)));
    elements.map(|(array, element)| (&element.name[..], (array, element))).collect()
}

/// The text with the names of elements between backticks as they are written.
fn with_elements_as_written(text: &str, elements: &ElementsByName<'_>) -> String {
    let quoted = text.split('`').enumerate().map(|(number, part)| match number % 2 {
        0 => part.to_owned(),
        _ => code_with_elements_as_written(part, elements),
    });
    quoted.collect::<Vec<_>>().join("`")
}

fn code_with_elements_as_written(code: &str, elements: &ElementsByName<'_>) -> String {
    let mut written = String::new();
    let mut rest = code;
    while let Some(first) = rest.chars().next() {
        let is_in_name = |c: char| c.is_alphanumeric() || c == '_';
        let is_of_run = |c: char| is_in_name(c) == is_in_name(first);
        let run = rest.find(|c| !is_of_run(c)).map_or(rest, |end| &rest[..end]);
        written.push_str(elements.get(&run).map_or(run, |(_, element)| &element.written));
        rest = &rest[run.len()..];
    }
    written
}

fn name_of_unused(diagnostic: &Diagnostic) -> Option<&str> {
    match &diagnostic.severity {
        Severity::Unused(name) => Some(name),
        Severity::Error | Severity::Expensive | Severity::Doubtful => None,
    }
}

/// First and last line and column, and where there are none the message.
fn place(diagnostic: &Diagnostic) -> ([(usize, usize); 2], String) {
    let (start, end) = (diagnostic.origin.start.start(), diagnostic.origin.end.end());
    let message = if start.line > 0 { String::new() } else { diagnostic.message.clone() };
    ([(start.line, start.column), (end.line, end.column)], message)
}
