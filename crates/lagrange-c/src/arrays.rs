//! Names, units and defaults as arrays.

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
