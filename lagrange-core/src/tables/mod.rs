//! Files of tables: read, and taken apart into numbers.
//!
//! Nothing here touches a file system: who reads declarations says how files are read. A file has a point on each line, its numbers
//! separated by commas, semicolons, tabs or blanks; the first line may name the columns, and lines that begin with `#` are comments.

mod messages;

#[cfg(test)]
mod tests;

use crate::diagnostics::Report;
use crate::syntax::ast::{Declaration, Name, StatementKind, TableFile, TableSource};

/// A file as it was read.
#[derive(Clone, Debug)]
pub struct FileText {
    /// Path under which the compiler finds it, so that what is emitted is compiled again when it changes; nothing if it need not.
    pub path: String,
    /// What it says.
    pub text: String,
}

/// Reads files: from the path that a declaration gives to the text, or to the reason why there is none.
pub type Reader<'a> = &'a dyn Fn(&str) -> Result<FileText, String>;

/// The reader of those who read no files.
///
/// # Errors
/// Always.
pub fn no_files(_: &str) -> Result<FileText, String> {
    Err(messages::NO_FILES.to_owned())
}

/// Reads the files that tables name. What is wrong with them is reported where they are named.
pub fn read_files(declaration: &mut Declaration, read: Reader<'_>, report: &mut Report) {
    for statement in &mut declaration.statements {
        if let StatementKind::Table(table) = &mut statement.kind
            && let TableSource::File { path, contents } = &mut table.source
        {
            let columns = table.parameters.len() + 1;
            *contents = match read(&path.text) {
                Ok(file) => points(&file.text, columns, path, report)
                    .map(|points| TableFile { path: file.path, points }),
                Err(reason) => {
                    let message = messages::unreadable(&path.text, &reason);
                    report.error(path.span, message).help(messages::UNREADABLE_HELP);
                    None
                }
            };
        }
    }
}

/// The points in a text, each behind the number of its line; nothing but a report if one of them is none.
fn points(text: &str, columns: usize, path: &Name, report: &mut Report) -> Option<Vec<(usize, Vec<f64>)>> {
    let lines = text.lines().enumerate().map(|(number, line)| (number + 1, line.trim()));
    let lines = lines.filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let mut points = Vec::new();
    for (position, (line, text)) in lines.enumerate() {
        let fields = fields(text);
        let numbers =
            fields.iter().map(|field| field.parse::<f64>().ok().filter(|number| number.is_finite()));
        let numbers = numbers.collect::<Vec<_>>();
        if position == 0 && numbers.iter().all(Option::is_none) {
            // Names of the columns.
            continue;
        }
        let wrong = fields.iter().zip(&numbers).find(|(_, number)| number.is_none());
        let complaint = match wrong {
            Some((field, _)) => messages::no_number(field),
            None if fields.len() != columns => messages::wrong_columns(fields.len(), columns),
            None => {
                points.push((line, numbers.into_iter().flatten().collect()));
                continue;
            }
        };
        let has_comma = wrong.is_some_and(|(field, _)| field.contains(','));
        let help = if has_comma { messages::DECIMAL_COMMA_HELP } else { messages::FORM_HELP };
        report.error(path.span, messages::on_line(line, &path.text, &complaint)).help(help);
        return None;
    }
    Some(points)
}

/// What a line consists of, between the strongest separators in it: in `1,5; 2` decimals are written with a comma.
fn fields(line: &str) -> Vec<&str> {
    match [';', '\t', ','].into_iter().find(|separator| line.contains(*separator)) {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    }
}
