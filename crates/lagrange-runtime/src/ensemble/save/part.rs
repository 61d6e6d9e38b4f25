//! One Parquet file.

use std::format;
use std::fs::File;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::Path;
use std::string::{String, ToString};
use std::sync::Arc;
use std::vec;
use std::vec::Vec;

use parquet::basic::{Encoding, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::{WriterProperties, WriterPropertiesBuilder};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{ColumnPath, Type, TypePtr};

use super::seal::{KEY, UNSEALED, is_intact, seal};
use super::sheet::Sheet;
use crate::ensemble::error::EnsembleError;
use crate::ensemble::plan::SharedSystem;
use crate::simulate::units;
use crate::system::description_of_type;

/// Name of the schema.
const SCHEMA: &str = "motions";
/// Metadata key of the settings.
const SETTINGS: &str = "lagrange.ensemble";
/// Metadata key of the index of the part and the number of parts.
const PART: &str = "lagrange.part";
const INDEX: &str = "index";
const TIME: &str = "t";
const CAUSE: &str = "cause";
/// Number of pending rows at which a row group is written: a megabyte per column.
const ROWS_PER_GROUP: usize = 1 << 17;

/// The metadata of a part.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Label {
    /// Identity of its ensemble.
    pub(super) settings: String,
    /// Index of the part.
    pub(super) part: usize,
    /// Number of parts.
    pub(super) number: usize,
}

impl Label {
    /// Reads the label of a file after checking all of its bytes.
    ///
    /// # Errors
    /// If it is not a part, is damaged or cannot be read.
    pub(super) fn read(path: &Path) -> Result<Label, EnsembleError> {
        let wrong = |source| EnsembleError::File { path: path.into(), source };
        let file = File::open(path).map_err(wrong)?;
        match is_intact(&file).map_err(wrong)? {
            Some(true) => Label::of(file).ok_or_else(|| EnsembleError::ForeignFile(path.into())),
            Some(false) => {
                let why = "its content has changed since it was written".into();
                Err(EnsembleError::Damaged { path: path.into(), why })
            }
            None => Err(EnsembleError::ForeignFile(path.into())),
        }
    }

    fn of(file: File) -> Option<Label> {
        let reader = SerializedFileReader::new(file).ok()?;
        let pairs = reader.metadata().file_metadata().key_value_metadata()?;
        let value = |key: &str| pairs.iter().find(|pair| pair.key == key)?.value.clone();
        let place = value(PART)?;
        let (part, number) = place.split_once(" of ")?;
        Some(Label { settings: value(SETTINGS)?, part: part.parse().ok()?, number: number.parse().ok()? })
    }

    /// Returns the metadata entries, with a place for the checksum.
    fn pairs(&self) -> [KeyValue; 3] {
        let place = format!("{} of {}", self.part, self.number);
        [(SETTINGS, self.settings.as_str()), (PART, &place), (KEY, UNSEALED)]
            .map(|(key, value)| KeyValue::new(key.to_string(), value.to_string()))
    }
}

/// A file to which rows are appended. Only one row group is held in memory.
pub(super) struct PartFile<'f, M: SharedSystem> {
    file: &'f File,
    label: &'f Label,
    /// `None` before the first row group.
    writer: Option<SerializedFileWriter<BufWriter<&'f File>>>,
    waiting: Sheet<M>,
    failed: usize,
}

impl<'f, M: SharedSystem> PartFile<'f, M>
where
    M::Scalar: Into<f64>,
{
    pub(super) fn new(file: &'f File, label: &'f Label) -> Self {
        PartFile { file, label, writer: None, waiting: Sheet::new(), failed: 0 }
    }

    /// Appends the rows of the motions that follow.
    pub(super) fn add(&mut self, sheet: Sheet<M>) -> io::Result<()> {
        self.waiting.merge(sheet);
        if self.waiting.len() >= ROWS_PER_GROUP { self.write_group() } else { Ok(()) }
    }

    /// Writes the pending rows, the end of the file and its checksum. Returns the number of failed
    /// motions.
    pub(super) fn finish(mut self) -> io::Result<usize> {
        if self.waiting.len() > 0 {
            self.write_group()?;
        }
        if let Some(writer) = self.writer {
            writer.into_inner().map_err(into_io)?.flush()?;
            seal(self.file)?;
        }
        Ok(self.failed)
    }

    fn write_group(&mut self) -> io::Result<()> {
        let sheet = core::mem::replace(&mut self.waiting, Sheet::new());
        self.failed += sheet.failed();
        let writer = match &mut self.writer {
            Some(writer) => writer,
            none => none.insert(writer(self.file, &sheet, self.label)?),
        };
        write_group(writer, &sheet).map_err(into_io)
    }
}

