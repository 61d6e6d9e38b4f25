//! The description of a unit in XML.

use std::collections::BTreeSet;

use lagrange_core::pipeline::Programs;

use crate::dependencies::Dependencies;
use crate::quantities::Definitions;
use crate::variables::{Kind, Variable};

/// The heads of a description.
pub(crate) struct Heading<'a> {
    /// Name of the library.
    pub(crate) identifier: &'a str,
    pub(crate) guid: &'a str,
    /// Tolerance of runs that set none.
    pub(crate) tolerance: f64,
    /// Source files that are compiled.
    pub(crate) sources: Vec<&'a str>,
}

/// Writes the description.
pub(crate) fn description(
    programs: &Programs,
    heading: &Heading<'_>,
    variables: &[Variable],
    units: &Definitions,
) -> String {
    let indicators = programs.variables.events.len() + programs.variables.switches.len();
    let listed = variables.iter().enumerate().map(|(index, variable)| written(index, variable));
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"2.0\" modelName=\"{}\" guid=\"{}\"\n    \
         generationTool=\"lagrange {}\" variableNamingConvention=\"{}\" numberOfEventIndicators=\"{indicators}\">\n\
         {}{}\
         \x20 <LogCategories>\n    <Category name=\"logEvents\"/>\n    <Category name=\"logStatusError\"/>\n  \
         </LogCategories>\n\
         \x20 <DefaultExperiment startTime=\"0\" stopTime=\"10\" tolerance=\"{:e}\"/>\n\
         \x20 <ModelVariables>\n{}  </ModelVariables>\n\
         {}</fmiModelDescription>\n",
        escaped(&programs.name),
        heading.guid,
        env!("CARGO_PKG_VERSION"),
        convention(variables),
        kinds(programs, heading),
        units.written(),
        heading.tolerance,
        listed.collect::<String>(),
        structure(programs, variables),
    )
}

/// The elements of model exchange and of co-simulation.
fn kinds(programs: &Programs, heading: &Heading<'_>) -> String {
    let files = heading.sources.iter().map(|file| format!("      <File name=\"{file}\"/>\n"));
    let files = format!("    <SourceFiles>\n{}    </SourceFiles>\n", files.collect::<String>());
    let common = format!(
        "modelIdentifier=\"{}\" canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"\n      \
         providesDirectionalDerivative=\"{}\"",
        heading.identifier,
        programs.linearised.is_some(),
    );
    format!(
        "  <ModelExchange {common}>\n{files}  </ModelExchange>\n\
         \x20 <CoSimulation {common}\n      canHandleVariableCommunicationStepSize=\"true\">\n{files}  \
         </CoSimulation>\n"
    )
}

/// Returns `structured` if the names have the form that this asks for.
fn convention(variables: &[Variable]) -> &'static str {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_.[](,)".contains(c);
    match variables.iter().all(|variable| variable.name.chars().all(is_plain)) {
        true => "structured",
        false => "flat",
    }
}

/// The element of a variable.
fn written(reference: usize, variable: &Variable) -> String {
    let (role, value) = match variable.kind {
        Kind::State(value, false) => ("causality=\"local\" initial=\"exact\"", start(value)),
        Kind::State(value, true) => ("causality=\"local\" initial=\"approx\"", start(value)),
        Kind::Rate(state) => {
            ("causality=\"local\" initial=\"calculated\"", format!(" derivative=\"{}\"", state + 1))
        }
        Kind::Parameter(value, bounds) => {
            let bounds =
                bounds.iter().zip(["min", "max"]).filter_map(|(bound, name)| Some((name, (*bound)?)));
            let bounds = bounds.map(|(name, bound)| format!(" {name}=\"{bound:?}\"")).collect::<String>();
            (
                "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"",
                format!("{bounds}{}", start(value)),
            )
        }
        Kind::Input(value) => ("causality=\"input\"", start(value)),
        Kind::Output => ("causality=\"output\" initial=\"calculated\"", String::new()),
    };
    let unit = variable.unit.as_ref().map_or_else(String::new, |unit| format!(" unit=\"{unit}\""));
    format!(
        "    <!-- {} -->\n    <ScalarVariable name=\"{}\" valueReference=\"{reference}\" {role}>\n      \
         <Real{unit}{value}/>\n    </ScalarVariable>\n",
        reference + 1,
        escaped(&variable.name),
    )
}

fn start(value: f64) -> String {
    format!(" start=\"{value:?}\"")
}

/// The order of outputs, rates and unknowns at the start, with what they depend on.
fn structure(programs: &Programs, variables: &[Variable]) -> String {
    let dependencies = Dependencies::new(programs);
    let (states, parameters) = (
        variables.iter().filter(|variable| matches!(variable.kind, Kind::State(..))).count(),
        programs.layout.parameters,
    );
    // Inputs stand behind the states, their rates and the parameters.
    let index = |place: usize| match place {
        place if place < states => Some(place + 1),
        place if place < states + parameters => None,
        place => Some(place + states + 1),
    };
    let unknown = |variable: usize, places: &BTreeSet<usize>| {
        let known = places.iter().filter_map(|place| index(*place)).map(|index| index.to_string());
        let known = known.collect::<Vec<_>>().join(" ");
        format!("      <Unknown index=\"{}\" dependencies=\"{known}\"/>\n", variable + 1)
    };
    let of_kind = |wanted: fn(Kind) -> bool| {
        variables
            .iter()
            .enumerate()
            .filter(move |(_, variable)| wanted(variable.kind))
            .map(|(index, _)| index)
    };
    let outputs = of_kind(|kind| kind == Kind::Output).zip(dependencies.of_outputs());
    let outputs = outputs.map(|(index, places)| unknown(index, &places)).collect::<String>();
    let rates = of_kind(|kind| matches!(kind, Kind::Rate(_))).enumerate();
    let rates = rates.map(|(rate, index)| unknown(index, &dependencies.of_rate(rate))).collect::<String>();
    let initial = of_kind(|kind| matches!(kind, Kind::State(_, true) | Kind::Rate(_) | Kind::Output));
    let initial = initial.map(|index| format!("      <Unknown index=\"{}\"/>\n", index + 1));
    let element = |name: &str, content: String| match content.is_empty() {
        true => String::new(),
        false => format!("    <{name}>\n{content}    </{name}>\n"),
    };
    format!(
        "  <ModelStructure>\n{}{}{}  </ModelStructure>\n",
        element("Outputs", outputs),
        element("Derivatives", rates),
        element("InitialUnknowns", initial.collect())
    )
}

/// Returns a text as the value of an attribute.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
