use super::{FileText, decoded, read_files};
use crate::syntax::ast::{StatementKind, TableSource};
use crate::syntax::parse_text;
use lagrange_expr::diagnostics::Report;

/// Points with their lines, or errors.
type Points = Result<Vec<(usize, Vec<f64>)>, String>;

/// Returns the points of a file for a table of one argument.
fn read(text: &str) -> Points {
    read_for("x", text)
}

fn read_for(arguments: &str, text: &str) -> Points {
    let mut report = Report::default();
    let declaration =
        format!("table road({arguments}) = \"road.csv\", interpolation: natural, outside: error;");
    let mut declaration = parse_text(&declaration, &mut report).expect("tokens");
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
    assert!(message("x, y\n0, 1\n1, two\n").contains("line 3 of `road.csv`: `two` is not a number"));
    assert!(message("0, 1\nx, y\n").contains("line 2 of `road.csv`: `x` is not a number"));
    assert!(message("0, 1, 2\n").contains("line 1 of `road.csv`: the point has 3 numbers, not 2"));
    assert!(message("1,5; 2\n").contains("line 1 of `road.csv`: `1,5` is not a number"));
    assert!(message("1,5; 2\n").contains("write decimals with a point"));
    assert!(message("0, inf\n").contains("line 1 of `road.csv`: `inf` is not a number"));
    assert!(message("0, 1\n1, -1e999\n").contains("line 2 of `road.csv`: `-1e999` is too large for `f64`"));
    assert!(message("0, 1\n1,\n").contains("line 2 of `road.csv`: `` is not a number"));
}

#[test]
fn comments_stand_behind_values_and_marks_before_them() {
    let expected = vec![(2, vec![0.0, 1.5]), (3, vec![0.25, 2.0])];
    for text in [
        "\u{feff}x, y # metres\n0, 1.5 # start\n0.25, 2.0# end",
        "\u{feff}# a road\r\n0, 1.5\r\n0.25, 2#, 7\r\n",
        "#\n0 1.5 #\n0.25 2 # # #\n   # last",
    ] {
        assert_eq!(read(text).as_ref(), Ok(&expected), "{text}");
    }
    assert_eq!(read("\u{feff}0, 1\n"), Ok(vec![(1, vec![0.0, 1.0])]));
    assert_eq!(read(""), Ok(Vec::new()));
    assert_eq!(read("# nothing\n\n"), Ok(Vec::new()));
}

/// A first line that is meant to be a point, but is invalid, is not taken for names of columns.
#[test]
fn names_of_columns_are_no_numbers_that_went_wrong() {
    let is_wrong = |text: &str, field: &str| {
        let message = read(&format!("{text}\n0.0; 1\n1.0; 2\n")).expect_err(text);
        assert!(message.contains(&format!("line 1 of `road.csv`: `{field}` is")), "{message}");
    };
    is_wrong("0,5; 1,5", "0,5");
    is_wrong("nan; nan", "nan");
    is_wrong("-inf; Infinity", "-inf");
    is_wrong("1e999; 2e999", "1e999");
    is_wrong("1.0m; 2.0m", "1.0m");
    is_wrong("−1; −2", "−1");
    is_wrong(";", "");
    for names in ["x; y", "time [s]; \u{3b8}", "\"x\"; \"y\"", ";y", "(m); (kg)", "e1; _2"] {
        assert_eq!(read(&format!("{names}\n0;1")), Ok(vec![(2, vec![0.0, 1.0])]), "{names}");
    }
}

#[test]
fn decimal_commas_are_named_wherever_they_are_seen() {
    for text in ["1,5; 2", "1;2,5", "1,5\t2", "0,5, 1,5", "0,5,1,5"] {
        let message = read(text).expect_err(text);
        assert!(message.contains("write decimals with a point"), "{message}");
    }
}

