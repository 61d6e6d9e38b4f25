//! The variables of a unit, in the order of their value references.

use lagrange_core::model::EntryLimits;
use lagrange_core::pipeline::Programs;

use crate::error::ExportError;
use crate::quantities::Definitions;

/// Initial values, in coherent units.
#[derive(Clone, PartialEq, Debug)]
pub struct Start {
    /// Values of parameters, then inputs.
    pub fields: Vec<f64>,
    /// State: positions, then velocities.
    pub state: Vec<f64>,
    /// True for entries of the state that do not follow the declared initial values when parameters
    /// change.
    pub are_given: Vec<bool>,
}

/// A variable.
pub(crate) struct Variable {
    pub(crate) name: String,
    pub(crate) unit: Option<String>,
    pub(crate) kind: Kind,
}

/// The role of a variable.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Kind {
    /// An entry of the state with its initial value, true if this depends on parameters, and its
    /// range and nominal value.
    State(f64, bool, EntryLimits),
    /// The rate of the state entry with this index.
    Rate(usize),
    /// A parameter with its value and its bounds.
    Parameter(f64, [Option<f64>; 2]),
    /// An input with its initial value.
    Input(f64),
    /// An output.
    Output,
    /// A function whose zeros are events.
    Indicator,
    /// The time.
    Time,
}

/// Returns all variables, and defines their units.
///
/// # Errors
/// If two have the same name.
pub(crate) fn variables(
    programs: &Programs,
    start: &Start,
    follows: &[bool],
    units: &mut Definitions,
) -> Result<Vec<Variable>, ExportError> {
    let names = &programs.variables;
    let mut variable = |name: &str, kind| {
        let unit = units.define(names.unit(name), false);
        Variable { name: name.to_owned(), unit, kind }
    };
    let states = names.state_names();
    let kinds = start.state.iter().zip(follows).zip(&names.limits);
    let kinds = kinds.map(|((value, follows), limits)| Kind::State(*value, *follows, *limits));
    let mut all = states.iter().zip(kinds).map(|(name, kind)| variable(name, kind)).collect::<Vec<_>>();
    let fields = names.fields.iter().zip(&start.fields).enumerate().map(|(index, (name, value))| {
        let is_parameter = index < programs.layout.parameters;
        variable(name, if is_parameter { parameter(programs, index, *value) } else { Kind::Input(*value) })
    });
    let fields = fields.collect::<Vec<_>>();
    let outputs = names.outputs.concat();
    let outputs = outputs.iter().map(|name| variable(name, Kind::Output)).collect::<Vec<_>>();
    all.extend(states.iter().enumerate().map(|(index, name)| Variable {
        name: format!("der({name})"),
        unit: units.define(names.unit(name), true),
        kind: Kind::Rate(index),
    }));
    all.extend(fields.into_iter().chain(outputs).chain(indicators(programs)));
    all.push(Variable { name: "t".to_owned(), unit: units.define(Some("s"), false), kind: Kind::Time });
    let mut sorted = all.iter().map(|variable| &variable.name).collect::<Vec<_>>();
    sorted.sort();
    match sorted.windows(2).find(|pair| pair[0] == pair[1]) {
        Some(pair) => Err(ExportError::SameName(pair[0].clone())),
        None => Ok(all),
    }
}

fn indicators(programs: &Programs) -> impl Iterator<Item = Variable> {
    let (events, switches) = (&programs.variables.events, programs.variables.switches.len());
    let names = events.iter().map(|event| format!("event.{}", event.name));
    let names = names.chain((1..=switches).map(|number| format!("switch[{number}]")));
    names.map(|name| Variable { name, unit: None, kind: Kind::Indicator })
}

fn parameter(programs: &Programs, index: usize, value: f64) -> Kind {
    let range = programs.ranges.iter().find(|range| range.parameter == index);
    Kind::Parameter(value, range.map_or([None; 2], |range| range.bounds.map(|bound| Some(bound?.0))))
}
