//! The functions of a module: their content and order.

use lagrange_core::model::ProductArguments;
use lagrange_core::pipeline::{Programs, Reaction};
use lagrange_core::program::Program;

use crate::names::with_unit;

/// A function of a module.
pub(crate) struct Function<'a> {
    /// Name after the prefix.
    pub(crate) name: String,
    /// Documentation, followed by the meaning of the results.
    pub(crate) docs: Vec<String>,
    /// Rows and columns of the results, or their number.
    pub(crate) shape: Vec<usize>,
    /// Programs whose results are stored in order.
    pub(crate) parts: Vec<Part<'a>>,
    /// True if residuals of the constraints follow the inputs.
    pub(crate) takes_residuals: bool,
}

/// The results of a program, or its first few results.
pub(crate) struct Part<'a> {
    pub(crate) program: &'a Program,
    /// Number of results.
    pub(crate) count: usize,
    /// Number of final values of the program that must be small: the growth of rounding errors.
    pub(crate) growths: usize,
}

impl<'a> Part<'a> {
    fn of(program: &'a Program) -> Part<'a> {
        Part { program, count: program.outputs().len(), growths: 0 }
    }
}

/// Returns the functions of a system, without those that have no results.
pub(crate) fn functions(programs: &Programs) -> Vec<Function<'_>> {
    let mut functions = of_motion(programs);
    functions.extend(of_products(programs));
    functions.extend(of_constraints(programs));
    functions.extend(of_ports(programs));
    functions.extend(of_changes(programs));
    functions.retain(|function| function.shape.iter().all(|extent| *extent > 0));
    functions
}

fn function<'a>(name: &str, docs: &[&str], parts: Vec<Part<'a>>) -> Function<'a> {
    let docs = docs.iter().map(|line| (*line).to_owned()).collect();
    let shape = vec![parts.iter().map(|part| part.count).sum()];
    Function { name: name.to_owned(), docs, shape, parts, takes_residuals: false }
}

fn of_motion(programs: &Programs) -> Vec<Function<'_>> {
    let (layout, growths) = (&programs.layout, programs.growths);
    let rates = || Part::of(&programs.position_rates);
    let accelerations = || Part { program: &programs.accelerations, count: layout.velocities, growths };
    let multipliers = Part { program: &programs.multipliers, count: layout.multipliers, growths };
    let states = layout.positions + layout.velocities;
    let jacobian = function(
        "jacobian",
        &[
            "Derivatives of the rates with respect to the state, in rows: entry [i][j] is that of rate i by y[j].",
        ],
        programs.jacobian.iter().map(Part::of).collect(),
    );
    let is_derived = programs.jacobian.is_some();
    let jacobian = Function { shape: if is_derived { vec![states; 2] } else { vec![0] }, ..jacobian };
    let linearised = function(
        "linearised",
        &["Derivatives of the rates, then of the outputs, by the state, then by the inputs, in rows."],
        programs.linearised.iter().map(Part::of).collect(),
    );
    let columns = states + layout.inputs;
    let linearised = Function { shape: vec![linearised.shape[0] / columns.max(1), columns], ..linearised };
    vec![
        function(
            "rhs",
            &["Rates of the state: of the positions, then accelerations. Units are those of y per second."],
            vec![rates(), accelerations()],
        ),
        function("position_rates", &["Rates of the positions."], vec![rates()]),
        function("accelerations", &["Accelerations, in the order of the velocities."], vec![accelerations()]),
        function("multipliers", &["Multipliers of the constraints, in their order."], vec![multipliers]),
        jacobian,
        linearised,
    ]
}

