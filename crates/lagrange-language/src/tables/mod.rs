//! Files named in a declaration: tables, split into numbers, and parts.
//!
//! This module does not access the file system: the caller of the parser provides a reader of
//! files. A table file has one point on each line, with numbers separated by commas, semicolons,
//! tabs or blanks. The first line may name the columns, and text after `#` is a comment. Tables of
//! two arguments may also be grids, whose first line begins with an empty or named corner.

mod grid;
mod includes;
pub mod messages;

#[cfg(test)]
mod tests;

use crate::syntax::ast::{Declaration, StatementKind, TableDefinition, TableFile, TableSource};
use includes::Includer;
pub use includes::name_files;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::limits::MAX_FILE_BYTES;

/// The content of a file.
#[derive(Clone, Debug)]
pub struct FileText {
    /// Path under which the compiler finds it, so that emitted code is recompiled when it changes;
    /// empty if this is not needed.
    pub path: String,
    /// Content.
    pub text: String,
}

/// Mark that some programs write at the beginning of UTF-8 text.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// Returns the text of a file in UTF-8, of at most [`MAX_FILE_BYTES`].
///
/// # Errors
/// If there are too many bytes, or they are not UTF-8. The error text is meant to follow the name
/// of the file.
pub fn decoded(bytes: Vec<u8>) -> Result<String, String> {
    if bytes.len() as u64 > MAX_FILE_BYTES {
        return Err(messages::file_too_large(MAX_FILE_BYTES));
    }
    if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        return Err(messages::UTF_16.to_owned());
    }
    if bytes.contains(&0) {
        return Err(messages::BINARY.to_owned());
    }
    String::from_utf8(bytes).map_err(|error| {
        let before = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        messages::not_utf_8(1 + before.iter().filter(|byte| **byte == b'\n').count())
    })
}

/// Function that reads files: it maps the path in a declaration to the text, or to the reason for
/// failure.
pub type Reader<'a> = &'a dyn Fn(&str) -> Result<FileText, String>;

/// Reads no files: every file is an error.
///
/// # Errors
/// Always.
pub fn no_files(_: &str) -> Result<FileText, String> {
    Err(messages::NO_FILES.to_owned())
}

/// Reads the files that a declaration includes, then those that tables name. Errors in them are
/// reported where they are named.
pub fn read_files(declaration: &mut Declaration, read: Reader<'_>, report: &mut Report) {
    let mut includer = Includer::new(read);
    includer.read_statements(declaration, report);
    let read: Reader<'_> = &|path| includer.text(path);
    let mut pending = declaration.statements.iter_mut().collect::<Vec<_>>();
    pending.reverse();
    while let Some(statement) = pending.pop() {
        match &mut statement.kind {
            StatementKind::Block(block) => {
                let (_, bodies) = block.parts_mut();
                pending.extend(bodies.into_iter().flatten().rev());
            }
            StatementKind::Table(table) => read_table(table, read, report),
            _ => {}
        }
    }
}

fn read_table(table: &mut TableDefinition, read: Reader<'_>, report: &mut Report) {
    let TableSource::File { path, .. } = &table.source else { return };
    let path = path.clone();
    let file = match read(&path.text) {
        Ok(file) => points(&file.text, table)
            .map(|points| TableFile { path: file.path, points })
            .map_err(|(line, complaint, help)| (messages::on_line(line, &path.text, &complaint), help)),
        Err(reason) => Err((messages::unreadable(&path.text, &reason), messages::UNREADABLE_HELP)),
    };
    let contents = match file {
        Ok(file) => Some(file),
        Err((message, help)) => {
            report.error(path.span, message).help(help);
            None
        }
    };
    table.source = TableSource::File { path, contents };
}

/// A line with its number, up to a comment.
type NumberedLine<'a> = (usize, &'a str);

/// The number of a line, what is wrong with it, and help.
type Complaint = (usize, String, &'static str);

/// Returns the points in a text, each with its line number, or the first error.
fn points(text: &str, table: &TableDefinition) -> Result<Vec<(usize, Vec<f64>)>, Complaint> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    let lines = text.lines().enumerate().map(|(number, line)| (number + 1, uncommented(line)));
    let lines = lines.filter(|(_, line)| !line.trim().is_empty()).collect::<Vec<_>>();
    let components = table.parameters.len() + 1;
    if let Some(columns) = grid::columns(&lines).filter(|_| components == 3) {
        return grid::points(&columns, &lines, table);
    }
    let has_names = lines.first().is_some_and(|(_, line)| are_names(&fields(line.trim())));
    let points = lines.iter().skip(usize::from(has_names)).map(|(line, text)| {
        let point = point(&fields(text.trim()), components);
        point.map(|point| (*line, point)).map_err(|(complaint, help)| (*line, complaint, help))
    });
    points.collect()
}

/// Returns the text before a comment.
fn uncommented(line: &str) -> &str {
    line.split('#').next().unwrap_or_default()
}

/// True if a line names columns; a line that begins like a number is a point.
fn are_names(fields: &[&str]) -> bool {
    fields.iter().any(|field| !field.is_empty()) && fields.iter().all(|field| is_name(field))
}

/// True if a field is neither a number nor one that went wrong.
fn is_name(field: &str) -> bool {
    !begins_number(field) && field.parse::<f64>().is_err()
}

fn begins_number(field: &str) -> bool {
    field.starts_with(|c: char| c.is_numeric() || "+-−.,".contains(c))
}

/// Returns the numbers of a point, or the error and its help.
fn point(fields: &[&str], components: usize) -> Result<Vec<f64>, (String, &'static str)> {
    let form = if components == 3 { messages::POINT_OR_GRID_HELP } else { messages::FORM_HELP };
    let numbers = numbers(fields, form)?;
    match numbers.len() {
        found if found == components => Ok(numbers),
        found => {
            let complaint = messages::wrong_columns(found, components);
            Err((complaint, help_with_count(found, components, form)))
        }
    }
}

/// Returns help for a line with a wrong number of numbers. In `1,5, 2,5`, every number looks like
/// two.
fn help_with_count(found: usize, needed: usize, form: &'static str) -> &'static str {
    if found == 2 * needed { messages::DECIMAL_COMMA_HELP } else { form }
}

/// Returns fields as numbers, or the error and its help.
fn numbers(fields: &[&str], form: &'static str) -> Result<Vec<f64>, (String, &'static str)> {
    let numbers = fields.iter().map(|field| match field.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) if field.contains(|c: char| c.is_ascii_digit()) => {
            Err((messages::too_large(field), messages::UNITS_HELP))
        }
        _ if field.contains(',') => Err((messages::no_number(field), messages::DECIMAL_COMMA_HELP)),
        _ => Err((messages::no_number(field), form)),
    });
    numbers.collect()
}

/// Splits a line at the strongest separators in it: in `1,5; 2`, decimals are written with a comma.
fn fields(line: &str) -> Vec<&str> {
    match [';', '\t', ','].into_iter().find(|separator| line.contains(*separator)) {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    }
}
