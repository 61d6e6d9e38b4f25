//! Linear models of declared systems: from a textual operating point to text or JSON.

use lagrange_dynamic::{DeclaredSystem, FoundEquilibrium, SearchSettings};
use lagrange_runtime::linear::{DenseMatrix, Eigenmode, LinearModel, Modes, Stability};
use serde_json::{Map, Value, json};

use crate::arguments::Point;
use crate::motions::{Failure, set, start, time};

/// A linear model with its modes and operating point.
pub(crate) struct Linearised {
    time: f64,
    /// Names and values of the state.
    state: Vec<(String, f64)>,
    /// Names and values of the inputs.
    inputs: Vec<(String, f64)>,
    /// Equilibrium, if it was searched for.
    equilibrium: Option<FoundEquilibrium>,
    model: LinearModel,
    modes: Modes,
}

impl Linearised {
    /// Reads an operating point, sets the parameters of the system, and linearises it there.
    ///
    /// # Errors
    /// If a setting is invalid, with the first one, or if there is no equilibrium or no linear
    /// model.
    pub(crate) fn new(point: &Point, system: &mut DeclaredSystem) -> Result<Self, Failure> {
        set(&point.values, system)?;
        let near = start("at", &point.values, system)?;
        let time = point.time.as_deref().map_or(Ok(0.0), |text| time("time", text))?;
        let equilibrium = equilibrium(point, time, &near, system)?;
        let state = equilibrium.as_ref().map_or(near, |found| found.state.clone());
        let nowhere = |message: String| Failure::Ended(message);
        let model = system.linearise(time, &state).map_err(|error| nowhere(error.to_string()))?;
        let modes = model.modes().map_err(|error| nowhere(error.to_string()))?;
        let state = system.state_names().into_iter().zip(state).collect();
        Ok(Linearised { time, state, inputs: inputs(system), equilibrium, model, modes })
    }

    /// Returns the result as text or JSON.
    pub(crate) fn text(&self, is_json: bool) -> String {
        if is_json { format!("{:#}\n", self.json()) } else { self.table() }
    }

    fn json(&self) -> Value {
        let model = &self.model;
        let equilibrium = self
            .equilibrium
            .as_ref()
            .map(|found| json!({ "iterations": found.iterations, "freedom": found.freedom }));
        json!({
            "time": self.time,
            "state": object(&self.state),
            "inputs": object(&self.inputs),
            "equilibrium": equilibrium,
            "states": model.states(),
            "input_names": model.inputs(),
            "output_names": model.outputs(),
            "a": rows(model.a()),
            "b": rows(model.b()),
            "c": rows(model.c()),
            "d": rows(model.d()),
            "modes": self.modes.modes().iter().map(|mode| self.mode(mode)).collect::<Vec<_>>(),
            "stability": match self.modes.stability() {
                Stability::AsymptoticallyStable => "asymptotically stable",
                Stability::Undecided => "undecided",
                Stability::Unstable => "unstable",
            },
        })
    }

    fn mode(&self, mode: &Eigenmode) -> Value {
        let parts = mode.shape.iter().map(|(real, imaginary)| json!([real, imaginary]));
        let shape = self.modes.components().iter().cloned().zip(parts).collect::<Map<_, _>>();
        json!({
            "real": mode.real,
            "imaginary": mode.imaginary,
            "natural_frequency": mode.natural_frequency(),
            "frequency": mode.frequency(),
            "damping_ratio": mode.damping_ratio(),
            "shape": shape,
        })
    }

    fn table(&self) -> String {
        let place = if self.equilibrium.is_some() { "equilibrium" } else { "state" };
        let mut text = format!("{place} at time {:?}:\n{}", self.time, lines(&self.state));
        if let Some(found) = self.equilibrium.as_ref().filter(|found| found.freedom > 0) {
            text += &format!("  directions to other equilibria: {}\n", found.freedom);
        }
        if !self.inputs.is_empty() {
            text += &format!("inputs:\n{}", lines(&self.inputs));
        }
        text + &format!("{:.10}\nmodes:\n{}\n", self.model, self.modes)
    }
}

/// Finds the equilibrium if it is requested, and sets the trimmed inputs of the system.
fn equilibrium(
    point: &Point,
    time: f64,
    near: &[f64],
    system: &mut DeclaredSystem,
) -> Result<Option<FoundEquilibrium>, Failure> {
    if !point.is_equilibrium {
        return match (&point.hold[..], &point.trim[..]) {
            ([], []) => Ok(None),
            _ => Err(Failure::Usage("--hold and --trim belong to a search: add `--equilibrium`".to_owned())),
        };
    }
    check_unknowns(point, system)?;
    let (near, hold, trim) = (near.to_vec(), point.hold.clone(), point.trim.clone());
    let found = system.equilibrium(SearchSettings { time, near, hold, trim });
    let found = found.map_err(|error| Failure::Ended(error.to_string()))?;
    for ((name, _), value) in inputs(system).iter().zip(&found.inputs) {
        system.set(name, *value).map_err(|error| Failure::Ended(error.to_string()))?;
    }
    Ok(Some(found))
}

/// Checks the names of held and trimmed quantities.
fn check_unknowns(point: &Point, system: &DeclaredSystem) -> Result<(), Failure> {
    let states = system.state_names();
    let inputs = inputs(system).into_iter().map(|(name, _)| name).collect::<Vec<_>>();
    for (option, given, known) in [("hold", &point.hold, &states), ("trim", &point.trim, &inputs)] {
        if let Some(name) = given.iter().find(|name| !known.contains(name)) {
            let known = known.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ");
            return Err(Failure::Usage(format!("--{option}: there is no `{name}`; known are {known}")));
        }
    }
    Ok(())
}

/// Returns names and values of the inputs.
fn inputs(system: &DeclaredSystem) -> Vec<(String, f64)> {
    let values = system.numeric().fields().iter().copied();
    let all = system.variables().fields.iter().cloned().zip(values);
    all.skip(system.programs().layout.parameters).collect()
}

fn object(values: &[(String, f64)]) -> Value {
    values.iter().map(|(name, value)| (name.clone(), json!(value))).collect::<Map<_, _>>().into()
}

fn rows(matrix: &DenseMatrix) -> Vec<&[f64]> {
    (0..matrix.rows()).map(|row| matrix.row(row)).collect()
}

fn lines(values: &[(String, f64)]) -> String {
    values.iter().map(|(name, value)| format!("  {name} = {value:?}\n")).collect()
}
