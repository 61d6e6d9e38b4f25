//! Warnings about a declaration with expanded arrays, in terms of the original.

use std::collections::{BTreeMap, BTreeSet};

use super::messages;
use crate::syntax::ast::{ArrayElement, Declaration, DeclaredArray, PlacedInstance};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::{Diagnostic, Origin, Report, Severity};

/// Elements by name in expanded declarations.
type ElementsByName<'d> = HashMap<&'d str, (&'d DeclaredArray, &'d ArrayElement)>;

/// Reports each error in a loop or a part once. An array is used if one of its elements is used,
/// and a member of a part if it is used in one placement. Anything in an index is also used.
pub fn once_for_each_array(declaration: &Declaration, report: &mut Report) {
    let (elements, counted) = (elements(declaration), &declaration.counted);
    let unused =
        report.diagnostics().iter().filter_map(name_of_unused).map(str::to_owned).collect::<BTreeSet<_>>();
    let used_members = used_members(declaration, &unused);
    let mut said = BTreeSet::new();
    once_at_each_place(report);
    report.revise(|diagnostic| {
        let Some(name) = name_of_unused(diagnostic).map(str::to_owned) else { return true };
        if counted.contains(&name) {
            return false;
        }
        let Some((array, _)) = elements.get(&&name[..]) else { return true };
        let own = array.member_of.as_ref().map_or(&array.name.text, |[_, own]| own);
        let is_first = match &array.member_of {
            None => array.elements.first().is_some_and(|first| first.name == name),
            Some(member) => said.insert(member) && !used_members.contains(&member) && !own.starts_with('_'),
        };
        let (element, whole) = (format!("`{name}`"), format!("`{own}`"));
        diagnostic.message = diagnostic.message.replace(&element, &whole);
        if let Some(help) = &mut diagnostic.help {
            *help = help.replace(&format!("`_{name}`"), &format!("`_{own}`"));
        }
        diagnostic.severity = Severity::Unused(own.clone());
        is_first
            && !counted.contains(own)
            && array.elements.iter().all(|element| unused.contains(&element.name))
    });
    say_where_placed(declaration, report);
    warn_of_unplaced(declaration, report);
}

/// Warns about parts that nothing places.
fn warn_of_unplaced(declaration: &Declaration, report: &mut Report) {
    if report.has_errors() {
        return;
    }
    for name in &declaration.unplaced {
        let warning = report.unused(&name.text, name.span, messages::never_placed(&name.text));
        warning.help(messages::never_placed_help(&name.text));
    }
}

/// Returns the members of parts with an element that is used somewhere.
fn used_members<'d>(declaration: &'d Declaration, unused: &BTreeSet<String>) -> BTreeSet<&'d [String; 2]> {
    let is_used = |array: &&DeclaredArray| array.elements.iter().any(|one| !unused.contains(&one.name));
    declaration.arrays.iter().filter(is_used).filter_map(|array| array.member_of.as_ref()).collect()
}

/// Keeps the first error at each place.
fn once_at_each_place(report: &mut Report) {
    let mut places = BTreeSet::new();
    report.revise(|diagnostic| diagnostic.severity != Severity::Error || places.insert(place(diagnostic)));
}

/// Keeps the first error of those that say the same of a place. Formulas that are written out
/// several times, such as heights of terrain, would repeat them.
pub fn without_repetitions(report: &mut Report) {
    let mut said = BTreeSet::new();
    report.revise(|diagnostic| {
        diagnostic.severity != Severity::Error || said.insert((place(diagnostic), diagnostic.message.clone()))
    });
}

/// Adds the placements to errors in parts, and reports each error once.
pub(super) fn say_where_placed(declaration: &Declaration, report: &mut Report) {
    if declaration.placed.is_empty() {
        return;
    }
    once_at_each_place(report);
    let mut parts: BTreeMap<&str, (&PlacedInstance, usize)> = BTreeMap::new();
    for instance in &declaration.placed {
        parts.entry(&instance.part).or_insert((instance, 0)).1 += 1;
    }
    report.revise(|diagnostic| {
        let found = parts.values().find(|(instance, _)| contains(instance.definition, diagnostic.origin));
        let Some((instance, count)) = found else { return true };
        let (part, name) = (&instance.part, &instance.name);
        let note = match count {
            1 => messages::placed_here(part, name),
            2 => messages::placed_here_twice(part, name),
            _ => messages::placed_here_and(part, name, count - 1),
        };
        if !diagnostic.related.iter().any(|(_, other)| *other == note) {
            diagnostic.related(instance.origin, note);
        }
        true
    });
}

/// True if a place is within another one; false if that is unknown.
fn contains(outer: Origin, inner: Origin) -> bool {
    let ends = |origin: Origin| (origin.position(), origin.end.start());
    let ((Some([first, column]), last), (Some([line, at]), _)) = (ends(outer), ends(inner)) else {
        return false;
    };
    // In the compiler, all tokens of an included file have the same place.
    let is_known = (first, column) != (last.line, last.column + 1);
    let is_behind = (line, at) >= (first, column) && (line, at) <= (last.line, last.column + 1);
    is_known && is_behind && outer.start.file() == inner.start.file()
}

/// Replaces names of elements in messages by those in the declaration: `theta[2]`, not `theta_2`.
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

/// Returns the text with the names of elements between backticks as they are written.
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

/// Returns the first and last line and column, and the message if these are unknown.
fn place(diagnostic: &Diagnostic) -> ([(usize, usize); 2], String) {
    let (start, end) = (diagnostic.origin.start.start(), diagnostic.origin.end.end());
    let message = if start.line > 0 { String::new() } else { diagnostic.message.clone() };
    ([(start.line, start.column), (end.line, end.column)], message)
}
