//! Written files can be read back.

use std::string::{String, ToString};
use std::vec::Vec;

use super::{Oscillator, START};
use crate::simulate::{Simulate, Trajectory};

/// Returns a run with columns of very small numbers, very large numbers and NaN.
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

#[test]
fn names_in_csv_are_no_formulas() {
    let names = ["=1+1", "+x", "-x", "@SUM(a, b)", "\tx", "\r=x", "'x", "x=1"];
    let simulation = Oscillator.simulate(START).until(1.0).ends_only();
    let simulation = names.iter().fold(simulation, |run, name| run.observe(name, |_, t, _| t));
    let mut bytes = Vec::new();
    simulation.run().expect("runs").write_csv(&mut bytes).expect("memory takes everything");
    let expected = "t,x,x_dot,'=1+1,'+x,'-x,\"'@SUM(a, b)\",'\tx,\"'\r=x\",'x,x=1\n";
    assert!(String::from_utf8(bytes).expect("text").starts_with(expected));
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

#[cfg(unix)]
const CHILD: &str = "LAGRANGE_TEST_FOLDER";

/// Limits files to a kilobyte, as on a full disk.
#[cfg(unix)]
#[test]
fn older_files_survive_a_full_disk() {
    use std::process::{Command, Stdio};
    use std::{env, fs};

    if let Some(folder) = env::var_os(CHILD) {
        save_everything(folder.as_ref(), true);
        return;
    }
    let folder = env::temp_dir().join(std::format!("lagrange_full_{}", std::process::id()));
    fs::create_dir_all(&folder).expect("can be made");
    let files = || {
        let entries = fs::read_dir(&folder).expect("is there").map(|entry| entry.expect("is there").path());
        let mut files: Vec<_> = entries.map(|path| (fs::read(&path).expect("can be read"), path)).collect();
        files.sort();
        files
    };
    save_everything(&folder, false);
    let before = files();
    assert!(!before.is_empty() && before.iter().all(|(bytes, _)| bytes.len() > 1024));
    let mut shell = Command::new("sh");
    shell.args(["-c", "trap '' XFSZ; ulimit -f 2; exec \"$@\"", "sh"]);
    shell.arg(env::current_exe().expect("is known"));
    shell.args(["--exact", "simulate::tests::files::older_files_survive_a_full_disk"]);
    // Its output might go to a file that is limited, too.
    shell.stdout(Stdio::null()).stderr(Stdio::null()).env(CHILD, &folder);
    assert!(shell.status().expect("starts").success());
    let after = files();
    fs::remove_dir_all(&folder).expect("is there");
    assert!(after == before);
}

/// Saves a run in every format.
#[cfg(unix)]
fn save_everything(folder: &std::path::Path, is_full: bool) {
    let trajectory = run();
    let mut saved = Vec::from([trajectory.save_csv(folder.join("run.csv")).is_ok()]);
    #[cfg(feature = "parquet")]
    saved.push(trajectory.save_parquet(folder.join("run.parquet")).is_ok());
    #[cfg(feature = "plot")]
    for extension in ["svg", "png"] {
        saved.push(trajectory.plot_states(folder.join("run").with_extension(extension)).is_ok());
    }
    assert!(saved.iter().all(|is_saved| *is_saved != is_full), "{saved:?}");
}
