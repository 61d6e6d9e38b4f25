//! What is written reads back.

use std::string::{String, ToString};
use std::vec::Vec;

use super::{Oscillator, START};
use crate::simulate::{Simulate, Trajectory};

/// A run with columns of very small, very large and no numbers.
fn run() -> Trajectory<Oscillator> {
    let simulation = Oscillator.simulate(START).from(-0.1).until(5.0).every(0.1).energy();
    simulation
        .observe("small", |_, t, _| 1e-300 * t)
        .observe("large", |_, t, _| 1e300 * t)
        .observe("odd, \"really\"", |_, t, _| if t < 0.0 { f64::NEG_INFINITY } else { f64::NAN })
        .run()
        .expect("runs")
}

#[test]
fn csv_reads_back_to_the_bit() {
    let trajectory = run();
    let mut bytes = Vec::new();
    trajectory.write_csv(&mut bytes).expect("memory takes everything");
    let text = String::from_utf8(bytes).expect("text");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("t,x,x_dot,energy,small,large,\"odd, \"\"really\"\"\""));
    let rows: Vec<Vec<f64>> =
        lines.map(|line| line.split(',').map(|number| number.parse().expect("a number")).collect()).collect();
    assert_eq!(rows.len(), trajectory.len());
    let columns = || std::iter::once(trajectory.times()).chain(trajectory.table().columns());
    for (index, row) in rows.iter().enumerate() {
        assert!(columns().map(|column| column[index].to_bits()).eq(row.iter().map(|value| value.to_bits())));
    }
}

#[cfg(feature = "parquet")]
#[test]
fn parquet_reads_back_to_the_bit() {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::RowAccessor;

    let trajectory = run();
    let path = std::env::temp_dir().join(std::format!("lagrange_{}.parquet", std::process::id()));
    trajectory.save_parquet(&path).expect("writes");
    let file = SerializedFileReader::new(std::fs::File::open(&path).expect("is there")).expect("is Parquet");
    let fields = file.metadata().file_metadata().schema().get_fields().iter();
    let names: Vec<_> = fields.map(|field| String::from(field.name())).collect();
    assert_eq!(names[0], "t");
    assert_eq!(names[1..], *trajectory.names());
    let columns: Vec<_> = std::iter::once(trajectory.times()).chain(trajectory.table().columns()).collect();
    let mut rows = 0;
    for (index, row) in file.get_row_iter(None).expect("rows").enumerate() {
        let row = row.expect("a row");
        for (place, column) in columns.iter().enumerate() {
            assert_eq!(row.get_double(place).expect("a double").to_bits(), column[index].to_bits());
        }
        rows += 1;
    }
    assert_eq!(rows, trajectory.len());
    std::fs::remove_file(path).expect("was there");
}

#[test]
fn a_file_that_cannot_be_written_is_an_error() {
    let error = run().save_csv("/no/such/folder/run.csv").expect_err("no folder");
    assert!(error.to_string().starts_with("cannot write `/no/such/folder/run.csv`: "), "{error}");
    #[cfg(feature = "parquet")]
    {
        let error = run().save_parquet("/no/such/folder/run.parquet").expect_err("no folder");
        assert!(error.to_string().contains("cannot write `/no/such/folder/run.parquet`: "), "{error}");
    }
}
