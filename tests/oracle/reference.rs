//! The references of this directory, and the comparison of derived systems with them. Every such
//! test has this module.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

/// The number of systems, so that a lost file is noticed.
pub(crate) const SYSTEMS: usize = 21;

/// A system under test with any number of coordinates.
pub(crate) trait Subject {
    /// Returns q̈.
    fn acceleration(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64>;

    /// Returns `forcing` or a quantity under its key in the files, matrices row by row, or `None`
    /// if it does not exist.
    fn quantity(&self, key: &str, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>>;

    /// Returns the generalised forces that must be added to produce accelerations.
    fn inverse_dynamics(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Vec<f64>;
}

/// A declaration with its reference values.
pub(crate) struct Reference {
    /// The text of the declaration.
    pub(crate) declaration: String,
    values: Value,
}

impl Reference {
    /// Reads the reference with this name from `directory`.
    pub(crate) fn read(directory: &Path, name: &str) -> Reference {
        let [declaration, values] = ["lag", "json"].map(|extension| {
            let path = directory.join(name).with_extension(extension);
            fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
        });
        Reference { declaration, values: serde_json::from_str(&values).expect("valid JSON") }
    }

    /// Returns the parameters and inputs with their values.
    pub(crate) fn settings(&self) -> Vec<(&str, f64)> {
        let kinds = ["params", "inputs"].map(|kind| self.values[kind].as_object().expect("values by name"));
        kinds.into_iter().flatten().map(|(name, value)| (name.as_str(), number(value))).collect()
    }

    /// Returns the states with reference values.
    pub(crate) fn states(&self) -> impl Iterator<Item = State<'_>> {
        let states = self.values["states"].as_array().expect("a list of states");
        states.iter().map(|values| {
            let [q, v] = ["q", "v"].map(|key| numbers(&values[key]));
            State { values, t: number(&values["t"]), q, v }
        })
    }

    /// Returns all differences between a system and its reference.
    pub(crate) fn failures(&self, subject: &impl Subject) -> Vec<String> {
        let compare = |state: State<'_>| {
            let failures = state.failures(subject);
            failures.into_iter().map(move |failure| format!("at t = {}: {failure}", state.t))
        };
        self.states().flat_map(compare).collect()
    }
}

/// Returns the names of all references in a directory.
pub(crate) fn names(directory: &Path) -> BTreeSet<String> {
    let [declarations, values] = ["lag", "json"].map(|extension| {
        let entries = fs::read_dir(directory).expect("the directory of references");
        let paths = entries.map(|entry| entry.expect("a readable entry").path());
        let wanted = paths.filter(|path| path.extension().is_some_and(|found| found == extension));
        let stem = |path: PathBuf| path.file_stem().expect("a name").to_string_lossy().into_owned();
        wanted.map(stem).collect::<BTreeSet<_>>()
    });
    assert_eq!(declarations, values, "every declaration has its reference");
    assert_eq!(declarations.len(), SYSTEMS, "the number of references");
    declarations
}

/// A state with its reference values.
pub(crate) struct State<'a> {
    values: &'a Value,
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
}

impl State<'_> {
    fn failures(&self, subject: &impl Subject) -> Vec<String> {
        let State { values, t, q, v } = self;
        let mut failures = Vec::new();
        let mut compare = |what: &str, found: Option<Vec<f64>>, expected: Option<&[f64]>, scale: f64| {
            if !agree(found.as_deref(), expected, scale) {
                failures.push(format!("{what} is {found:?}, not {expected:?}"));
            }
        };
        for key in ["mass_matrix", "momenta", "energy", "kinetic", "potential"] {
            compare(key, subject.quantity(key, *t, q, v), values.get(key).map(numbers).as_deref(), 0.0);
        }
        let [acceleration, matrix] = ["acceleration", "mass_matrix"].map(|key| numbers(&values[key]));
        let forcing = times(&matrix, &acceleration);
        compare("acceleration", Some(subject.acceleration(*t, q, v)), Some(&acceleration), 0.0);
        compare("forcing", subject.quantity("forcing", *t, q, v), Some(&forcing), 0.0);
        let other = (0..acceleration.len()).map(|i| 1.0 - 0.5 * i as f64).collect();
        for acceleration in [acceleration, other] {
            let inertia = times(&matrix, &acceleration);
            let missing = inertia.iter().zip(&forcing).map(|(m, f)| m - f).collect::<Vec<_>>();
            let found = subject.inverse_dynamics(*t, q, v, &acceleration);
            compare("inverse dynamics", Some(found), Some(&missing), largest(&forcing));
        }
        failures
    }
}

/// True if both are the same vector, or absent; `scale` is the magnitude of the terms that cancel
/// in it.
fn agree(found: Option<&[f64]>, expected: Option<&[f64]>, scale: f64) -> bool {
    match (found, expected) {
        (Some(found), Some(expected)) if found.len() == expected.len() => {
            let tolerance = 1e-12 * (1.0 + largest(expected).max(scale));
            found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= tolerance)
        }
        (found, expected) => found.is_none() && expected.is_none(),
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// Returns the product of a matrix, in rows, and a vector.
fn times(matrix: &[f64], vector: &[f64]) -> Vec<f64> {
    let rows = matrix.chunks(vector.len());
    rows.map(|row| row.iter().zip(vector).map(|(m, x)| m * x).sum()).collect()
}

fn number(value: &Value) -> f64 {
    value.as_str().expect("a number in quotes").parse().expect("a number")
}

/// Returns all numbers of a scalar, a vector or a matrix, row by row.
fn numbers(value: &Value) -> Vec<f64> {
    match value {
        Value::Array(entries) => entries.iter().flat_map(numbers).collect(),
        scalar => vec![number(scalar)],
    }
}
