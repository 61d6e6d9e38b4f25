use super::{FileText, read_files};
use crate::diagnostics::Report;
use crate::syntax::ast::{StatementKind, TableSource};
use crate::syntax::parse_text;

/// The points of a file, or what is wrong with it.
fn read(text: &str) -> Result<Vec<(usize, Vec<f64>)>, String> {
    let mut report = Report::default();
    let declaration = "table road(x) = \"road.csv\", interpolation: natural, outside: error;";
    let mut declaration = parse_text(declaration, &mut report).expect("tokens");
    let reader = |path: &str| match path {
        "road.csv" => Ok(FileText { path: "/road.csv".to_owned(), text: text.to_owned() }),
        _ => Err("it is not there".to_owned()),
    };
    read_files(&mut declaration, &reader, &mut report);
    let [statement] = &declaration.statements[..] else { panic!("{report}") };
    let StatementKind::Table(table) = &statement.kind else { panic!("{report}") };
    let TableSource::File { contents, .. } = &table.source else { panic!("{report}") };
    contents.clone().map(|file| file.points).ok_or_else(|| report.to_string())
}

#[test]
fn points_stand_on_lines() {
    let text = "# a road\nx / m, height / m\n\n0, 1.5\n0.25;-2e-3\r\n1.0\t+7\n# the end\n";
    let expected = vec![(4, vec![0.0, 1.5]), (5, vec![0.25, -2e-3]), (6, vec![1.0, 7.0])];
    assert_eq!(read(text), Ok(expected));
    assert_eq!(read("1, 2"), Ok(vec![(1, vec![1.0, 2.0])]));
    assert_eq!(read("x y\n 0   1\n.5 2e3 \n"), Ok(vec![(2, vec![0.0, 1.0]), (3, vec![0.5, 2e3])]));
}

#[test]
fn mistakes_are_named_by_their_line() {
    let message = |text: &str| read(text).expect_err("a mistake");
    assert!(message("x, y\n0, 1\n1, two\n").contains("line 3 of `road.csv`: `two` is no number"));
    assert!(message("0, 1\nx, y\n").contains("line 2 of `road.csv`: `x` is no number"));
    assert!(message("0, 1, 2\n").contains("line 1 of `road.csv`: the point has 3 numbers, not 2"));
    assert!(message("1,5; 2\n").contains("line 1 of `road.csv`: `1,5` is no number"));
    assert!(message("1,5; 2\n").contains("write decimals with a point"));
    assert!(message("0, inf\n").contains("line 1 of `road.csv`: `inf` is no number"));
    assert!(message("0, 1\n1,\n").contains("line 2 of `road.csv`: `` is no number"));
}
