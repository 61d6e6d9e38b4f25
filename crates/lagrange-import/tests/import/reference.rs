//! An imported robot compared with Pinocchio's results for the same file (`tools/urdf.py`, which
//! describes the lines of references).

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use lagrange_import::urdf::{Import, Motion};

/// The name of the base in references.
const BASE: &str = "root_joint";

/// Derives the equations of an imported robot.
pub(crate) fn derive(imported: &Import) -> Result<Derived, String> {
    let statements = statements(&imported.declaration);
    let system = parse(statements).map_err(|report| report.to_string())?;
    system.derive(StrategyChoice::Cheapest).map_err(|report| report.to_string())
}

/// Returns returns the text within the macro.
pub(crate) fn statements(declaration: &str) -> &str {
    let inner = declaration.strip_prefix("lagrange::system! {").and_then(|rest| rest.strip_suffix("}\n"));
    inner.expect("a declaration within the macro")
}

/// Returns the largest difference of accelerations from those of a reference, as a fraction of the
/// largest of a state or of one.
///
/// # Errors
/// Returns an error if the two have different joints.
pub(crate) fn largest_difference(
    imported: &Import,
    derived: &Derived,
    reference: &str,
) -> Result<f64, String> {
    let system = NumericSystem::new(derived);
    let mut worst = 0.0_f64;
    for [q, v, expected] in states(imported, reference)? {
        let found = system.acceleration(0.0, &q, &v);
        let size = expected.iter().fold(1.0_f64, |size, value| size.max(value.abs()));
        if found.len() != expected.len() {
            return Err(format!("{} accelerations, not {}", found.len(), expected.len()));
        }
        let differences =
            found.iter().zip(&expected).map(|(found, expected)| (found - expected).abs() / size);
        // NaN counts as the largest difference.
        worst =
            differences.fold(worst, |worst, difference| if difference <= worst { worst } else { difference });
    }
    Ok(worst)
}

/// Returns positions, velocities and accelerations of every state of a reference, in the order of
/// the declaration.
///
/// # Errors
/// Returns an error if the two have different joints.
pub(crate) fn states(imported: &Import, reference: &str) -> Result<Vec<[Vec<f64>; 3]>, String> {
    reference.split("state\n").skip(1).map(|state| state_of(&imported.motions, state)).collect()
}

fn state_of(motions: &[Motion], state: &str) -> Result<[Vec<f64>; 3], String> {
    let rows = state.lines().map(|line| line.split('\t').collect::<Vec<_>>()).collect::<Vec<_>>();
    if rows.len() != motions.len() {
        return Err(format!("{} motions, not {}", motions.len(), rows.len()));
    }
    let mut columns = [const { Vec::new() }; 3];
    for motion in motions {
        let name = motion.joint.as_deref().unwrap_or(BASE);
        let row =
            rows.iter().find(|row| row[0] == name).ok_or_else(|| format!("`{name}` has no reference"))?;
        for (column, text) in columns.iter_mut().zip(&row[1..]) {
            column.extend(text.split(' ').map(|number| number.parse::<f64>().unwrap_or(f64::NAN)));
        }
    }
    Ok(columns)
}
