//! A URDF file compared with Pinocchio's results for it: the tool behind `docs/robots.md`, called
//! by `tools/urdf.py --robots`.
//!
//! `cargo run --release -p lagrange-import --example beside_pinocchio -- robot.urdf reference.txt [--free] [--trust-inertia]`
//! prints degrees of freedom, constraints and operations of the accelerations. It also prints the
//! largest relative difference from the reference, and the number of links with an impossible
//! inertia. If nothing is imported, it prints the reason. Without files it takes one of the tests.

#[path = "../tests/import/reference.rs"]
mod reference;

use std::process::ExitCode;
use std::{env, fs};

use lagrange_core::accuracy::Accuracy;
use lagrange_core::expr::ExprId;
use lagrange_core::pipeline::Derived;
use lagrange_core::program::{Labels, OperationCounts, lower, optimise};
use lagrange_import::urdf::{Options, import};

fn main() -> ExitCode {
    let arguments = env::args().skip(1).collect::<Vec<_>>();
    let has = |option: &str| arguments.iter().any(|argument| argument == option);
    let options =
        Options { is_free: has("--free"), trusts_inertia: has("--trust-inertia"), ..Options::default() };
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
    let file = |index: usize, default: &str| match arguments.get(index) {
        Some(path) => path.clone(),
        None => format!("{folder}/{default}"),
    };
    match compare(&file(0, "every_joint.urdf"), &file(1, "every_joint.txt"), &options) {
        Ok(row) => println!("{row}"),
        Err(message) => {
            println!("{message}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// Returns the row of a robot, or the reason why there is none.
fn compare(robot: &str, reference: &str, options: &Options) -> Result<String, String> {
    let read = |path: &str| fs::read_to_string(path).map_err(|error| format!("{path}: {error}"));
    let imported = import(&read(robot)?, options).map_err(|mistakes| {
        let errors = mistakes.iter().filter(|mistake| mistake.is_error);
        errors
            .map(|mistake| format!("{}: {}: {}", mistake.line, mistake.element, mistake.message))
            .collect::<Vec<_>>()
            .join("\n")
    })?;
    let derived = reference::derive(&imported)?;
    let freedoms = derived.model.speeds.len();
    let constraints = derived.equations.constraints.drifts.len();
    let difference = reference::largest_difference(&imported, &derived, &read(reference)?)?;
    let impossible = imported.declaration.matches("/// No body has the inertia").count();
    Ok(format!("{freedoms} {constraints} {} {difference:.1e} {impossible}", operations(&derived)))
}

/// Counts the operations of the accelerations.
fn operations(derived: &Derived) -> usize {
    let roots: &[ExprId] = &derived.equations.accelerations;
    let program = lower(&derived.model.graph, roots, &Labels::default());
    OperationCounts::of(&optimise(&program, Accuracy::Standard)).total()
}
