//! Files that hold a grid. The first line contains a corner and the values of the second argument.
//! Each further line contains a value of the first argument and the values of the table.

use super::messages;
use super::{Complaint, NumberedLine, begins_number, fields, help_with_count, is_name, numbers};
use crate::syntax::ast::TableDefinition;
use lagrange_expr::limits::MAX_POINTS;

/// Returns the fields behind the corner if the first line begins a grid. The corner is empty or a
/// name; the other lines of files begin with a number, or all their fields are names.
pub(super) fn columns<'a>(lines: &[NumberedLine<'a>]) -> Option<Vec<&'a str>> {
    let (_, first) = lines.first()?;
    let head = fields(first.trim());
    if !head.iter().any(|field| begins_number(field)) {
        return None;
    }
    if is_name(head[0]) {
        return Some(head[1..].to_vec());
    }
    // An empty corner before a tab or blanks.
    let is_indented = first.starts_with([' ', '\t']);
    let is_shorter = |(_, next): &NumberedLine<'_>| fields(next.trim()).len() == head.len() + 1;
    (is_indented && lines.get(1).is_some_and(is_shorter)).then_some(head)
}

/// Returns the points of a grid, row by row.
pub(super) fn points(
    columns: &[&str],
    lines: &[NumberedLine<'_>],
    table: &TableDefinition,
) -> Result<Vec<(usize, Vec<f64>)>, Complaint> {
    let Some(((head, _), rows)) = lines.split_first() else { return Ok(Vec::new()) };
    let [along_rows, along_columns] = [0, 1].map(|axis| table.parameters[axis].text.as_str());
    let count = rows.len().saturating_mul(columns.len());
    if count > MAX_POINTS {
        let complaint = messages::too_many(&table.name.text, count, MAX_POINTS);
        return Err((*head, complaint, messages::TOO_MANY_HELP));
    }
    let columns = numbers(columns, messages::GRID_HELP).map_err(|(text, help)| (*head, text, help))?;
    for pair in columns.windows(2) {
        ascend(along_columns, *head, (pair[0], pair[1]))?;
    }
    let mut points = Vec::with_capacity(count);
    let mut before = f64::NEG_INFINITY;
    for (line, text) in rows {
        let numbers = row(text.trim(), columns.len()).map_err(|(text, help)| (*line, text, help))?;
        ascend(along_rows, *line, (before, numbers[0]))?;
        before = numbers[0];
        let values = columns.iter().zip(&numbers[1..]);
        points.extend(values.map(|(column, value)| (*line, vec![before, *column, *value])));
    }
    Ok(points)
}

/// Returns the numbers of a line: a value of the first argument and a value for each column.
fn row(text: &str, columns: usize) -> Result<Vec<f64>, (String, &'static str)> {
    let numbers = numbers(&fields(text), messages::GRID_HELP)?;
    let (found, needed) = (numbers.len(), columns + 1);
    match found == needed {
        true => Ok(numbers),
        false => {
            let complaint = messages::wrong_row(found, needed, columns);
            Err((complaint, help_with_count(found, needed, messages::GRID_HELP)))
        }
    }
}

fn ascend(argument: &str, line: usize, (before, after): (f64, f64)) -> Result<(), Complaint> {
    match before < after {
        true => Ok(()),
        false => Err((line, messages::not_ascending(argument, before, after), messages::AXIS_ASCENDS_HELP)),
    }
}
