//! Comma-separated values in the format of saved trajectories.

use std::borrow::ToOwned;
use std::path::Path;
use std::string::{String, ToString};
use std::vec::Vec;

use super::data::{Data, DataError, Measured};
use crate::simulate::TIME;

impl Data {
    /// Reads comma-separated values as [`write_csv`](crate::simulate::Trajectory::write_csv) writes
    /// them: a line of names, among them `t`, and a line for each time. A name may end in its unit,
    /// as in `x in m`. A cell may be empty.
    ///
    /// # Errors
    /// If the file cannot be read, or has another format; with the line.
    pub fn read_csv(path: impl AsRef<Path>) -> Result<Data, DataError> {
        let path = path.as_ref();
        let text = std::fs::read_to_string(path)
            .map_err(|error| DataError::Unreadable { path: path.to_owned(), reason: error.to_string() })?;
        Data::parse_csv(&text)
    }

    /// Reads comma-separated values as [`read_csv`](Self::read_csv) does, from a text.
    ///
    /// # Errors
    /// If it has another format; with the line.
    pub fn parse_csv(text: &str) -> Result<Data, DataError> {
        parse(text)
    }
}

/// Reads names and numbers.
fn parse(text: &str) -> Result<Data, DataError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = text.lines().enumerate().map(|(index, line)| (index + 1, line));
    let (_, head) = lines.next().ok_or(DataError::NoTimes)?;
    let mut columns = cells(head, 1)?.iter().map(|cell| Measured::named(cell)).collect::<Vec<_>>();
    for (line, text) in lines.filter(|(_, text)| !text.trim().is_empty()) {
        let cells = cells(text, line)?;
        if cells.len() != columns.len() {
            return Err(DataError::Cells { line, found: cells.len(), wanted: columns.len() });
        }
        for (column, cell) in columns.iter_mut().zip(cells) {
            let value = number(&cell, line, column)?;
            column.values.push(value);
        }
    }
    let without = |row| DataError::NotANumber { line: row + 2, column: TIME.into(), text: String::new() };
    Data::of_columns(columns, without)
}

/// Returns the number in a cell, if it is not empty.
fn number(cell: &str, line: usize, column: &Measured) -> Result<Option<f64>, DataError> {
    let cell = cell.trim();
    if cell.is_empty() {
        return Ok(None);
    }
    let wrong = || DataError::NotANumber { line, column: column.name.clone(), text: cell.to_string() };
    cell.parse::<f64>().ok().filter(|value| value.is_finite()).map(Some).ok_or_else(wrong)
}

/// Returns the cells of a line (RFC 4180, without line breaks in cells).
fn cells(line: &str, number: usize) -> Result<Vec<String>, DataError> {
    let mut cells = Vec::new();
    let mut rest = line;
    loop {
        let (cell, after) = match rest.strip_prefix('"') {
            Some(quoted) => quotation(quoted).ok_or(DataError::OpenQuotation { line: number })?,
            None => {
                let end = rest.find(',').unwrap_or(rest.len());
                (rest[..end].to_string(), &rest[end..])
            }
        };
        cells.push(cell);
        match after.strip_prefix(',') {
            Some(others) => rest = others,
            None if after.trim().is_empty() => return Ok(cells),
            None => return Err(DataError::OpenQuotation { line: number }),
        }
    }
}

/// Returns the text up to the closing quotation mark, and the rest after it. A doubled mark stands
/// for one.
fn quotation(text: &str) -> Option<(String, &str)> {
    let mut cell = String::new();
    let mut rest = text;
    loop {
        let end = rest.find('"')?;
        cell.push_str(&rest[..end]);
        rest = &rest[end + 1..];
        match rest.strip_prefix('"') {
            Some(others) => {
                cell.push('"');
                rest = others;
            }
            None => return Some((cell, rest)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DataError, parse};

    #[test]
    fn names_units_gaps_and_quotations_are_read() {
        let data =
            parse("\u{feff}x in m,\"t in s\",'=a,\"d(\"\"x\"\",y)\"\r\n1,0,,3e-1\r\n\r\n-2.5,1,4,5\r\n")
                .unwrap();
        assert_eq!(data.times(), [0.0, 1.0]);
        assert_eq!(data.column("x"), Some(&[Some(1.0), Some(-2.5)][..]));
        assert_eq!(data.column("=a"), Some(&[None, Some(4.0)][..]));
        assert_eq!(data.column("d(\"x\",y)"), Some(&[Some(0.3), Some(5.0)][..]));
        assert_eq!(data.columns[0].unit.as_deref(), Some("m"));
    }

    #[test]
    fn mistakes_are_told_with_their_line() {
        let error = |text: &str| parse(text).unwrap_err();
        assert_eq!(error(""), DataError::NoTimes);
        assert_eq!(error("x,y\n1,2"), DataError::NoTimes);
        assert_eq!(error("t,x\n\n1,2,3"), DataError::Cells { line: 3, found: 3, wanted: 2 });
        assert_eq!(error("t,x\n1,\"2"), DataError::OpenQuotation { line: 2 });
        let wrong = |line, column: &str, text: &str| DataError::NotANumber {
            line,
            column: column.into(),
            text: text.into(),
        };
        assert_eq!(error("t,x\n1,NaN"), wrong(2, "x", "NaN"));
        assert_eq!(error("t,x\n1,2\n3,two"), wrong(3, "x", "two"));
        assert_eq!(error("t,x\n,2"), wrong(2, "t", ""));
    }
}
