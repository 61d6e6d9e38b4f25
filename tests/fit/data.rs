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
        "there is no column `t`: the first line must name one, as in `t in s,x in m`"
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

#[cfg(feature = "plot")]
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
