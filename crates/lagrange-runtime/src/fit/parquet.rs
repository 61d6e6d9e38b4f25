//! Apache Parquet files in the format of saved trajectories, or of data frames.

use std::borrow::ToOwned;
use std::fs::File;
use std::path::Path;
use std::string::{String, ToString};
use std::vec::Vec;

use parquet::basic::{ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use parquet::schema::types::Type;

use super::data::{Data, DataError, Measured};
use crate::simulate::{TIME, UNIT_KEY};

impl Data {
    /// Reads an Apache Parquet file as
    /// [`write_parquet`](crate::simulate::Trajectory::write_parquet) or a data frame writes it:
    /// columns of numbers, among them `t`. Units come from the metadata of saved trajectories. A
    /// name may also end in its unit, as in `x in m`. Missing values are null.
    ///
    /// Pages may be uncompressed, or compressed by Snappy. Dates, times of day and texts are
    /// errors. Durations of data frames are stored as integers: convert them to seconds before.
    ///
    /// # Errors
    /// If the file cannot be read, or has another format; with the row and the column.
    pub fn read_parquet(path: impl AsRef<Path>) -> Result<Data, DataError> {
        let path = path.as_ref();
        let unreadable = |reason: String| DataError::Unreadable { path: path.to_owned(), reason };
        let file = File::open(path).map_err(|error| unreadable(error.to_string()))?;
        let reader = SerializedFileReader::new(file).map_err(|error| unreadable(error.to_string()))?;
        let mut columns = columns(&reader)?;
        let rows = reader.get_row_iter(None).map_err(|error| unreadable(explained(&error)))?;
        for (index, row) in rows.enumerate() {
            let row = row.map_err(|error| unreadable(explained(&error)))?;
            for (column, (_, field)) in columns.iter_mut().zip(row.get_column_iter()) {
                let value = number(field).map_err(|text| DataError::NotANumberInRow {
                    row: index + 1,
                    column: column.name.clone(),
                    text,
                })?;
                column.values.push(value);
            }
        }
        Data::of_columns(columns, |row| DataError::NotANumberInRow {
            row: row + 1,
            column: TIME.into(),
            text: "null".into(),
        })
    }
}

/// Returns the columns of a file without their values.
///
/// # Errors
/// If a column does not consist of numbers. Times of day and dates would be read as numbers of
/// nanoseconds.
fn columns(reader: &SerializedFileReader<File>) -> Result<Vec<Measured>, DataError> {
    let metadata = reader.metadata().file_metadata();
    let pairs = metadata.key_value_metadata().map_or(&[][..], Vec::as_slice);
    let unit = |name: &str| {
        let mut pairs = pairs.iter().filter(|pair| pair.key.strip_prefix(UNIT_KEY) == Some(name));
        pairs.next()?.value.clone()
    };
    let fields = metadata.schema().get_fields().iter();
    let columns = fields.map(|field| {
        let column = Measured::named(field.name());
        match is_number(field) {
            true => Ok(Measured { unit: unit(field.name()).or(column.unit), ..column }),
            false => Err(DataError::NotNumbers { column: column.name }),
        }
    });
    columns.collect()
}

/// True for a column of numbers.
fn is_number(field: &Type) -> bool {
    if !field.is_primitive() || field.get_basic_info().repetition() == Repetition::REPEATED {
        return false;
    }
    let info = field.get_basic_info();
    match (field.get_physical_type(), info.logical_type_ref()) {
        (Physical::FLOAT | Physical::DOUBLE, None) => true,
        (Physical::INT32 | Physical::INT64, Some(LogicalType::Integer(_))) => true,
        (Physical::INT32 | Physical::INT64, None) => info.converted_type() == ConvertedType::NONE,
        (Physical::FIXED_LEN_BYTE_ARRAY, Some(LogicalType::Float16)) => true,
        _ => false,
    }
}

/// Returns the number in a field, if it is not null.
///
/// # Errors
/// The text of a field that is not a finite number.
fn number(field: &Field) -> Result<Option<f64>, String> {
    let value = match *field {
        Field::Null => return Ok(None),
        Field::Byte(value) => value.into(),
        Field::Short(value) => value.into(),
        Field::Int(value) => value.into(),
        Field::Long(value) => value as f64,
        Field::UByte(value) => value.into(),
        Field::UShort(value) => value.into(),
        Field::UInt(value) => value.into(),
        Field::ULong(value) => value as f64,
        Field::Float16(value) => value.into(),
        Field::Float(value) => value.into(),
        Field::Double(value) => value,
        ref other => return Err(other.to_string()),
    };
    if value.is_finite() { Ok(Some(value)) } else { Err(value.to_string()) }
}

/// Returns the message of an error, with advice for pages that are compressed otherwise.
fn explained(error: &ParquetError) -> String {
    let message = error.to_string();
    let is_compression =
        message.to_lowercase().contains("compression") || message.contains("Disabled feature");
    let advice = if is_compression { "; write the file with compression `snappy` or none" } else { "" };
    message + advice
}
