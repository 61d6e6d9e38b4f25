//! Measured columns.

use std::fmt::{Debug, Display, Formatter, Result as Written};
use std::path::PathBuf;
use std::string::{String, ToString};
use std::vec::Vec;

use crate::simulate::TIME;

/// Measured values in columns, at ascending times. Values may be missing.
#[derive(Clone, PartialEq, Debug)]
pub struct Data {
    pub(super) times: Vec<f64>,
    pub(super) columns: Vec<Measured>,
}

/// A measured column.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Measured {
    pub(super) name: String,
    /// The unit written after the name.
    pub(super) unit: Option<String>,
    pub(super) values: Vec<Option<f64>>,
}

impl Measured {
    /// Returns a column without values, from its name with a unit, as in `x in m`. A leading
    /// apostrophe, which keeps spreadsheets from treating a name as a formula, is removed.
    pub(super) fn named(name: &str) -> Measured {
        let name = name.trim();
        let name = name.strip_prefix('\'').unwrap_or(name);
        let (name, unit) = match name.rsplit_once(" in ") {
            Some((name, unit)) => (name, Some(unit.trim().to_string())),
            None => (name, None),
        };
        Measured { name: name.trim().to_string(), unit, values: Vec::new() }
    }
}

impl Data {
    /// Returns data with the times of the column `t`.
    ///
    /// # Errors
    /// If there is no such column. The error of the first missing time is that of its row, counted
    /// from zero.
    pub(super) fn of_columns(
        mut columns: Vec<Measured>,
        missing: impl Fn(usize) -> DataError,
    ) -> Result<Data, DataError> {
        let place = columns.iter().position(|column| column.name == TIME).ok_or(DataError::NoTimes)?;
        let times = columns.remove(place).values.into_iter().enumerate();
        let times = times.map(|(row, time)| time.ok_or_else(|| missing(row)));
        Ok(Data { times: times.collect::<Result<_, _>>()?, columns })
    }

    /// Creates data without columns, at these times.
    pub fn new(times: impl Into<Vec<f64>>) -> Data {
        Data { times: times.into(), columns: Vec::new() }
    }

    /// Adds a column of numbers, or of optional numbers if some are missing.
    #[must_use]
    pub fn with<T: Into<Option<f64>>>(mut self, name: &str, values: impl IntoIterator<Item = T>) -> Data {
        let values = values.into_iter().map(Into::into).collect();
        self.columns.push(Measured { name: name.to_string(), unit: None, values });
        self
    }

    /// Returns the data with only these columns, such as those that the system defines. Names
    /// without a column are ignored.
    #[must_use]
    pub fn only<const N: usize>(mut self, names: [&str; N]) -> Data {
        self.columns.retain(|column| names.contains(&column.name.as_str()));
        self
    }

    /// Returns the times.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// Returns the names of the columns, without times.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.columns.iter().map(|column| column.name.as_str())
    }

    /// Returns the values of a column.
    pub fn column(&self, name: &str) -> Option<&[Option<f64>]> {
        let found = self.columns.iter().find(|column| column.name == name)?;
        Some(&found.values)
    }
}

/// An error in reading data from a file.
#[derive(Clone, PartialEq, Eq)]
#[non_exhaustive]
pub enum DataError {
    /// The operating system cannot read the file.
    Unreadable {
        /// Its path.
        path: PathBuf,
        /// The reason.
        reason: String,
    },
    /// There is no column of times.
    NoTimes,
    /// A line has more or fewer cells than the first one.
    Cells {
        /// Number of the line, counted from one.
        line: usize,
        /// Number of cells.
        found: usize,
        /// Number of names.
        wanted: usize,
    },
    /// A cell is not a finite number.
    NotANumber {
        /// Number of the line, counted from one.
        line: usize,
        /// Name of the column.
        column: String,
        /// The cell.
        text: String,
    },
    /// A column of a Parquet file does not consist of numbers.
    NotNumbers {
        /// Name of the column.
        column: String,
    },
    /// A value in a column of a Parquet file is not a finite number.
    NotANumberInRow {
        /// Number of the row, counted from one.
        row: usize,
        /// Name of the column.
        column: String,
        /// The value.
        text: String,
    },
    /// A cell begins with a quotation mark that is never closed.
    OpenQuotation {
        /// Number of the line, counted from one.
        line: usize,
    },
}

impl Display for DataError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        match self {
            DataError::Unreadable { path, reason } => write!(f, "cannot read `{}`: {reason}", path.display()),
            DataError::NoTimes => {
                f.write_str("there is no column `t`: name the column of times `t`, or `t in s` with its unit")
            }
            DataError::Cells { line, found, wanted } => {
                write!(f, "line {line} has {found} cells and the first line {wanted}")
            }
            DataError::NotANumber { line, column, text } => write!(
                f,
                "`{text}` in line {line}, column `{column}`, is not a finite number; leave cells of missing values empty"
            ),
            DataError::NotNumbers { column } => {
                write!(
                    f,
                    "column `{column}` does not consist of numbers; remove it, or convert it, times to seconds"
                )
            }
            DataError::NotANumberInRow { row, column, text } => write!(
                f,
                "`{text}` in row {row}, column `{column}`, is not a finite number; missing values are null"
            ),
            DataError::OpenQuotation { line } => write!(f, "a quotation in line {line} does not end there"),
        }
    }
}

/// Shows the message, since `main` and `unwrap` print errors by `Debug`.
impl Debug for DataError {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        write!(f, "DataError({self})")
    }
}

impl std::error::Error for DataError {}
