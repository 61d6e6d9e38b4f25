//! Saved files can be read back.

use std::fs::{self, File};
use std::path::PathBuf;
use std::string::{String, ToString};
use std::vec::Vec;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Row, RowAccessor};

use crate::ensemble::tests::Pendulum;
use crate::ensemble::{Ensemble, Ensembles, Random};
use crate::integrate::{RungeKutta4, Verner98};

/// Returns the folder of a test.
fn folder(name: &str) -> PathBuf {
    std::env::temp_dir().join(std::format!("lagrange_{name}_{}", std::process::id()))
}

/// Returns motions of which the third fails midway, and the eighth at its start.
fn ensemble(pendulum: &Pendulum) -> Ensemble<'_, Pendulum, Verner98<f64>> {
    let start = |i: usize, _: &mut Random| match i {
        2 => [99.5, 1.0],
        7 => [f64::NAN, 0.5],
        _ => [i as f64, 0.5],
    };
    let motions = pendulum.ensemble(10).start(start).parameters(|i, pendulum| pendulum.g = 1.0 + i as f64);
    motions.until(2.0).motions_per_part(4).observe("twice", |_, t, _| 2.0 * t)
}

/// Returns the columns, the numbers of row groups and all rows of the parts in a folder.
fn rows(folder: &PathBuf, parts: usize) -> (Vec<String>, Vec<usize>, Vec<Row>) {
    let (mut names, mut groups, mut rows) = (Vec::new(), Vec::new(), Vec::new());
    for part in 0..parts {
        let file = File::open(folder.join(std::format!("part-{part:06}.parquet"))).expect("is there");
        let reader = SerializedFileReader::new(file).expect("is Parquet");
        let fields = reader.metadata().file_metadata().schema().get_fields().iter();
        names = fields.map(|field| field.name().to_string()).collect();
        groups.push(reader.num_row_groups());
        rows.extend(reader.get_row_iter(None).expect("rows").map(|row| row.expect("a row")));
    }
    fs::remove_dir_all(folder).expect("was there");
    (names, groups, rows)
}

#[test]
fn columns_have_their_units_among_the_metadata() {
    let (folder, pendulum) = (folder("units"), Pendulum { g: 1.0 });
    ensemble(&pendulum).save_parquet(&folder).expect("saves");
    let file = File::open(folder.join("part-000000.parquet")).expect("is there");
    fs::remove_dir_all(folder).expect("was there");
    let reader = SerializedFileReader::new(file).expect("is Parquet");
    let pairs = reader.metadata().file_metadata().key_value_metadata().expect("has some");
    let units = pairs
        .iter()
        .filter_map(|pair| Some((pair.key.strip_prefix("lagrange.unit.")?, pair.value.as_deref()?)));
    assert_eq!(units.collect::<Vec<_>>(), [("g", "1/s^2"), ("t", "s"), ("x", "rad")]);
}

/// Returns the index of a row, the bits of its numbers, and its cause.
fn content(row: &Row, names: &[String]) -> (i64, Vec<u64>, Option<String>) {
    let cause = names.len() - 1;
    let bits = (1..cause).map(|place| row.get_double(place).expect("a double").to_bits());
    (row.get_long(0).expect("a number"), bits.collect(), row.get_string(cause).ok().cloned())
}

#[test]
fn ends_read_back_to_the_bit() {
    let (folder, pendulum) = (folder("ends"), Pendulum { g: 1.0 });
    let ends = ensemble(&pendulum).run().expect("runs");
    assert_eq!(ends.names(), ["x", "x_dot", "twice", "g"]);
    let saved = ensemble(&pendulum).save_parquet(&folder).expect("saves");
    assert_eq!((saved.written, saved.failed), (3, 2));
    let (names, groups, rows) = rows(&folder, 3);
    assert_eq!(names, ["index", "g", "t", "x", "x_dot", "twice", "cause"]);
    assert_eq!((groups, rows.len()), (Vec::from([1, 1, 1]), 10));
    for (index, row) in rows.iter().enumerate() {
        let columns = ["g", "x", "x_dot", "twice"].map(|name| ends.column(name).expect("known"));
        let mut expected: Vec<_> = columns.iter().map(|column| column[index].to_bits()).collect();
        expected.insert(1, ends.times()[index].to_bits());
        assert_eq!(f64::from_bits(expected[0]), 1.0 + index as f64);
        let failure = ends.failures().iter().find(|failure| failure.index == index);
        let cause = failure.map(|failure| failure.why().to_string());
        assert_eq!(cause.is_some(), [2, 7].contains(&index));
        assert_eq!(content(row, &names), (index as i64, expected, cause));
    }
}

#[test]
fn samples_read_back_to_the_bit() {
    let (folder, pendulum) = (folder("samples"), Pendulum { g: 1.0 });
    let samples = ensemble(&pendulum).every(0.25).run().expect("runs");
    let saved = ensemble(&pendulum).every(0.25).save_parquet(&folder).expect("saves");
    assert_eq!((saved.written, saved.failed), (3, 2));
    let (names, _, rows) = rows(&folder, 3);
    assert_eq!(names, ["index", "g", "t", "x", "x_dot", "twice", "cause"]);
    let mut rows = rows.iter();
    for index in samples.motions() {
        let ran = samples.motion(index).expect("is there");
        let trajectory = ran.unwrap_or_else(|error| &error.trajectory);
        assert_eq!(trajectory.len(), [9, 3, 1][usize::from(index == 2) + 2 * usize::from(index == 7)]);
        for sample in 0..trajectory.len() {
            let row = content(rows.next().expect("a row"), &names);
            let columns = [trajectory.times()].into_iter().chain(trajectory.table().columns());
            let numbers = [1.0 + index as f64].into_iter().chain(columns.map(|column| column[sample]));
            let is_last = sample + 1 == trajectory.len();
            let cause = ran.err().filter(|_| is_last).map(ToString::to_string);
            assert_eq!(row, (index as i64, numbers.map(f64::to_bits).collect(), cause));
        }
    }
    assert!(rows.next().is_none());
}

#[test]
fn samples_beyond_a_row_group_begin_another() {
    let (folder, pendulum) = (folder("groups"), Pendulum { g: 1.0 });
    let ensemble = pendulum.ensemble(66).start(|_, _| [1.0, 0.0]).until(1.0).threads(2);
    let ensemble = ensemble.method(RungeKutta4 { step: 0.5 }).every(1.0 / 2048.0);
    ensemble.save_parquet(&folder).expect("saves");
    // 64 motions of 2049 samples fill a group.
    let (names, groups, rows) = rows(&folder, 1);
    assert_eq!(names, ["index", "t", "x", "x_dot", "cause"]);
    assert_eq!((groups, rows.len()), (Vec::from([2]), 66 * 2049));
    assert!(rows.iter().zip((0..66).flat_map(|i| [i; 2049])).all(|(row, i)| row.get_long(0).ok() == Some(i)));
}

/// Nothing is computed: available memory is checked first.
#[test]
fn samples_that_cannot_lie_in_memory_together_are_refused() {
    let pendulum = Pendulum { g: 1.0 };
    let ensemble = pendulum.ensemble(1).start(|_, _| [1.0, 0.0]).until(1e6).every(0.125);
    assert!(ensemble.batch.refuse_too_many_at_once(1).is_ok());
    let error = ensemble.batch.refuse_too_many_at_once(1 << 40).expect_err("has no room").to_string();
    let words = ["the samples of 1099511627776 motions need", "specify a longer interval"];
    assert!(words.iter().all(|words| error.contains(words)), "{error}");
}