#[test]
fn grids_have_a_corner() {
    let grid = |text: &str| read_for("speed, load", text);
    let point = |line: usize, x: f64, y: f64, z: f64| (line, vec![x, y, z]);
    let expected = vec![point(2, -1.0, 0.5, 3.0), point(2, -1.0, 2.0, 4.0), point(4, 7.0, 0.5, 5.0)];
    let expected = expected.into_iter().chain([point(4, 7.0, 2.0, 6.0)]).collect::<Vec<_>>();
    for text in [
        ", 0.5, 2\n-1, 3, 4\n\n7, 5, 6\n",
        "speed \\ load;.5;2 # loads\n-1;3;4\n# fast\n7;5;6",
        "\t0.5\t2\r\n-1\t3\t4\r\n\r\n7\t5\t6\r\n",
        "\u{feff}   0.5 2\n-1   3 4\n \n 7   5 6",
        "\"x/y\" 0.5 2\n-1 3 4\n\n7 5 6",
    ] {
        assert_eq!(grid(text).as_ref(), Ok(&expected), "{text}");
    }
    let points = Ok(vec![point(2, 0.0, 1.0, 2.0), point(3, 3.0, 4.0, 5.0)]);
    assert_eq!(grid("x, y, z\n0, 1, 2\n3, 4, 5\n"), points);
    assert_eq!(grid("\n \t0 1 2\n\t3 4 5\n"), points);
}

#[test]
fn mistakes_in_grids_are_named_by_their_line() {
    let message = |text: &str| read_for("speed, load", text).expect_err("a mistake");
    let says = |text: &str, expected: &str| assert!(message(text).contains(expected), "{}", message(text));
    says(",0,1\n0,1\n", "line 2 of `road.csv`: the row has 2 numbers, not 3");
    says(",0,1\n0,1,2,3\n", "line 2 of `road.csv`: the row has 4 numbers, not 3");
    says(",0,1\n2,1,2\n2,1,3\n", "line 3 of `road.csv`: `speed` does not ascend from 2 to 2");
    says("x,0,2,1\n0,1,2,3\n", "line 1 of `road.csv`: `load` does not ascend from 2 to 1");
    says("x,0,y\n0,1,2\n", "line 1 of `road.csv`: `y` is not a number");
    says("x,0,1\n0,1,two\n", "line 2 of `road.csv`: `two` is not a number");
    says("x;0;0,5\n0;1;2\n", "write decimals with a point");
    says("x;0;1\n0;1;2\n1,5;2;3\n", "write decimals with a point");
    says("0, 0, 1, 2\n1, 3, 4, 5\n", "an empty or named corner");
    let wide = format!("x,{}\n", (0..1000).map(|y| y.to_string()).collect::<Vec<_>>().join(","));
    says(&wide.lines().cycle().take(102).collect::<Vec<_>>().join("\n"), "`road` has 101000 points");
    assert!(read("x, 0, 1\n0, 1, 2\n").expect_err("one argument").contains("`x` is not a number"));
}

#[test]
fn characters_that_cannot_be_seen_are_escaped_in_messages() {
    let cases = [
        ("0, 1\u{0}", "1\\0"),
        ("0,1\r1,2", "1\\r1"),
        ("1, \u{feff}2", "\\u{feff}2"),
        ("1, \u{1b}[31m", "\\u{1b}[31m"),
    ];
    for (text, shown) in cases {
        let message = read(text).expect_err(text);
        assert!(message.contains(&format!("`{shown}` is not a number")), "{message}");
        assert!(message.chars().all(|letter| letter == '\n' || !letter.is_control()), "{message:?}");
    }
    let long = read(&format!("0, {}", "9x".repeat(1_000_000))).expect_err("no number");
    assert!(long.len() < 500, "{}", long.len());
}

#[test]
fn bytes_that_are_not_text_are_identified() {
    let utf_16 = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
    assert_eq!(decoded(b"0, 1".to_vec()), Ok("0, 1".to_owned()));
    assert_eq!(decoded(Vec::new()), Ok(String::new()));
    let refused = |bytes: Vec<u8>| decoded(bytes).expect_err("no text");
    assert!(refused(utf_16("\u{feff}0, 1")).contains("UTF-16"));
    assert!(refused(utf_16("0, 1")).contains("NUL characters"));
    assert!(refused(b"0, 1\n1, \xfc\n".to_vec()).contains("line 2 is not in UTF-8"));
}
