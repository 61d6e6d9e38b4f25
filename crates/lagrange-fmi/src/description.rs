//! The XML description of a unit.

use std::collections::BTreeSet;

use lagrange_core::model::EntryLimits;
use lagrange_core::pipeline::{Programs, Reaction};

use crate::dependencies::Dependencies;
use crate::quantities::Definitions;
use crate::variables::{Kind, Variable};
use crate::version::Version;

/// The header data of a description.
pub(crate) struct Heading<'a> {
    pub(crate) version: Version,
    /// Name of the library.
    pub(crate) identifier: &'a str,
    pub(crate) guid: &'a str,
    /// Default tolerance of runs.
    pub(crate) tolerance: f64,
    /// Source files to compile.
    pub(crate) sources: Vec<&'a str>,
}

/// Writes the description.
pub(crate) fn description(
    programs: &Programs,
    heading: &Heading<'_>,
    variables: &[Variable],
    units: &Definitions,
) -> String {
    let version = heading.version;
    let (token, indicators) = match version {
        Version::Two => {
            let count = variables.iter().filter(|variable| variable.kind == Kind::Indicator).count();
            ("guid", format!(" numberOfEventIndicators=\"{count}\""))
        }
        Version::Three => ("instantiationToken", String::new()),
    };
    let jumps = has_jumps(programs);
    let listed =
        variables.iter().enumerate().map(|(index, variable)| written((version, jumps), index, variable));
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"{}\" modelName=\"{}\" {token}=\"{}\"\n    \
         generationTool=\"lagrange {}\" variableNamingConvention=\"{}\"{indicators}>\n\
         {}{}\
         \x20 <LogCategories>\n    <Category name=\"logEvents\"/>\n    <Category name=\"logStatusError\"/>\n  \
         </LogCategories>\n\
         \x20 <DefaultExperiment startTime=\"0\" stopTime=\"10\" tolerance=\"{:e}\"/>\n\
         \x20 <ModelVariables>\n{}  </ModelVariables>\n\
         {}</fmiModelDescription>\n",
        version.number(),
        escaped(&programs.name),
        heading.guid,
        env!("CARGO_PKG_VERSION"),
        convention(variables),
        kinds(programs, heading),
        units.written(),
        heading.tolerance,
        listed.collect::<String>(),
        structure(version, &Dependencies::new(programs), variables),
    )
}

/// Returns the elements of model exchange and of co-simulation.
fn kinds(programs: &Programs, heading: &Heading<'_>) -> String {
    let has_derivatives = programs.linearised.is_some();
    let (provided, content) = match heading.version {
        Version::Two => (
            format!(
                "canGetAndSetFMUstate=\"true\" canSerializeFMUstate=\"true\"\n      \
                 providesDirectionalDerivative=\"{has_derivatives}\""
            ),
            format!("    <SourceFiles>\n{}    </SourceFiles>\n  ", files("File", &heading.sources)),
        ),
        Version::Three => (
            format!(
                "canGetAndSetFMUState=\"true\" canSerializeFMUState=\"true\"\n      \
                 providesDirectionalDerivatives=\"{has_derivatives}\" \
                 providesAdjointDerivatives=\"{has_derivatives}\""
            ),
            String::new(),
        ),
    };
    let element = |name: &str, more: &str| {
        format!(
            "  <{name} modelIdentifier=\"{}\" {provided}{more}>\n{content}</{name}>\n",
            heading.identifier
        )
    };
    let event_mode = match heading.version {
        Version::Two => "",
        Version::Three => " hasEventMode=\"true\"",
    };
    let steps = format!("\n      canHandleVariableCommunicationStepSize=\"true\"{event_mode}");
    element("ModelExchange", "") + &element("CoSimulation", &steps)
}

fn files(element: &str, sources: &[&str]) -> String {
    sources.iter().map(|file| format!("      <{element} name=\"{file}\"/>\n")).collect()
}

/// Returns the build description, a separate file since version 3.0.
pub(crate) fn build(version: Version, identifier: &str, sources: &[&str]) -> Option<String> {
    let text = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<fmiBuildDescription fmiVersion=\"3.0\">\n  \
         <BuildConfiguration modelIdentifier=\"{identifier}\">\n    <SourceFileSet language=\"C99\">\n{}    \
         </SourceFileSet>\n  </BuildConfiguration>\n</fmiBuildDescription>\n",
        files("SourceFile", sources)
    );
    (version == Version::Three).then_some(text)
}

/// Returns `structured` if all names have the required form.
fn convention(variables: &[Variable]) -> &'static str {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_.[](,)".contains(c);
    match variables.iter().all(|variable| variable.name.chars().all(is_plain)) {
        true => "structured",
        false => "flat",
    }
}

/// True if events or ticks of clocks replace the state.
fn has_jumps(programs: &Programs) -> bool {
    let replaces = |reaction: &Reaction| matches!(reaction, Reaction::Replace(_));
    !programs.clocks.is_empty() || programs.reactions.iter().any(replaces)
}