/// Creates the writer of a file with the columns of these rows.
fn writer<'f, M: SharedSystem>(
    file: &'f File,
    sheet: &Sheet<M>,
    label: &Label,
) -> io::Result<SerializedFileWriter<BufWriter<&'f File>>> {
    let columns = sheet.columns(TIME);
    let names: Vec<_> = columns.iter().map(|(name, _)| *name).collect();
    let others = || names.iter().enumerate().filter(|(place, _)| *place != sheet.parameters());
    if let Some((_, taken)) = others().find(|(_, name)| [INDEX, TIME, CAUSE].contains(name)) {
        let text = format!("a column is called `{taken}`, which is the name of another column of the file");
        return Err(io::Error::new(ErrorKind::InvalidInput, text));
    }
    let schema = schema(&names).map_err(into_io)?;
    let properties = properties::<M>(&names, sheet.parameters(), label);
    SerializedFileWriter::new(BufWriter::new(file), Arc::new(schema), Arc::new(properties)).map_err(into_io)
}

fn write_group<M: SharedSystem>(
    writer: &mut SerializedFileWriter<BufWriter<&File>>,
    sheet: &Sheet<M>,
) -> Result<(), ParquetError>
where
    M::Scalar: Into<f64>,
{
    let mut group = writer.next_row_group()?;
    write_column::<Int64Type>(&mut group, &sheet.motions, None)?;
    for (_, values) in sheet.columns(TIME) {
        let values: Vec<f64> = values.iter().map(|value| (*value).into()).collect();
        write_column::<DoubleType>(&mut group, &values, None)?;
    }
    let (causes, is_there) = sheet.causes();
    let causes: Vec<ByteArray> = causes.into_iter().map(|cause| cause.into_bytes().into()).collect();
    let is_there: Vec<i16> = is_there.into_iter().map(i16::from).collect();
    write_column::<ByteArrayType>(&mut group, &causes, Some(&is_there))?;
    group.close().map(drop)
}

/// Writes the next column: its values, and for each row 1 or 0 for present or absent.
fn write_column<T: DataType>(
    group: &mut SerializedRowGroupWriter<'_, BufWriter<&File>>,
    values: &[T::T],
    is_there: Option<&[i16]>,
) -> Result<(), ParquetError> {
    let fewer = || ParquetError::General("fewer columns than the schema has".into());
    let mut column = group.next_column()?.ok_or_else(fewer)?;
    column.typed::<T>().write_batch(values, is_there, None)?;
    column.close()
}

/// Returns the encodings and metadata. Values of a motion hardly repeat, so a dictionary would only
/// cost time. Parameters, the first columns, and times, the next one, do repeat. An index equals
/// the one before it or is one more.
fn properties<M: SharedSystem>(names: &[&str], parameters: usize, label: &Label) -> WriterProperties {
    let system = description_of_type::<M>();
    let metadata = label.pairs().into_iter().chain(units(system, names.iter().copied()));
    let builder = WriterProperties::builder()
        .set_dictionary_enabled(false)
        .set_column_encoding(path(INDEX), Encoding::DELTA_BINARY_PACKED)
        .set_key_value_metadata(Some(metadata.collect()));
    let repeat = |builder: WriterPropertiesBuilder, name: &&str| {
        builder.set_column_dictionary_enabled(path(name), true)
    };
    names.iter().take(parameters + 1).fold(builder, repeat).build()
}

/// Returns the path of a column whose name may contain dots.
fn path(name: &str) -> ColumnPath {
    ColumnPath::new(vec![name.to_string()])
}

fn schema(names: &[&str]) -> Result<Type, ParquetError> {
    let required = |name: &str, physical| {
        let builder = Type::primitive_type_builder(name, physical);
        builder.with_repetition(Repetition::REQUIRED).build().map(Arc::new)
    };
    let mut columns: Vec<TypePtr> = vec![required(INDEX, Physical::INT64)?];
    for name in names {
        columns.push(required(name, Physical::DOUBLE)?);
    }
    let cause = Type::primitive_type_builder(CAUSE, Physical::BYTE_ARRAY)
        .with_repetition(Repetition::OPTIONAL)
        .with_logical_type(Some(LogicalType::String));
    columns.push(Arc::new(cause.build()?));
    Type::group_type_builder(SCHEMA).with_fields(columns).build()
}

/// Returns the error of the operating system, if there is one.
fn into_io(error: ParquetError) -> io::Error {
    match error {
        ParquetError::External(source) => match source.downcast::<io::Error>() {
            Ok(error) => *error,
            Err(other) => io::Error::other(other),
        },
        other => io::Error::other(other),
    }
}
