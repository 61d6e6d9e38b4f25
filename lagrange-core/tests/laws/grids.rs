//! A table by axes and a matrix, in the declaration or in a file, is the table of its points.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::parse_with;
use lagrange_core::tables::FileText;
use proptest::prelude::{Strategy, any, prop_assert_eq, proptest};
use quote::quote;

use crate::printing::{emitted, printed_and_read, read};

/// A file as the source of a table.
const FILE: &str = "\"map.csv\"";

/// A table of random size.
#[derive(Clone, Debug)]
struct Grid {
    axes: [Vec<String>; 2],
    rows: Vec<Vec<String>>,
    /// Numbers that determine the order of points.
    order: Vec<u32>,
}

/// Returns ascending numbers with a few digits.
fn axis() -> impl Strategy<Value = Vec<String>> {
    let steps = proptest::collection::vec(1_i32..40, 1..5);
    (-50_i32..50, steps).prop_map(|(first, steps)| {
        let mut knot = first;
        let further = steps.into_iter().map(|step| {
            knot += step;
            format!("{}", f64::from(knot) / 8.0)
        });
        [format!("{}", f64::from(first) / 8.0)].into_iter().chain(further).collect()
    })
}

fn grids() -> impl Strategy<Value = Grid> {
    (axis(), axis()).prop_flat_map(|(rows, columns)| {
        let [height, width] = [rows.len(), columns.len()];
        let row = proptest::collection::vec((-999_i32..999).prop_map(|value| format!("{value}e-2")), width);
        let order = proptest::collection::vec(any::<u32>(), height * width);
        let axes = [rows, columns];
        (proptest::collection::vec(row, height), order).prop_map(move |(rows, order)| Grid {
            axes: axes.clone(),
            rows,
            order,
        })
    })
}

impl Grid {
    /// Returns the points in some order.
    fn points(&self) -> String {
        let rows = self.axes[0].iter().zip(&self.rows);
        let points = rows.flat_map(|(x, values)| {
            self.axes[1].iter().zip(values).map(move |(y, value)| format!("({x}, {y}, {value})"))
        });
        let mut points = self.order.iter().zip(points).collect::<Vec<_>>();
        points.sort();
        let points = points.into_iter().map(|(_, point)| point).collect::<Vec<_>>();
        format!("[{}]", points.join(", "))
    }

    fn matrix(&self) -> String {
        let [rows, columns] = self.axes.each_ref().map(|axis| axis.join(", "));
        let values = self.rows.iter().map(|row| format!("[{}]", row.join(", "))).collect::<Vec<_>>();
        format!("[{}], columns: [{columns}], rows: [{rows}]", values.join(", "))
    }

    /// Returns a file with this corner.
    fn file(&self, corner: &str, separator: &str) -> String {
        let head = [corner.to_owned()].into_iter().chain(self.axes[1].iter().cloned()).collect::<Vec<_>>();
        let rows = self.axes[0].iter().zip(&self.rows);
        let rows = rows.map(|(x, values)| format!("{x}{separator}{}\n", values.join(separator)));
        format!("# a map\n{}\n{}", head.join(separator), rows.collect::<String>())
    }
}

/// Returns a system with a table from this source.
fn system(source: &str, is_natural: bool) -> String {
    let (interpolation, outside) = if is_natural { ("natural", "extend") } else { ("linear", "clamp") };
    format!(
        "table map(speed: rpm, load): kN = {source}, interpolation: {interpolation}, outside: {outside};
         coord x: m;
         kinetic = kinetic_energy(1 kg, dot(x));
         force x = map(dot(x) / 1 [m], x / 1 [m]);"
    )
}

/// Returns the code for a table from this source, which may be the file `map.csv`.
fn code(source: &str, file: &str, is_natural: bool) -> Result<String, String> {
    let read = |_: &str| Ok(FileText { path: String::new(), text: file.to_owned() });
    let parsed = parse_with(&system(source, is_natural), &read);
    let derived = parsed.and_then(|system| system.derive(StrategyChoice::Cheapest));
    let emitted = derived.and_then(|derived| derived.emit(&quote!(::lagrange)));
    emitted
        .map(|tokens| without_fingerprint(&tokens.to_string()))
        .map_err(|report| format!("{source}\n{file}\n{report}"))
}

/// Removes the number of a declaration, which depends on its text.
fn without_fingerprint(code: &str) -> String {
    let (before, after) = code.split_once("FINGERPRINT").expect("a fingerprint");
    let (_, after) = after.split_once(';').expect("its end");
    format!("{before}{after}")
}

proptest! {
    #![proptest_config(crate::one_in(32))]

    #[test]
    fn a_matrix_between_axes_is_the_table_of_its_points(grid in grids(), is_natural in any::<bool>()) {
        let expected = code(&grid.points(), "", is_natural);
        assert!(expected.is_ok(), "{expected:?}");
        prop_assert_eq!(code(&grid.matrix(), "", is_natural), expected);
        let declaration = read(&system(&grid.matrix(), is_natural));
        prop_assert_eq!(emitted(printed_and_read(&declaration)), emitted(declaration));
    }

    #[test]
    fn a_grid_in_a_file_is_the_table_of_its_points(grid in grids(), is_natural in any::<bool>()) {
        let points = grid.points().replace("), (", "\n").replace(['[', ']', '(', ')'], "");
        let expected = code(FILE, &points, is_natural);
        assert!(expected.is_ok(), "{expected:?}");
        for (corner, separator) in
            [("", ","), ("", "; "), ("", "\t"), ("  ", "  "), ("speed/load", " "), ("n [rpm] \\ load", "\t")]
        {
            prop_assert_eq!(code(FILE, &grid.file(corner, separator), is_natural), expected.clone());
        }
    }
}