/// Returns the functions of products that depend only on the state.
fn of_products(programs: &Programs) -> Vec<Function<'_>> {
    let known = programs.products.iter().filter(|(product, _)| !product.is_derivative());
    let written = known.filter_map(|(product, program)| {
        let method = product.row().method.as_ref()?;
        if method.arguments == ProductArguments::Motion {
            return None;
        }
        let unit = method.unit.filter(|_| !programs.variables.units.is_empty());
        let unit = unit.map(|unit| unit.sentence(method.returns));
        let docs = method.docs.iter().map(|line| line.replace('`', "")).chain(unit).collect();
        let shape = programs.layout.shape_of(method.returns, program.outputs().len());
        let parts = vec![Part::of(program)];
        Some(Function { name: product.name().to_owned(), docs, shape, parts, takes_residuals: false })
    });
    written.collect()
}

/// Returns the functions that project states onto the constraints.
fn of_constraints(programs: &Programs) -> Vec<Function<'_>> {
    let (growths, layout) = (programs.growths, &programs.layout);
    let is_constrained = layout.multipliers > 0;
    let residuals = is_constrained.then(|| Part::of(&programs.position_residuals));
    let residuals = function(
        "position_residuals",
        &["Residuals of the constraints on positions; zero for others."],
        residuals.into_iter().collect(),
    );
    let part = Part { program: &programs.correction, count: layout.velocities, growths };
    let correction = function(
        "correction",
        &[
            "The least change of velocities, or of positions, measured by the mass matrix, that removes",
            "residuals of the constraints to first order. These stand behind the inputs in p.",
        ],
        is_constrained.then_some(part).into_iter().collect(),
    );
    vec![residuals, Function { takes_residuals: true, ..correction }]
}

fn of_ports(programs: &Programs) -> Vec<Function<'_>> {
    let mut outputs = function(
        "outputs",
        &["Outputs:"],
        programs.outputs.iter().map(|(_, program)| Part::of(program)).collect(),
    );
    outputs.docs.extend(listed(programs, programs.variables.outputs.concat().iter()));
    let start = &["The declared state at the start; zero where nothing is declared. t and y are not read."];
    vec![outputs, function("start", start, programs.start.iter().map(Part::of).collect())]
}

/// Returns the function that places drawn items.
pub(crate) fn of_drawing(programs: &Programs) -> Option<Function<'_>> {
    let drawing = programs.drawing.as_ref()?;
    Some(function("drawing", &["The numbers of all that is drawn."], vec![Part::of(&drawing.program)]))
}

/// Returns the functions of events, switches and clocks.
fn of_changes(programs: &Programs) -> Vec<Function<'_>> {
    let variables = &programs.variables;
    let mut events = function(
        "events",
        &["Functions whose zeros are the events:"],
        vec![Part::of(&programs.event_functions)],
    );
    events.docs.extend(listed(programs, variables.events.iter().map(|event| &event.name)));
    let mut switches = function(
        "switches",
        &["Functions at whose zeros the rates have kinks or jumps:"],
        vec![Part::of(&programs.switches)],
    );
    switches.docs.extend(listed(programs, variables.switches.iter()));
    let after_events = programs.reactions.iter().zip(&variables.events).enumerate();
    let after_events = after_events.filter_map(|(index, (reaction, event))| match reaction {
        Reaction::Replace(program) => {
            let docs = format!("The state after the event {}.", event.name);
            Some(function(&format!("after_event_{index}"), &[&docs], vec![Part::of(program)]))
        }
        _ => None,
    });
    let clocks = programs.clocks.iter();
    let periods = clocks.clone().map(|clock| Part::of(&clock.period)).collect();
    let after_clocks = clocks.enumerate().map(|(index, clock)| {
        let name = format!("after_clock_{index}");
        function(&name, &["The state after a tick of this clock."], vec![Part::of(&clock.after)])
    });
    let periods = function("clock_periods", &["Periods of the clocks, in seconds."], periods);
    [events, switches, periods].into_iter().chain(after_events).chain(after_clocks).collect()
}

/// Returns a line for each of these names.
fn listed<'a>(programs: &Programs, names: impl Iterator<Item = &'a String>) -> Vec<String> {
    let line = |(index, name): (usize, &String)| {
        format!("    out[{index}] {}", with_unit(&programs.variables, name))
    };
    names.enumerate().map(line).collect()
}
