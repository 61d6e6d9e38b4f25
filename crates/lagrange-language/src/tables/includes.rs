//! Files of statements: reading of included files, and their names in messages.

use super::messages;
use super::{FileText, Reader};
use crate::syntax::ast::{Block, Declaration, IncludedFile, Name, Statement, StatementKind};
use crate::syntax::{parse_file, parse_included};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::{Origin, Report};
use lagrange_expr::limits::{MAX_PART_BYTES, MAX_PARTS_NESTED};
use std::path::{Component, Path, PathBuf};

/// State of reading files that include each other.
pub(super) struct Includer<'a> {
    read: Reader<'a>,
    /// Folder of the file of the whole declaration, from which other paths in it start.
    folder: PathBuf,
    /// Paths that have been read, so that each is read only once.
    known: HashSet<String>,
    /// Paths of the files that include the current one.
    around: Vec<String>,
    bytes: u64,
}

/// Returns the paths that statements include.
fn paths(statements: &[Statement]) -> Vec<Name> {
    let paths = statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Block(Block::Include(path)) => Some(path.clone()),
        _ => None,
    });
    paths.collect()
}

impl<'a> Includer<'a> {
    pub(super) fn new(read: Reader<'a>) -> Self {
        Includer { read, folder: PathBuf::new(), known: HashSet::default(), around: Vec::new(), bytes: 0 }
    }

    /// Reads the files of statements that a declaration includes. Errors in files are reported.
    pub(super) fn read_statements(&mut self, declaration: &mut Declaration, report: &mut Report) {
        let root = self.read_whole(declaration, report);
        let mut parts = Vec::new();
        for path in paths(&declaration.statements) {
            let root = root.unwrap_or(path.span.into());
            self.include(&path, root, (&mut *declaration, &mut parts), report);
        }
        parts.append(&mut declaration.statements);
        declaration.statements = parts;
    }

    /// Replaces a declaration that consists of a file by the one in it. Returns where the file is
    /// named.
    fn read_whole(&mut self, declaration: &mut Declaration, report: &mut Report) -> Option<Origin> {
        let mut root = None;
        while let Some(path) = whole_file(declaration) {
            // Unless it is read, nothing is known about what the file declares.
            declaration.statements.clear();
            declaration.unreadable_words.insert(path.text.clone());
            let root = *root.get_or_insert(path.span.into());
            let Some((file, known)) = self.open(&path, report) else { break };
            let (whole, span_file) = parse_file((&path, &file.text), report);
            let mut included = std::mem::take(&mut declaration.included);
            included.push(IncludedFile { path: path.text.clone(), watched: file.path, span_file, root });
            if let Some(whole) = whole {
                *declaration = whole;
            }
            declaration.included = included;
            self.folder = Path::new(&known).parent().map(Path::to_owned).unwrap_or_default();
            self.around.push(known);
        }
        root
    }

    /// Reads a file of parts and the files that it includes. `root` is the place in the
    /// declaration.
    fn include(
        &mut self,
        path: &Name,
        root: Origin,
        (declaration, parts): (&mut Declaration, &mut Vec<Statement>),
        report: &mut Report,
    ) {
        let Some((file, known)) = self.open(path, report) else { return };
        let (statements, span_file) = parse_included((path, &file.text), declaration, report);
        let included = IncludedFile { path: path.text.clone(), watched: file.path, span_file, root };
        declaration.included.push(included);
        self.around.push(known);
        for inner in paths(&statements) {
            self.include(&inner, root, (&mut *declaration, &mut *parts), report);
        }
        self.around.pop();
        parts.extend(statements.into_iter().filter_map(|statement| part(statement, report)));
    }

    /// Reads a file that is not known yet, and returns it with the path by which it then is.
    fn open(&mut self, path: &Name, report: &mut Report) -> Option<(FileText, String)> {
        let known = self.path(&path.text);
        if self.around.contains(&known) {
            let message = messages::includes_itself(&path.text);
            report.error(path.span, message).help(messages::INCLUDES_ITSELF_HELP);
            return None;
        }
        if self.around.len() >= MAX_PARTS_NESTED {
            let message = messages::too_deep(MAX_PARTS_NESTED);
            report.error(path.span, message).help(messages::TOO_MUCH_TEXT_HELP);
            return None;
        }
        if !self.known.insert(known.clone()) {
            return None;
        }
        let (message, help) = match (self.read)(&known) {
            Ok(file) if self.bytes + file.text.len() as u64 <= MAX_PART_BYTES => {
                self.bytes += file.text.len() as u64;
                return Some((file, known));
            }
            Ok(_) => (messages::too_much_text(&path.text, MAX_PART_BYTES), messages::TOO_MUCH_TEXT_HELP),
            Err(reason) => (messages::unreadable(&path.text, &reason), messages::UNREADABLE_PARTS_HELP),
        };
        report.error(path.span, message).help(help);
        None
    }

    /// Returns the path of a file that the declaration names, in one spelling for each file.
    fn path(&self, named: &str) -> String {
        let mut path = PathBuf::new();
        for component in self.folder.join(named).components() {
            let is_left = matches!(path.components().next_back(), Some(Component::Normal(_)));
            match component {
                Component::CurDir => {}
                Component::ParentDir if is_left => drop(path.pop()),
                _ => path.push(component),
            }
        }
        path.to_string_lossy().into_owned()
    }

    /// Reads a file that the declaration names.
    pub(super) fn text(&self, path: &str) -> Result<FileText, String> {
        (self.read)(&self.path(path))
    }
}

/// Returns the path of the file that a declaration without a header consists of.
fn whole_file(declaration: &Declaration) -> Option<Name> {
    match &declaration.statements[..] {
        [Statement { kind: StatementKind::Block(Block::Include(path)), .. }] if !declaration.has_header => {
            Some(path.clone())
        }
        _ => None,
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
