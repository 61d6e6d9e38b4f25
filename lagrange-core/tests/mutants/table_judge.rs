//! The verdict on the bytes of any file of a table: either a readable error, or a table that passes
//! through its points.
//!
//! The fuzz target `tables` uses the same verdict.

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Derived, NumericSystem, System, parse_with};
use lagrange_core::syntax::ast::{StatementKind, TableSource};
use lagrange_core::tables::{FileText, decoded};

/// Returns statements that use a table, with settings selected by a number.
fn declaration(kind: usize) -> String {
    let interpolation = ["linear", "natural", "monotone"][kind % 3];
    let outside = ["error", "clamp", "extend"][kind / 3 % 3];
    let (parameters, arguments) =
        if (kind / 9).is_multiple_of(2) { ("x", "q") } else { ("x, y", "q, dot(q)") };
    format!(
        "table f({parameters}) = \"f.csv\", interpolation: {interpolation}, outside: {outside};
         coord q;
         kinetic = 1/2 * dot(q)^2;
         force q = f({arguments});"
    )
}

/// Reads a table from a file with these bytes. Returns true if it is accepted.
///
/// # Panics
/// Panics if the file is refused without a readable error, if the table does not pass through its
/// points, or if no code is emitted.
pub(crate) fn judged(bytes: &[u8], kind: usize) -> bool {
    let read = |_: &str| Ok(FileText { path: String::new(), text: decoded(bytes.to_vec())? });
    match parse_with(&declaration(kind), &read) {
        Ok(system) => {
            let points = points(&system);
            let derived = system.derive(StrategyChoice::Cheapest).unwrap_or_else(|report| panic!("{report}"));
            check_points(&points, &derived);
            let emitted = derived.emit(&"::lagrange".parse().expect("a path"));
            emitted.unwrap_or_else(|report| panic!("{report}"));
            true
        }
        Err(report) => {
            let text = report.to_string();
            let is_readable = text.chars().all(|letter| letter == '\n' || !letter.is_control());
            assert!(report.has_errors() && is_readable && text.len() < 2000, "{text:?}");
            false
        }
    }
}

/// Largest difference due to rounding, as a fraction of the largest value. The end of a piece is
/// computed from its beginning.
const ROUNDING: f64 = 1e-9;

/// Returns the points of the file behind the system.
fn points(system: &System) -> Vec<Vec<f64>> {
    let sources = system.declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Table(table) => Some(&table.source),
        _ => None,
    });
    let contents = sources.filter_map(|source| match source {
        TableSource::File { contents, .. } => contents.as_ref(),
        TableSource::Points(_) | TableSource::Grid(_) => None,
    });
    contents.flat_map(|file| file.points.iter().map(|(_, point)| point.clone())).collect()
}

/// Checks that the acceleration of the unit mass has the values of the table.
fn check_points(points: &[Vec<f64>], derived: &Derived) {
    assert!(points.len() > 1, "{points:?}");
    let system = NumericSystem::new(derived);
    let largest = points
        .iter()
        .filter_map(|point| point.last())
        .fold(0.0_f64, |largest, value| largest.max(value.abs()));
    for point in points {
        let Some((value, arguments)) = point.split_last() else { continue };
        let rate = arguments.get(1).copied().unwrap_or(0.0);
        let found = system.acceleration(0.0, &arguments[..1], &[rate]);
        assert!((found[0] - value).abs() <= ROUNDING * largest, "{point:?}: {found:?}");
    }
}
