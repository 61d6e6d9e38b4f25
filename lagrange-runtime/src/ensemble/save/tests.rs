//! What is saved reads back.

use std::fs::{self, File};
use std::string::String;
use std::vec::Vec;

use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;

use crate::ensemble::Ensembles;
use crate::ensemble::tests::Pendulum;

#[test]
fn rows_read_back_to_the_bit() {
    let folder = std::env::temp_dir().join(std::format!("lagrange_ends_{}", std::process::id()));
    let ensemble = || {
        let ensemble = Pendulum.ensemble(10).start(|i, _| [if i == 7 { f64::NAN } else { i as f64 }, 0.5]);
        ensemble.until(2.0).motions_per_part(4).observe("twice", |_, t, _| 2.0 * t)
    };
    let ends = ensemble().run().expect("runs");
    assert_eq!(ensemble().save_parquet(&folder).expect("saves").written, 3);
    let mut index = 0;
    for part in 0..3 {
        let file = File::open(folder.join(std::format!("part-00000{part}.parquet"))).expect("is there");
        let reader = SerializedFileReader::new(file).expect("is Parquet");
        let fields = reader.metadata().file_metadata().schema().get_fields().iter();
        let names: Vec<_> = fields.map(|field| String::from(field.name())).collect();
        assert_eq!(names, ["index", "t", "x", "x_dot", "twice", "cause"]);
        for row in reader.get_row_iter(None).expect("rows") {
            let row = row.expect("a row");
            assert_eq!(row.get_long(0).expect("a number"), index as i64);
            let columns = [ends.times()].into_iter().chain(ends.table().columns());
            for (place, column) in columns.enumerate() {
                assert_eq!(row.get_double(place + 1).expect("a double").to_bits(), column[index].to_bits());
            }
            let cause = row.get_string(5).ok().cloned();
            let expected = (index == 7).then(|| String::from("`x` of the state is NaN (at time 0.0)"));
            assert_eq!(cause, expected);
            index += 1;
        }
    }
    assert_eq!(index, 10);
    fs::remove_dir_all(folder).expect("was there");
}
