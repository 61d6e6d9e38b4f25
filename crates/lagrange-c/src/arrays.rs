//! Names, units and defaults as arrays.

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
    const TEXT: &str = "char *const ";
    let variables = &programs.variables;
    let array = |kind, name, docs, values| Array { kind, name, docs, values };
    let texts = |names: &[String]| names.iter().map(|name| text(name)).collect();
    let units = |names: &[String]| names.iter().map(|name| text(unit(variables, name))).collect();
    let (states, outputs) = (variables.state_names(), variables.outputs.concat());
    let limits = &variables.limits;
    let has_nominal = limits.iter().any(|limits| limits.nominal.is_some());
    let nominal = limits.iter().filter(|_| has_nominal);
    let bounds = |side: usize, open: &str| {
        let is_bounded = limits.iter().any(|limits| limits.bounds.iter().any(Option::is_some));
        let bound = |limits: &EntryLimits| {
            limits.bounds[side].map_or_else(|| open.to_owned(), |(bound, _)| number(bound))
        };
        limits.iter().filter(|_| is_bounded).map(bound).collect()
    };
    let events = variables.events.iter();
    let direction = |direction| match direction {
        Direction::Rising => "1",
        Direction::Falling => "-1",
        Direction::Crossing => "0",
    };
    let directions = events.clone().map(|event| direction(event.direction).to_owned()).collect();
    let mut arrays = vec![
        array(TEXT, "state_names", "Names of the entries of y.", texts(&states)),
        array(TEXT, "state_units", "Units of the entries of y; empty if unknown.", units(&states)),
        array(
            "double ",
            "state_nominal",
            "Magnitudes that count as one for the entries of y, for tolerances.",
            nominal.map(|limits| number(limits.nominal.unwrap_or(1.0))).collect(),
        ),
        array(
            "double ",
            "state_min",
            "Lower bounds of the entries of y, for checks.",
            bounds(0, "-INFINITY"),
        ),
        array("double ", "state_max", "Upper bounds of the entries of y, for checks.", bounds(1, "INFINITY")),
        array(TEXT, "parameter_names", "Names of the entries of p.", texts(&variables.fields)),
        array(
            TEXT,
            "parameter_units",
            "Units of the entries of p; empty if unknown.",
            units(&variables.fields),
        ),
        array(
            "double ",
            "default_parameters",
            "Defaults of the entries of p; NAN without one.",
            programs.defaults.iter().map(|value| number(*value)).collect(),
        ),
        array(TEXT, "output_names", "Names of the outputs.", texts(&outputs)),
        array(TEXT, "output_units", "Units of the outputs; empty if unknown.", units(&outputs)),
        array(TEXT, "event_names", "Names of the events.", events.map(|event| text(&event.name)).collect()),
        array("int ", "event_directions", "Zeros that count: 1 rising, -1 falling, 0 both.", directions),
        array(TEXT, "constraint_names", "Names of the constraints.", texts(&variables.constraints)),
    ];
    arrays.retain(|array| !array.values.is_empty());
    arrays
}
