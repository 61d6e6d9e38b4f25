//! Names, units and defaults as arrays.

use lagrange_core::emit::Variables;
use lagrange_core::model::EntryLimits;
use lagrange_core::pipeline::Programs;
use lagrange_core::syntax::ast::Direction;

use crate::names::{number, text, unit};

/// An array of constants.
pub(crate) struct Array {
    kind: &'static str,
    name: &'static str,
    /// Documentation of the array.
    pub(crate) docs: &'static str,
    values: Vec<String>,
}

impl Array {
    /// Returns the declaration without storage class and values.
    pub(crate) fn declaration(&self, name: &str) -> String {
        format!("const {}{name}_{}[{}]", self.kind, self.name, self.values.len())
    }

    /// Returns the definition.
    pub(crate) fn definition(&self, name: &str) -> String {
        format!("{} = {{ {} }};\n", self.declaration(name), self.values.join(", "))
    }
}

/// Returns the non-empty arrays of a module.
pub(crate) fn arrays(programs: &Programs) -> Vec<Array> {
    let variables = &programs.variables;
    let mut arrays = of_state(variables);
    arrays.extend(of_parameters(programs));
    arrays.extend(of_outputs(variables));
    arrays.extend(of_events(variables));
    arrays.push(names("constraint_names", "Names of the constraints.", &variables.constraints));
    arrays.retain(|array| !array.values.is_empty());
    arrays
}

fn of_state(variables: &Variables) -> Vec<Array> {
    let (state, limits) = (variables.state_names(), &variables.limits);
    let is_bounded = limits.iter().any(EntryLimits::is_bounded);
    let bounds = |side: usize, open: &str| {
        let bound = |limits: &EntryLimits| limits.bounds[side].map(|(bound, _)| number(bound));
        let bounded = limits.iter().filter(|_| is_bounded);
        bounded.map(|limits| bound(limits).unwrap_or_else(|| open.to_owned())).collect()
    };
    let nominal = EntryLimits::nominal_values(limits).into_iter().map(number).collect();
    vec![
        names("state_names", "Names of the entries of y.", &state),
        units("state_units", "Units of the entries of y; empty if unknown.", variables, &state),
        numbers(
            "state_nominal",
            "Magnitudes that count as one for the entries of y, for tolerances.",
            nominal,
        ),
        numbers("state_min", "Lower bounds of the entries of y, for checks.", bounds(0, "-INFINITY")),
        numbers("state_max", "Upper bounds of the entries of y, for checks.", bounds(1, "INFINITY")),
    ]
}

fn of_parameters(programs: &Programs) -> [Array; 3] {
    let variables = &programs.variables;
    let defaults = programs.defaults.iter().map(|value| number(*value)).collect();
    [
        names("parameter_names", "Names of the entries of p.", &variables.fields),
        units(
            "parameter_units",
            "Units of the entries of p; empty if unknown.",
            variables,
            &variables.fields,
        ),
        numbers("default_parameters", "Defaults of the entries of p; NAN without one.", defaults),
    ]
}

fn of_outputs(variables: &Variables) -> [Array; 2] {
    let outputs = variables.outputs.concat();
    [
        names("output_names", "Names of the outputs.", &outputs),
        units("output_units", "Units of the outputs; empty if unknown.", variables, &outputs),
    ]
}

fn of_events(variables: &Variables) -> [Array; 2] {
    let direction = |direction| match direction {
        Direction::Rising => "1",
        Direction::Falling => "-1",
        Direction::Crossing => "0",
    };
    let events = variables.events.iter();
    let directions = events.clone().map(|event| direction(event.direction).to_owned()).collect();
    let docs = "Zeros that count: 1 rising, -1 falling, 0 both.";
    [
        texts("event_names", "Names of the events.", events.map(|event| text(&event.name)).collect()),
        Array { kind: "int ", name: "event_directions", docs, values: directions },
    ]
}

fn names(name: &'static str, docs: &'static str, names: &[String]) -> Array {
    texts(name, docs, names.iter().map(|name| text(name)).collect())
}

fn units(name: &'static str, docs: &'static str, variables: &Variables, names: &[String]) -> Array {
    texts(name, docs, names.iter().map(|name| text(unit(variables, name))).collect())
}

fn texts(name: &'static str, docs: &'static str, values: Vec<String>) -> Array {
    Array { kind: "char *const ", name, docs, values }
}

fn numbers(name: &'static str, docs: &'static str, values: Vec<String>) -> Array {
    Array { kind: "double ", name, docs, values }
}
