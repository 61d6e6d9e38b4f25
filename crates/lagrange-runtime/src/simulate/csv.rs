//! Comma-separated values.

use std::borrow::Cow;
use std::fmt::Debug;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::simulate::table::{TIME, Table};
use crate::simulate::trajectory::Trajectory;
use crate::simulate::units::labelled;
use crate::system::MechanicalSystem;
use lagrange_files::{csv_cell, save};

impl<M: MechanicalSystem> Trajectory<M> {
    /// Writes all columns to a file, as [`write_csv`](Trajectory::write_csv) does; an existing file
    /// is replaced only when the new one is complete.
    ///
    /// # Errors
    /// If the operating system cannot write the file, with its path.
    pub fn save_csv(&self, path: impl AsRef<Path>) -> io::Result<()> {
        let path = path.as_ref();
        save(
            path,
            |error| cannot_write(path, &error),
            |file| self.write_csv(file).map_err(|error| cannot_write(path, &error)),
        )
    }

    /// Writes all columns as comma-separated values: a line of names, the first being `t`, then a
    /// line for each sample. Known [units](Trajectory::unit) are appended to names, as in `t in s,x
    /// in m`. Names that begin with `=`, `+`, `-`, `@` or a control character get a leading
    /// apostrophe, so that spreadsheets treat them as text, not formulas.
    ///
    /// Every `f64` or `f32` is written with enough digits to read back the same bits, and other
    /// numbers in their `Debug` form.
    ///
    /// # Errors
    /// If the writer fails.
    pub fn write_csv(&self, writer: impl Write) -> io::Result<()> {
        self.table().write_csv(writer, |name| labelled(self.description, name))
    }
}

impl<S: Copy + Debug> Table<S> {
    fn write_csv(&self, writer: impl Write, label: impl Fn(&str) -> Cow<'_, str>) -> io::Result<()> {
        let mut writer = BufWriter::new(writer);
        write!(writer, "{}", label(TIME))?;
        for name in self.names() {
            write!(writer, ",{}", csv_cell(&label(name)))?;
        }
        writeln!(writer)?;
        for (row, time) in self.times().iter().enumerate() {
            write!(writer, "{time:?}")?;
            for column in self.columns() {
                write!(writer, ",{:?}", column[row])?;
            }
            writeln!(writer)?;
        }
        writer.flush()
    }
}

/// Adds the path to an error.
pub(super) fn cannot_write(path: &Path, error: &io::Error) -> io::Error {
    io::Error::new(error.kind(), std::format!("cannot write `{}`: {error}", path.display()))
}
