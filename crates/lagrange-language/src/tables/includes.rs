//! Files of parts: reading of included files, and their names in messages.

use super::messages;
use super::{FileText, Reader};
use crate::syntax::ast::{Block, Declaration, IncludedFile, Name, Statement, StatementKind};
use crate::syntax::parse_included;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_expr::limits::{MAX_PART_BYTES, MAX_PARTS_NESTED};

/// State of reading files that include each other.
struct Includer<'a> {
    read: Reader<'a>,
    /// Paths that have been read, so that each is read only once.
    known: HashSet<String>,
    /// Paths of the files that include the current one.
    around: Vec<String>,
    bytes: u64,
}

/// Inserts the parts of included files before the statements of a declaration. Errors in files are
/// reported.
pub(super) fn include_parts(declaration: &mut Declaration, read: Reader<'_>, report: &mut Report) {
    let paths = paths(&declaration.statements);
    if paths.is_empty() {
        return;
    }
    let mut includer = Includer { read, known: HashSet::default(), around: Vec::new(), bytes: 0 };
    let mut parts = Vec::new();
    for path in paths {
        includer.include(&path, path.span.into(), (&mut *declaration, &mut parts), report);
    }
    parts.append(&mut declaration.statements);
    declaration.statements = parts;
}

/// Returns the paths that statements include.
fn paths(statements: &[Statement]) -> Vec<Name> {
    let paths = statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Block(Block::Include(path)) => Some(path.clone()),
        _ => None,
    });
    paths.collect()
}

impl Includer<'_> {
    /// Reads a file and the files that it includes. `root` is the place in the declaration.
    fn include(
        &mut self,
        path: &Name,
        root: Origin,
        (declaration, parts): (&mut Declaration, &mut Vec<Statement>),
        report: &mut Report,
    ) {
        if self.around.contains(&path.text) {
            let message = messages::includes_itself(&path.text);
            report.error(path.span, message).help(messages::INCLUDES_ITSELF_HELP);
            return;
        }
        if self.around.len() >= MAX_PARTS_NESTED {
            let message = messages::too_deep(MAX_PARTS_NESTED);
            report.error(path.span, message).help(messages::TOO_MUCH_TEXT_HELP);
            return;
        }
        if !self.known.insert(path.text.clone()) {
            return;
        }
        let Some(file) = self.text(path, report) else { return };
        let (statements, span_file) = parse_included((path, &file.text), declaration, report);
        let included = IncludedFile { path: path.text.clone(), watched: file.path, span_file, root };
        declaration.included.push(included);
        self.around.push(path.text.clone());
        for inner in paths(&statements) {
            self.include(&inner, root, (&mut *declaration, &mut *parts), report);
        }
        self.around.pop();
        parts.extend(statements.into_iter().filter_map(|statement| part(statement, report)));
    }

    fn text(&mut self, path: &Name, report: &mut Report) -> Option<FileText> {
        let (message, help) = match (self.read)(&path.text) {
            Ok(file) if self.bytes + file.text.len() as u64 <= MAX_PART_BYTES => {
                self.bytes += file.text.len() as u64;
                return Some(file);
            }
            Ok(_) => (messages::too_much_text(&path.text, MAX_PART_BYTES), messages::TOO_MUCH_TEXT_HELP),
            Err(reason) => (messages::unreadable(&path.text, &reason), messages::UNREADABLE_PARTS_HELP),
        };
        report.error(path.span, message).help(help);
        None
    }
}

/// Returns a part of a file; anything else is reported.
fn part(mut statement: Statement, report: &mut Report) -> Option<Statement> {
    match &mut statement.kind {
        StatementKind::Block(Block::Part(part)) => {
            part.is_included = true;
            Some(statement)
        }
        StatementKind::Block(Block::Include(_)) => None,
        _ => {
            let error = report.error(statement.origin, messages::PARTS_ONLY);
            error.help(messages::PARTS_ONLY_HELP);
            None
        }
    }
}

/// Adds the file, line and column to messages about included files, and locates these where the
/// declaration includes the file.
pub fn name_files(declaration: &Declaration, report: &mut Report) {
    if declaration.included.is_empty() {
        return;
    }
    let moved = |origin: &mut Origin, text: &mut String| {
        let name = origin.start.file();
        let file = declaration.included.iter().find(|file| file.span_file.as_deref() == Some(&name));
        if let (Some(file), Some([line, column])) = (file, origin.position()) {
            *text = format!("{}:{line}:{column}: {text}", file.path);
            *origin = file.root;
        }
    };
    report.revise(|diagnostic| {
        moved(&mut diagnostic.origin, &mut diagnostic.message);
        diagnostic.related.iter_mut().for_each(|(origin, note)| moved(origin, note));
        true
    });
}
