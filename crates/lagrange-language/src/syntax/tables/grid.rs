//! Tables of two arguments by axes and a matrix: `[[a, b], [c, d]], rows: [x, y], columns: [z, w]`.

use proc_macro2::Delimiter;

use super::LABELS;
use crate::syntax::ast::{AstId, Name, TableGrid, TableSource};
use crate::syntax::cursor::{Cursor, group_origin};
use crate::syntax::messages;
use crate::syntax::messages::forms::form;
use crate::syntax::messages::tables as words;
use crate::syntax::parser::{Parsed, Parser};
use lagrange_expr::diagnostics::Origin;

/// Numbers in brackets, with the place of the brackets.
pub(super) type Row = (Vec<AstId>, Origin);

/// The values of a table, after its `=`.
pub(super) enum TableValues {
    /// Points or a file.
    Source(TableSource),
    /// A matrix, whose axes follow as options.
    Rows(Vec<Row>),
}

impl Parser<'_> {
    /// Reads the numbers of an axis, `[1, 2]`.
    pub(super) fn axis(&mut self, cursor: &mut Cursor) -> Parsed<Row> {
        let Some(group) = cursor.eat_group(Delimiter::Bracket) else {
            let message = messages::expected(words::AXIS, cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, words::AXIS_HELP));
        };
        Ok((self.numbers(&group, "`,` or `]`")?, group_origin(&group)))
    }

    /// Reads the rows of a matrix.
    pub(super) fn rows(&mut self, cursor: &mut Cursor) -> Parsed<TableValues> {
        let rows =
            self.groups(Delimiter::Bracket, (words::ROW, form("table")), cursor, |parser, group| {
                Ok((parser.numbers(group, "`,` or `]`")?, group_origin(group)))
            })?;
        Ok(TableValues::Rows(rows))
    }

    /// Returns points or a file without axes, or a matrix with both.
    pub(super) fn on_axes(
        &mut self,
        values: TableValues,
        axes: [Option<Row>; 2],
        (name, parameters): (&Name, &[Name]),
    ) -> Parsed<TableSource> {
        match (values, axes) {
            (TableValues::Source(source), [None, None]) => Ok(source),
            (TableValues::Source(source), axes) => {
                let (label, place) = match axes {
                    [Some((_, place)), _] => (LABELS[0], place),
                    [None, other] => (LABELS[1], other.map_or(name.span.into(), |(_, place)| place)),
                };
                let is_file = matches!(source, TableSource::File { .. });
                let help = if is_file { words::AXES_OF_FILES_HELP } else { words::ROWS_HELP };
                Err(self.fail_with_help(place, words::axis_without_rows(label), help))
            }
            (TableValues::Rows(rows), [Some(first), Some(second)]) => {
                self.counts_of_rows(&rows, [&first, &second], parameters)?;
                let rows = rows.into_iter().map(|(row, _)| row).collect();
                Ok(TableSource::Grid(TableGrid { axes: [first.0, second.0], rows }))
            }
            (TableValues::Rows(_), axes) => {
                let axis = usize::from(axes[0].is_some());
                let message = words::no_axis(&name.text, LABELS[axis], &parameters[axis].text);
                Err(self.fail_with_help(name.span, message, words::axes_help(parameters)))
            }
        }
    }

    /// Reports a matrix whose size is not that of its axes.
    fn counts_of_rows(&mut self, rows: &[Row], axes: [&Row; 2], parameters: &[Name]) -> Parsed<()> {
        let [(along_rows, place_of_rows), (along_columns, place_of_columns)] = axes;
        let is_wrong = |(row, _): &&Row| row.len() != along_columns.len();
        let help = words::axes_help(parameters);
        let lengths = || rows.iter().map(|(row, _)| row.len());
        // If all rows have the same length, the mistake is in the axis.
        if let Some(length) = lengths().next().filter(|first| lengths().all(|length| length == *first))
            && length != along_columns.len()
        {
            let message = words::columns_differ(along_columns.len(), length);
            return Err(self.fail_with_help(*place_of_columns, message, &help));
        }
        if let Some((row, place)) = rows.iter().find(is_wrong) {
            let message = words::row_differs(row.len(), along_columns.len());
            return Err(self.fail_with_help(*place, message, &help));
        }
        if rows.len() != along_rows.len() {
            let message = words::rows_differ(along_rows.len(), rows.len());
            return Err(self.fail_with_help(*place_of_rows, message, &help));
        }
        Ok(())
    }
}
