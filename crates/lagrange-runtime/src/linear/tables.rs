//! Matrices with names of rows and columns, as text.

use std::fmt::{Display, Formatter, Result as Written};
use std::format;
use std::iter::once;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::linalg::dense::DenseMatrix;

/// Significant digits of entries, unless the format specifies a precision.
const DIGITS: usize = 6;

/// A matrix with names of its rows and columns, shown as a table.
pub(super) struct NamedMatrix<'a> {
    name: &'static str,
    matrix: &'a DenseMatrix,
    rows: Vec<&'a str>,
    columns: Vec<&'a str>,
}

impl<'a> NamedMatrix<'a> {
    pub(super) fn new(
        name: &'static str,
        matrix: &'a DenseMatrix,
        rows: &'a [impl AsRef<str>],
        columns: &'a [impl AsRef<str>],
    ) -> NamedMatrix<'a> {
        let rows = rows.iter().map(AsRef::as_ref).collect();
        NamedMatrix { name, matrix, rows, columns: columns.iter().map(AsRef::as_ref).collect() }
    }

    fn line(&self, row: usize, digits: usize) -> Vec<String> {
        let entries = self.matrix.row(row).iter().map(|entry| significant(*entry, digits));
        once(self.rows[row].to_string()).chain(entries).collect()
    }
}

/// Writes a line for each row, after the name of the matrix and those of the columns. The precision
/// is the number of significant digits.
impl Display for NamedMatrix<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let digits = f.precision().unwrap_or(DIGITS);
        let head = once(self.name).chain(self.columns.iter().copied()).map(ToString::to_string).collect();
        let lines = once(head).chain((0..self.rows.len()).map(|row| self.line(row, digits)));
        let lines = lines.collect::<Vec<Vec<String>>>();
        let width = |column: usize| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or(0);
        let widths = (0..=self.columns.len()).map(width).collect::<Vec<_>>();
        for (number, line) in lines.iter().enumerate() {
            let end = if number == 0 { "" } else { "\n" };
            write!(f, "{end}{:<width$}", line[0], width = widths[0])?;
            for (cell, width) in line.iter().zip(&widths).skip(1) {
                write!(f, "  {cell:>width$}")?;
            }
        }
        Ok(())
    }
}

/// Writes the matrices of a linear model below each other, without empty ones.
pub(super) fn write_model(
    f: &mut Formatter<'_>,
    [a, b, c, d]: [&DenseMatrix; 4],
    states: &[String],
    (inputs, outputs): (&[&str], &[&str]),
) -> Written {
    let tables = [
        NamedMatrix::new("A", a, states, states),
        NamedMatrix::new("B", b, states, inputs),
        NamedMatrix::new("C", c, outputs, states),
        NamedMatrix::new("D", d, outputs, inputs),
    ];
    let shown = tables.iter().filter(|table| !table.rows.is_empty() && !table.columns.is_empty());
    for (number, table) in shown.enumerate() {
        if number > 0 {
            writeln!(f)?;
        }
        table.fmt(f)?;
    }
    Ok(())
}

/// Writes a number with this many significant digits, without zeros at its end.
fn significant(number: f64, digits: usize) -> String {
    let digits = digits.max(1);
    let scientific = format!("{number:.*e}", digits - 1);
    let Some((mantissa, exponent)) = scientific.split_once('e') else { return scientific };
    let is_short = |exponent: &i32| (-5..digits as i32).contains(exponent);
    match exponent.parse::<i32>().ok().filter(is_short) {
        _ if number == 0.0 => "0".to_string(),
        None => format!("{}e{exponent}", without_zeros(mantissa)),
        Some(exponent) => {
            let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
            without_zeros(&format!("{number:.decimals$}")).to_string()
        }
    }
}

/// Omits zeros at the end of a decimal fraction.
fn without_zeros(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}

#[cfg(test)]
mod tests {
    use super::{DenseMatrix, NamedMatrix, significant};
    use std::format;

    #[test]
    fn numbers_have_their_significant_digits() {
        let cases = [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-10.000_000_000_000_08, "-10"),
            (61.826_287_3, "61.8263"),
            (999_999.7, "1e6"),
            (123_456.0, "123456"),
            (123_456_789.0, "1.23457e8"),
            (0.000_012_345_678, "0.0000123457"),
            (1.5e-9, "1.5e-9"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ];
        for (number, text) in cases {
            assert_eq!(significant(number, 6), text);
        }
        assert_eq!([1, 3, 17].map(|digits| significant(0.1, digits)), ["0.1", "0.1", "0.10000000000000001"]);
        assert_eq!(significant(7.25, 0), "7");
    }

    #[test]
    fn columns_are_aligned() {
        let matrix = DenseMatrix::from_rows(&[[1.0, -20.5], [1.0 / 3.0, 0.0]]);
        let table = NamedMatrix::new("K", &matrix, &["u", "thrust"], &["x", "θ̇"]);
        assert_eq!(
            format!("{table:.3}"),
            "\
K           x     θ̇
u           1  -20.5
thrust  0.333      0"
        );
    }
}