/// Returns the element of a variable. Importers reinitialise states only if the state `jumps`.
fn written((version, jumps): (Version, bool), reference: usize, variable: &Variable) -> String {
    let state = |value, EntryLimits { bounds, nominal }: EntryLimits| {
        let least_and_most = attributes(bounds.map(|bound| Some(bound?.0)));
        let nominal = nominal.map(|nominal| format!(" nominal=\"{nominal:?}\"")).unwrap_or_default();
        let reinit = if jumps { " reinit=\"true\"" } else { "" };
        format!("{least_and_most}{nominal}{}{reinit}", start(value))
    };
    let (role, value) = match variable.kind {
        Kind::State(value, false, limits) => ("causality=\"local\" initial=\"exact\"", state(value, limits)),
        Kind::State(value, true, limits) => ("causality=\"local\" initial=\"approx\"", state(value, limits)),
        Kind::Rate(state) => (
            "causality=\"local\" initial=\"calculated\"",
            format!(" derivative=\"{}\"", number(version, state)),
        ),
        Kind::Parameter(value, bounds) => (
            "causality=\"parameter\" variability=\"tunable\" initial=\"exact\"",
            format!("{}{}", attributes(bounds), start(value)),
        ),
        Kind::Input(value) => ("causality=\"input\"", start(value)),
        Kind::Output => ("causality=\"output\" initial=\"calculated\"", String::new()),
        Kind::Indicator => ("causality=\"local\" initial=\"calculated\"", String::new()),
        Kind::Time => ("causality=\"independent\" variability=\"continuous\"", String::new()),
    };
    let unit = variable.unit.as_ref().map_or_else(String::new, |unit| format!(" unit=\"{unit}\""));
    let head = format!("name=\"{}\" valueReference=\"{reference}\" {role}", escaped(&variable.name));
    match version {
        Version::Two => format!(
            "    <!-- {} -->\n    <ScalarVariable {head}>\n      <Real{unit}{value}/>\n    </ScalarVariable>\n",
            reference + 1
        ),
        Version::Three => format!("    <Float64 {head}\n      {}/>\n", format!("{unit}{value}").trim_start()),
    }
}

/// Returns attributes with the bounds of a variable.
fn attributes(bounds: [Option<f64>; 2]) -> String {
    let bounds = bounds.into_iter().zip(["min", "max"]);
    bounds.filter_map(|(bound, name)| Some(format!(" {name}=\"{:?}\"", bound?))).collect()
}

fn start(value: f64) -> String {
    format!(" start=\"{value:?}\"")
}

/// Returns the number by which other elements refer to a variable: its one-based index, or since
/// version 3.0 its value reference.
fn number(version: Version, reference: usize) -> usize {
    match version {
        Version::Two => reference + 1,
        Version::Three => reference,
    }
}

/// Returns the order of outputs, rates, initial unknowns and indicators, with their dependencies.
fn structure(version: Version, dependencies: &Dependencies<'_>, variables: &[Variable]) -> String {
    let of_kind = |wanted: fn(Kind) -> bool| {
        let all = variables.iter().enumerate();
        all.filter(move |(_, variable)| wanted(variable.kind)).map(|(reference, _)| reference)
    };
    let states = of_kind(|kind| matches!(kind, Kind::State(..))).count();
    let reference = |place: usize| if place < states { place } else { place + states };
    let is_known =
        |place: &usize| matches!(variables[reference(*place)].kind, Kind::State(..) | Kind::Input(_));
    let known = |places: BTreeSet<usize>| {
        let known = places.iter().filter(|place| is_known(place));
        Some(known.map(|place| number(version, reference(*place))).collect::<Vec<_>>())
    };
    let outputs = of_kind(|kind| kind == Kind::Output).zip(dependencies.of_outputs().into_iter().map(known));
    let rates = of_kind(|kind| matches!(kind, Kind::Rate(_))).enumerate();
    let rates = rates.map(|(rate, reference)| (reference, known(dependencies.of_rate(rate))));
    let initial = of_kind(|kind| matches!(kind, Kind::State(_, true, _) | Kind::Rate(_) | Kind::Output));
    let indicators = of_kind(|kind| kind == Kind::Indicator);
    let lists = [
        ("Outputs", "Output", outputs.collect::<Unknowns>()),
        ("Derivatives", "ContinuousStateDerivative", rates.collect()),
        ("InitialUnknowns", "InitialUnknown", initial.map(|reference| (reference, None)).collect()),
        ("", "EventIndicator", indicators.map(|reference| (reference, None)).collect()),
    ];
    let lists = lists.iter().map(|(list, element, unknowns)| match version {
        Version::Two => nested(list, unknowns),
        Version::Three => elements(&format!("<{element} valueReference"), version, unknowns),
    });
    format!("  <ModelStructure>\n{}  </ModelStructure>\n", lists.collect::<String>())
}

/// Value references of unknowns, with the numbers of their dependencies.
type Unknowns = Vec<(usize, Option<Vec<usize>>)>;

/// Returns a list in its own element, as in version 2.0; empty without a name or unknowns.
fn nested(list: &str, unknowns: &Unknowns) -> String {
    match list.is_empty() || unknowns.is_empty() {
        true => String::new(),
        false => {
            let unknowns = elements("  <Unknown index", Version::Two, unknowns);
            format!("    <{list}>\n{unknowns}    </{list}>\n")
        }
    }
}

/// Returns the elements of unknowns, which have a common prefix.
fn elements(head: &str, version: Version, unknowns: &Unknowns) -> String {
    let element = |(reference, known): &(usize, Option<Vec<usize>>)| {
        let known = known.as_ref().map_or_else(String::new, |known| {
            let known = known.iter().map(usize::to_string).collect::<Vec<_>>().join(" ");
            format!(" dependencies=\"{known}\"")
        });
        format!("    {head}=\"{}\"{known}/>\n", number(version, *reference))
    };
    unknowns.iter().map(element).collect()
}

/// Escapes a text as the value of an attribute.
pub(crate) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;")
}
