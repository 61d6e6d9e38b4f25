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
}

#[test]
fn columns_are_chosen_by_name() {
    let data = Data::parse_csv("t in s,x in m,y\n0,1,\n1,2,3\n").unwrap();
    assert_eq!(data.times(), [0.0, 1.0]);
    assert_eq!(data.column("y"), Some(&[None, Some(3.0)][..]));
    let x = data.only(["x", "z"]);
    assert_eq!((x.column("y"), x.column("x")), (None, Some(&[Some(1.0), Some(2.0)][..])));
}
