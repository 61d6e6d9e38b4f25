//! What is found of a declaration whose arrays are written out, in the words of the one that was written.

use std::collections::BTreeSet;

use crate::diagnostics::{Diagnostic, Report, Severity};
use crate::syntax::ast::Declaration;

/// Reports each mistake in a loop once, and as unused no constant by which was counted, nor an array of which an element is used.
pub fn once_for_each_array(declaration: &Declaration, report: &mut Report) {
    let Declaration { arrays, counted, .. } = declaration;
    let unused =
        report.diagnostics().iter().filter_map(name_of_unused).map(str::to_owned).collect::<BTreeSet<_>>();
    let mut places = BTreeSet::new();
    report.revise(|diagnostic| {
        if diagnostic.severity == Severity::Error {
            return places.insert(place(diagnostic));
        }
        let Some(name) = name_of_unused(diagnostic) else { return true };
        if counted.contains(&name.to_owned()) {
            return false;
        }
        let Some(array) =
            arrays.iter().find(|array| array.elements.iter().any(|element| element.name == name))
        else {
            return true;
        };
        let is_first = array.elements.first().is_some_and(|first| first.name == name);
        let is_unused = array.elements.iter().all(|element| unused.contains(&element.name));
        let (element, whole) = (format!("`{name}`"), format!("`{}`", array.name.text));
        diagnostic.message = diagnostic.message.replace(&element, &whole);
        diagnostic.severity = Severity::Unused(array.name.text.clone());
        is_first && is_unused && !counted.contains(&array.name.text)
    });
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
