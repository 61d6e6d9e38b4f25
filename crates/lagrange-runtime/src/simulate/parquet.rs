//! Apache Parquet files.

use std::format;
use std::io::Write;
use std::path::Path;
use std::string::{String, ToString};
use std::sync::Arc;
use std::vec::Vec;

use parquet::basic::{Repetition, Type as Physical};
use parquet::data_type::DoubleType;
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;

use crate::simulate::csv::cannot_write;
use crate::simulate::table::{TIME, Table};
use crate::simulate::trajectory::Trajectory;
use crate::simulate::units::unit;
use crate::system::{Description, MechanicalSystem};
use lagrange_files::save;

/// Name of the schema.
const SCHEMA: &str = "trajectory";
/// Prefix of a column name in the key of its unit.
pub(crate) const UNIT_KEY: &str = "lagrange.unit.";

impl<M: MechanicalSystem> Trajectory<M>
where
    M::Scalar: Into<f64>,
{
    /// Writes all columns to a Parquet file, as [`write_parquet`](Trajectory::write_parquet) does;
    /// an existing file is replaced only when the new one is complete.
    ///
    /// # Errors
    /// If the operating system or the writer fails, with the path.
    pub fn save_parquet(&self, path: impl AsRef<Path>) -> Result<(), ParquetError> {
        let path = path.as_ref();
        save(path, |error| cannot_write(path, &error).into(), |file| self.write_parquet(file))
    }

    /// Writes all columns in Apache Parquet format: required, uncompressed columns of type
    /// `DOUBLE`, the first being the time `t`. If the [unit](Trajectory::unit) of a column is
    /// known, the file's key–value metadata have it under `lagrange.unit.` and the name of the
    /// column.
    ///
    /// # Errors
    /// If the writer fails.
    pub fn write_parquet(&self, writer: impl Write + Send) -> Result<(), ParquetError> {
        let table = self.table();
        let mut file = SerializedFileWriter::new(
            writer,
            Arc::new(schema(table)?),
            Arc::new(properties(self.description, table.names())),
        )?;
        let mut group = file.next_row_group()?;
        for column in std::iter::once(table.times()).chain(table.columns()) {
            let values: Vec<f64> = column.iter().map(|value| (*value).into()).collect();
            let Some(mut writer) = group.next_column()? else {
                return Err(ParquetError::General("fewer columns than the schema has".into()));
            };
            writer.typed::<DoubleType>().write_batch(&values, None, None)?;
            writer.close()?;
        }
        group.close()?;
        file.close().map(drop)
    }
}

/// Returns the encodings and metadata. Values of a motion hardly repeat, so a dictionary would only
/// cost time.
fn properties(system: &Description, names: &[String]) -> WriterProperties {
    let columns = std::iter::once(TIME).chain(names.iter().map(String::as_str));
    let units: Vec<_> = units(system, columns).collect();
    let builder = WriterProperties::builder().set_dictionary_enabled(false);
    builder.set_key_value_metadata((!units.is_empty()).then_some(units)).build()
}

/// Returns metadata entries with the units of these columns.
pub(crate) fn units<'n>(
    system: &Description,
    names: impl Iterator<Item = &'n str>,
) -> impl Iterator<Item = KeyValue> {
    names.filter_map(|name| Some(KeyValue::new(format!("{UNIT_KEY}{name}"), unit(system, name)?.to_string())))
}

/// Returns a schema with a column of doubles for the time and for each name.
fn schema<S: Copy>(table: &Table<S>) -> Result<Type, ParquetError> {
    let names = std::iter::once(TIME).chain(table.names().iter().map(String::as_str));
    let column = |name: &str| {
        let builder = Type::primitive_type_builder(name, Physical::DOUBLE);
        builder.with_repetition(Repetition::REQUIRED).build().map(Arc::new)
    };
    let columns = names.map(column).collect::<Result<Vec<_>, _>>()?;
    Type::group_type_builder(SCHEMA).with_fields(columns).build()
}
