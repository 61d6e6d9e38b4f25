//! Files of data.

use lagrange::fit::{Data, DataError};

#[test]
fn a_missing_file_is_named() {
    let error = Data::read_csv("/nowhere/swing.csv").unwrap_err();
    assert!(matches!(error, DataError::Unreadable { .. }));
    assert!(error.to_string().starts_with("cannot read `/nowhere/swing.csv`: "), "{error}");
}

#[test]
fn mistakes_name_line_and_column() {
    let text = |data: &str| Data::parse_csv(data).unwrap_err().to_string();
    assert_eq!(
        text("t,x\n0,1\n0.1,1..2\n"),
        "`1..2` in line 3, column `x`, is not a finite number; leave cells of missing values empty"
    );
    assert_eq!(text("t,x\n0\n"), "line 2 has 1 cells and the first line 2");
    assert_eq!(
        text("time,x\n0,1\n"),
        "there is no column `t`: name the column of times `t`, or `t in s` with its unit"
    );
    // As `main` and `unwrap` print it.
    let error = Data::parse_csv("t,x\n0\n").unwrap_err();
    assert_eq!(format!("{error:?}"), "DataError(line 2 has 1 cells and the first line 2)");
}

#[test]
fn columns_are_chosen_by_name() {
    let data = Data::parse_csv("t in s,x in m,y\n0,1,\n1,2,3\n").unwrap();
    assert_eq!(data.times(), [0.0, 1.0]);
    assert_eq!(data.column("y"), Some(&[None, Some(3.0)][..]));
    let x = data.only(["x", "z"]);
    assert_eq!((x.column("y"), x.column("x")), (None, Some(&[Some(1.0), Some(2.0)][..])));
}

#[cfg(feature = "parquet")]
fn parquet(name: &str) -> Result<Data, DataError> {
    Data::read_parquet(format!("{}/fit/files/{name}.parquet", env!("CARGO_MANIFEST_DIR")))
}

#[cfg(feature = "parquet")]
#[test]
fn data_frames_are_read() {
    let data = parquet("pandas").unwrap();
    assert_eq!(data.times(), [0.0, 0.5, 1.0]);
    assert_eq!(data.names().collect::<Vec<_>>(), ["x", "count", "single"]);
    assert_eq!(data.column("x"), Some(&[Some(1.0), None, Some(-2.5)][..]));
    assert_eq!(data.column("count"), Some(&[Some(1.0), None, Some(3.0)][..]));
    assert_eq!(data.column("single"), Some(&[Some(0.5), Some(0.25), Some(0.125)][..]));
    let index = parquet("index").unwrap();
    assert_eq!((index.times(), index.column("x")), (data.times(), data.column("x")));
}

#[cfg(feature = "parquet")]
#[test]
fn files_that_are_not_measured_data_say_why() {
    let text = |name: &str| parquet(name).unwrap_err().to_string();
    assert!(text("nowhere").starts_with("cannot read `"), "{}", text("nowhere"));
    assert!(text("zstd").ends_with("; write the file with compression `snappy` or none"), "{}", text("zstd"));
    let not_numbers = "does not consist of numbers; remove it, or convert it, times to seconds";
    assert_eq!(text("words"), format!("column `name` {not_numbers}"));
    assert_eq!(text("dates"), format!("column `t` {not_numbers}"));
    assert_eq!(
        text("no_time"),
        "`null` in row 2, column `t`, is not a finite number; missing values are null"
    );
    assert_eq!(
        text("not_a_number"),
        "`NaN` in row 2, column `x`, is not a finite number; missing values are null"
    );
    let own = format!("{}/fit/data.rs", env!("CARGO_MANIFEST_DIR"));
    let error = Data::read_parquet(own).unwrap_err().to_string();
    assert!(error.contains("fit/data.rs`: "), "{error}");
}

/// Numbers and units survive a trip through a file, so that a fit to it has the residuals of
/// rounding.
#[cfg(feature = "parquet")]
#[test]
fn saved_motions_are_data() {
    use lagrange::Simulate;
    use lagrange::fit::Fits;

    let body = Body { speed: 2.5 };
    let run = body.simulate([0.5]).until(3.0).every(0.5).run().unwrap();
    let path = std::env::temp_dir().join(format!("lagrange_fit_{}.parquet", std::process::id()));
    run.save_parquet(&path).unwrap();
    let data = Data::read_parquet(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert_eq!(data.times(), run.times());
    let x = data.column("x").unwrap().iter().flatten().copied().collect::<Vec<_>>();
    assert_eq!(x, run.column("x").unwrap());
    let again = data.clone();
    let fitted = Body::default().fit([0.5], data).vary("speed", 0.0..=9.0).run().unwrap();
    assert!((fitted.value("speed").unwrap() - 2.5).abs() < 1e-12);
    // Another system has `x` in another unit.
    let wrong = Clock::default().fit([0.5], again).vary("speed", 0.0..=9.0).run().unwrap_err();
    assert!(wrong.to_string().contains("column `x` of the data is in m"), "{wrong}");
}

#[cfg(feature = "parquet")]
lagrange::system! {
    /// A hand that moves uniformly.
    #[derive(Clone)]
    struct Clock;
    param speed: rad/s = 1;
    state x: rad;
    dot(x) = speed;
}

lagrange::system! {
    /// A body that moves uniformly.
    #[derive(Clone)]
    struct Body;
    param speed: m/s = 1;
    state x: m;
    dot(x) = speed;
}

#[cfg(feature = "plot")]
#[test]
fn fits_are_plotted_beside_their_data() {
    use lagrange::fit::Fits;
    use lagrange::simulate::PlotError;

    let body = Body::default();
    let data = Data::parse_csv("t in s,x in m\n0,0\n1,2\n2,\n3,6\n").unwrap();
    let fitted = body.fit([0.0], data).vary("speed", 0.0..=9.0).run().unwrap();
    let path = std::env::temp_dir().join(format!("lagrange_fit_{}.svg", std::process::id()));
    fitted.plot("x", &path).unwrap();
    let picture = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    assert!(["measured", "fitted"].iter().all(|text| picture.contains(text)), "{picture}");
    let error = fitted.plot("y", &path).unwrap_err();
    assert!(matches!(error, PlotError::UnknownColumn { known, .. } if known == ["x"]));
}
