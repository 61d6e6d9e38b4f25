//! One Parquet file.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;
use std::string::{String, ToString};
use std::sync::Arc;
use std::vec::Vec;
use std::{format, vec};

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{Type, TypePtr};

use crate::ensemble::ends::Rows;
use crate::simulate::Table;
use crate::system::MechanicalSystem;

/// What the schema is called.
const SCHEMA: &str = "ends";
/// Under which name the settings are kept.
const SETTINGS: &str = "lagrange.ensemble";
const INDEX: &str = "index";
const TIME: &str = "t";
const CAUSE: &str = "cause";

/// Writes the rows of motions from `first` on.
pub(super) fn write<M: MechanicalSystem>(
    file: &File,
    first: usize,
    rows: &Rows<M>,
    settings: &str,
) -> io::Result<()>
where
    M::Scalar: Into<f64>,
{
    let Some(table) = &rows.table else { return Ok(()) };
    if let Some(taken) = table.names().iter().find(|name| [INDEX, TIME, CAUSE].contains(&name.as_str())) {
        let text = format!("a column is called `{taken}`, which is the name of another column of the file");
        return Err(io::Error::new(io::ErrorKind::InvalidInput, text));
    }
    write_columns(file, first, rows, table, settings).map_err(into_io)
}

/// The settings that a file holds; `None` if it is not a part.
pub(super) fn settings(path: &Path) -> Option<String> {
    let reader = SerializedFileReader::new(File::open(path).ok()?).ok()?;
    let pairs = reader.metadata().file_metadata().key_value_metadata()?;
    pairs.iter().find(|pair| pair.key == SETTINGS)?.value.clone()
}

fn write_columns<M: MechanicalSystem>(
    file: &File,
    first: usize,
    rows: &Rows<M>,
    table: &Table<M::Scalar>,
    settings: &str,
) -> Result<(), ParquetError>
where
    M::Scalar: Into<f64>,
{
    let (schema, properties) = (Arc::new(schema(table.names())?), Arc::new(properties(settings)));
    let mut writer = SerializedFileWriter::new(BufWriter::new(file), schema, properties)?;
    let mut group = writer.next_row_group()?;
    let fewer = || ParquetError::General("fewer columns than the schema has".into());
    let indices: Vec<i64> = (first..first + table.len()).map(|index| index as i64).collect();
    let mut column = group.next_column()?.ok_or_else(fewer)?;
    column.typed::<Int64Type>().write_batch(&indices, None, None)?;
    column.close()?;
    for values in std::iter::once(table.times()).chain(table.columns()) {
        let values: Vec<f64> = values.iter().map(|value| (*value).into()).collect();
        let mut column = group.next_column()?.ok_or_else(fewer)?;
        column.typed::<DoubleType>().write_batch(&values, None, None)?;
        column.close()?;
    }
    let (causes, is_there) = causes(first, rows, table.len());
    let mut column = group.next_column()?.ok_or_else(fewer)?;
    column.typed::<ByteArrayType>().write_batch(&causes, Some(&is_there), None)?;
    column.close()?;
    group.close()?;
    let mut buffer = writer.into_inner()?;
    io::Write::flush(&mut buffer).map_err(|error| ParquetError::External(error.into()))
}

/// Why motions failed, and for each whether it did.
fn causes<M: MechanicalSystem>(first: usize, rows: &Rows<M>, number: usize) -> (Vec<ByteArray>, Vec<i16>) {
    let mut is_there = vec![0; number];
    rows.failures.iter().for_each(|failure| is_there[failure.index - first] = 1);
    let causes = rows.failures.iter().map(|failure| failure.why().to_string().into_bytes().into());
    (causes.collect(), is_there)
}

/// Numbers of a motion hardly repeat, so that a dictionary of them would only cost time.
fn properties(settings: &str) -> WriterProperties {
    let settings = KeyValue::new(SETTINGS.to_string(), settings.to_string());
    let builder = WriterProperties::builder().set_dictionary_enabled(false);
    builder.set_key_value_metadata(Some(vec![settings])).build()
}

fn schema(names: &[String]) -> Result<Type, ParquetError> {
    let required = |name: &str, physical| {
        let builder = Type::primitive_type_builder(name, physical);
        builder.with_repetition(Repetition::REQUIRED).build().map(Arc::new)
    };
    let mut columns: Vec<TypePtr> =
        vec![required(INDEX, Physical::INT64)?, required(TIME, Physical::DOUBLE)?];
    for name in names {
        columns.push(required(name, Physical::DOUBLE)?);
    }
    let cause = Type::primitive_type_builder(CAUSE, Physical::BYTE_ARRAY)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(Some(LogicalType::String));
    columns.push(Arc::new(cause.build()?));
    Type::group_type_builder(SCHEMA).with_fields(columns).build()
}

/// What the operating system said, where it did.
fn into_io(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(source) => match source.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}
