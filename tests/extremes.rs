//! Compiled code at the extremes: every row of `tests/extremes/double_pendulum.csv`, which
//! `tests/extremes/README.md` explains.

const DECLARATION: &str = include_str!("extremes/double_pendulum.lag");
const TABLE: &str = include_str!("extremes/double_pendulum.csv");

/// Declares a module for a level of accuracy, with the declaration and its tests.
macro_rules! level {
    ($level:ident; $($declaration:tt)*) => {
        mod $level {
            lagrange::system! {
                #[accuracy($level)]
                pub(crate) struct Pendulum;
                $($declaration)*
            }

            fn accelerations(row: &super::Row<'_>) -> [f64; 2] {
                let [m1, m2, l1, l2] = ["m1", "m2", "l1", "l2"].map(|column| row.number(column));
                let pendulum = Pendulum { m1, m2, l1, l2, ..Pendulum::default() };
                let q = ["theta1", "theta2"].map(|column| row.number(column));
                let v = ["dot theta1", "dot theta2"].map(|column| row.number(column));
                pendulum.acceleration(0.0, &q, &v)
            }

            #[test]
            fn declares_what_the_table_is_about() {
                assert_eq!(super::packed(stringify!($($declaration)*)), super::packed(super::DECLARATION));
            }

            #[test]
            fn keeps_its_bounds() {
                super::judge(stringify!($level), accelerations);
            }
        }
    };
}

macro_rules! levels {
    ($($declaration:tt)*) => {
        level! { standard; $($declaration)* }
        level! { strict; $($declaration)* }
    };
}

levels! {
    param m1 = 1, m2 = 1, l1 = 1, l2 = 1, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
}

/// A row of the table.
struct Row<'a> {
    cells: Vec<(&'a str, &'a str)>,
}

impl Row<'_> {
    fn text(&self, column: &str) -> &str {
        let cell = self.cells.iter().find(|(known, _)| *known == column);
        cell.unwrap_or_else(|| panic!("no column {column}")).1
    }

    fn number(&self, column: &str) -> f64 {
        self.text(column).parse().unwrap_or_else(|_| panic!("no number in {column}"))
    }
}

fn rows() -> Vec<Row<'static>> {
    let mut lines = TABLE.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let columns = lines.next().expect("names of columns");
    lines.map(|entries| Row { cells: columns.iter().copied().zip(entries).collect() }).collect()
}

fn judge(column: &str, accelerations: impl Fn(&Row<'_>) -> [f64; 2]) {
    let rows = rows();
    let bounded = rows.iter().filter(|row| !row.text(column).is_empty()).collect::<Vec<_>>();
    assert!(!bounded.is_empty());
    for row in bounded {
        let exact = ["ddot theta1", "ddot theta2"].map(|column| row.number(column));
        for (found, exact) in accelerations(row).into_iter().zip(exact) {
            let error = ((found - exact) / exact).abs();
            assert!(error <= row.number(column), "{found} for {exact}: {:?}", row.cells);
        }
    }
}

/// Returns the tokens of a declaration, without comments and spaces.
fn packed(declaration: &str) -> String {
    let code = declaration.lines().map(|line| line.split("//").next().unwrap_or_default());
    code.flat_map(|line| line.chars().filter(|c| !c.is_whitespace())).collect()
}
