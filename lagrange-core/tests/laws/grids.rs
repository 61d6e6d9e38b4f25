//! A table by axes and a matrix, in the declaration or in a file, is the table of its points.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{NumericSystem, parse, parse_with};
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

/// Returns the place of a number between the knots that surround it, and how far it is between
/// them.
fn between(knots: &[f64], x: f64) -> (usize, f64) {
    let i = (1..knots.len() - 1).rev().find(|i| knots[*i] <= x).unwrap_or(0);
    (i, (x - knots[i]) / (knots[i + 1] - knots[i]))
}

/// Interpolates between the eight corners around a place by hand; the points are listed in any
/// order.
#[test]
fn tables_of_three_arguments_interpolate_between_eight_corners() {
    let (a, b, c) = ([0.0, 1.0, 2.5], [-1.0, 0.5], [0.0, 10.0, 20.0, 40.0]);
    let value = |i: usize, j: usize, k: usize| ((5 * i + 3 * j * j + 7 * k) % 11) as f64 + (i * j * k) as f64;
    let places = (0..24).map(|n| (n / 8, n % 2, n / 2 % 4)).collect::<Vec<_>>();
    let points =
        places.iter().map(|&(i, j, k)| format!("({}, {}, {}, {})", a[i], b[j], c[k], value(i, j, k)));
    let points = points.rev().collect::<Vec<_>>().join(", ");
    let text = |outside: &str| {
        format!(
            "table map(a, b, c) = [{points}], interpolation: linear, outside: {outside};
             coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); force x = map(x, y, t);"
        )
    };
    let derived = |text: &str| {
        let derived = parse(text).and_then(|system| system.derive(StrategyChoice::Cheapest));
        NumericSystem::new(&derived.unwrap_or_else(|report| panic!("{report}")))
    };
    let [clamped, strict] = ["clamp", "error"].map(|outside| derived(&text(outside)));
    for (x, y, t) in
        [(0.0, -1.0, 0.0), (0.3, 0.1, 7.0), (2.0, 0.5, 33.0), (2.5, -0.2, 40.0), (1.0, 0.0, 20.0)]
    {
        let [(i, u), (j, v), (k, w)] = [between(&a, x), between(&b, y), between(&c, t)];
        let corner = |n: usize| {
            let [di, dj, dk] = [n & 1, n >> 1 & 1, n >> 2];
            let part = |step: usize, part: f64| if step == 1 { part } else { 1.0 - part };
            part(di, u) * part(dj, v) * part(dk, w) * value(i + di, j + dj, k + dk)
        };
        let expected = (0..8).map(corner).sum::<f64>();
        for system in [&clamped, &strict] {
            let found = system.acceleration(t, &[x, y], &[0.0; 2])[0];
            assert!((found - expected).abs() < 1e-13, "{found}, not {expected}, at {x}, {y}, {t}");
        }
    }
    assert_eq!(clamped.acceleration(50.0, &[-1.0, 9.0], &[0.0; 2])[0], value(0, 1, 3));
    assert!(strict.acceleration(50.0, &[0.5, 0.0], &[0.0; 2])[0].is_nan());
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
