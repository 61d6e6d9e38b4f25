//! The names through which the functions of the standard call the module.

use lagrange_core::pipeline::{Programs, Reaction};
use lagrange_core::syntax::ast::Direction;

use crate::variables::{Kind, Start, Variable};

const SIGNATURE: &str = "(double t, const double *y, const double *p, double *out)";

/// Writes the header between the functions of the standard and the module.
pub(crate) fn binding(
    (name, guid, tolerance): (&str, &str, f64),
    programs: &Programs,
    start: &Start,
    variables: &[Variable],
) -> String {
    format!(
        "// What the functions of the standard know of {}.\n\n#include <math.h>\n\n#include \"model.h\"\n\n\
         #define MODEL \"{name}\"\n#define GUID \"{guid}\"\n#define TOLERANCE {tolerance:e}\n{}\n\
         enum {{ RECORD, STOP, REPLACE }};\n\n{}{}",
        programs.name,
        sizes(programs),
        arrays(programs, start, variables),
        functions(name, programs)
    )
}

fn sizes(programs: &Programs) -> String {
    let (layout, variables) = (&programs.layout, &programs.variables);
    let sizes = [
        ("POSITIONS", layout.positions),
        ("COORDINATES", layout.positions - variables.first_order_states),
        ("STATES", layout.positions + layout.velocities),
        ("PARAMETERS", layout.parameters),
        ("INPUTS", layout.inputs),
        ("OUTPUTS", variables.outputs.iter().map(Vec::len).sum()),
        ("EVENTS", variables.events.len()),
        ("SWITCHES", variables.switches.len()),
        ("CONSTRAINTS", layout.multipliers),
        ("IS_STABILISED", usize::from(variables.is_stabilised)),
        ("CLOCKS", programs.clocks.len()),
        ("HAS_DERIVATIVES", usize::from(programs.linearised.is_some())),
    ];
    sizes.map(|(name, size)| format!("#define {name} {size}\n")).concat()
}

/// Returns an array; an empty one gets a zero, since C has no empty arrays.
fn array(kind: &str, name: &str, values: impl Iterator<Item = String>) -> String {
    let values = values.collect::<Vec<_>>();
    let values = if values.is_empty() { "0".to_owned() } else { values.join(", ") };
    format!("static const {kind}{name}[] = {{ {values} }};\n")
}

fn arrays(programs: &Programs, start: &Start, variables: &[Variable]) -> String {
    let names = variables.iter().map(|variable| format!("\"{}\"", variable.name));
    let events = programs.variables.events.iter().map(|event| format!("\"{}\"", event.name));
    let constraints = programs.variables.constraints.iter().map(|name| format!("\"{name}\""));
    let directions = programs.variables.events.iter().map(|event| match event.direction {
        Direction::Rising => "1",
        Direction::Falling => "-1",
        Direction::Crossing => "0",
    });
    let actions = programs.reactions.iter().map(|reaction| match reaction {
        Reaction::Stop => "STOP",
        Reaction::Replace(_) => "REPLACE",
        Reaction::Record | Reaction::Impact => "RECORD",
    });
    let given = start.state.iter().zip(&start.are_given);
    let starts = given.map(|(value, is_given)| if *is_given { number(*value) } else { number(f64::NAN) });
    let bounds = |side: usize, open: f64| {
        let bound = move |variable: &Variable| match variable.kind {
            Kind::Parameter(_, bounds) => Some(bounds[side].unwrap_or(open)),
            Kind::Input(_) => Some(open),
            _ => None,
        };
        variables.iter().filter_map(bound).map(number)
    };
    let nominals = programs.variables.limits.iter().map(|limits| number(limits.nominal.unwrap_or(1.0)));
    [
        array("char *const ", "names", names),
        array("char *const ", "event_names", events),
        array("char *const ", "constraint_names", constraints),
        array("int ", "directions", directions.map(str::to_owned)),
        array("int ", "actions", actions.map(str::to_owned)),
        array("double ", "defaults", start.fields.iter().copied().map(number)),
        array("double ", "starts", starts),
        array("double ", "nominals", nominals),
        array("double ", "least", bounds(0, f64::NEG_INFINITY)),
        array("double ", "most", bounds(1, f64::INFINITY)),
        array("int ", "excluded", excluded(programs)),
    ]
    .concat()
}

/// Returns the excluded bounds of each field: 1 for the lower, 2 for the upper one.
fn excluded(programs: &Programs) -> impl Iterator<Item = String> {
    let is_excluded = |bound: Option<(f64, bool)>| bound.is_some_and(|(_, is_included)| !is_included);
    let of = move |field: usize| {
        let range = programs.ranges.iter().find(|range| range.parameter == field);
        let [low, high] = range.map_or([false; 2], |range| range.bounds.map(is_excluded));
        (i32::from(low) + 2 * i32::from(high)).to_string()
    };
    (0..programs.layout.fields()).map(of)
}

fn number(value: f64) -> String {
    match value {
        _ if value.is_nan() => "NAN".to_owned(),
        _ if value.is_infinite() => if value > 0.0 { "INFINITY" } else { "-INFINITY" }.to_owned(),
        _ => format!("{value:?}"),
    }
}

/// Returns the functions that exist regardless of the module.
fn functions(name: &str, programs: &Programs) -> String {
    let (variables, events) = (&programs.variables, programs.variables.events.len());
    let call = |exists: bool, function: &str, out: &str| match exists {
        true => format!("    {name}_{function}(t, y, p, {out});\n"),
        false => String::new(),
    };
    let indicators = call(events > 0, "events", "out")
        + &call(!variables.switches.is_empty(), "switches", &format!("out + {events}"));
    let outputs = call(variables.outputs.iter().any(|output| !output.is_empty()), "outputs", "out");
    let start = match programs.start.is_some() {
        true => format!("    {name}_start(0.0, p, p, out);\n"),
        false => "    for (int i = 0; i < STATES; i++)\n        out[i] = 0.0;\n".to_owned(),
    };
    let normalise = match variables.quaternions.is_empty() {
        true => String::new(),
        false => format!("    {name}_normalise(y);\n"),
    };
    let replacing = programs.reactions.iter().enumerate();
    let replacing = replacing.filter(|(_, reaction)| matches!(reaction, Reaction::Replace(_)));
    let replacing = replacing.map(|(index, _)| index).collect::<Vec<_>>();
    let clocks = (0..programs.clocks.len()).collect::<Vec<_>>();
    let linearised = match programs.linearised.is_some() {
        true => function("linearised_of_model", SIGNATURE, &call(true, "linearised", "out")),
        false => String::new(),
    };
    let constraints = programs.layout.multipliers;
    let residuals = call(constraints > 0, "position_residuals", "out")
        + &call(constraints > 0, "constraint_velocity", &format!("out + {constraints}"));
    let correction = call(constraints > 0, "correction", "out");
    [
        function(
            "position_rates_of_model",
            SIGNATURE,
            &call(programs.layout.positions > 0, "position_rates", "out"),
        ),
        function("residuals_of_model", SIGNATURE, &residuals),
        function("correction_of_model", SIGNATURE, &correction),
        function("rates_of_model", SIGNATURE, &call(true, "rhs", "out")),
        function("indicators_of_model", SIGNATURE, &indicators),
        function("outputs_of_model", SIGNATURE, &outputs),
        function("start_of_model", "(const double *p, double *out)", &start),
        function(
            "periods_of_model",
            "(double t, const double *y, const double *p, double *out)",
            &call(!clocks.is_empty(), "clock_periods", "out"),
        ),
        function("normalise_model", "(double *y)", &normalise),
        chosen(name, "after_event", &replacing),
        chosen(name, "after_clock", &clocks),
        linearised,
    ]
    .concat()
}

fn function(name: &str, signature: &str, body: &str) -> String {
    let arguments = signature.trim_matches(['(', ')']).split(", ");
    let names = arguments.filter_map(|argument| argument.rsplit([' ', '*']).next());
    let unused = names.map(|name| format!("(void){name}")).collect::<Vec<_>>().join(", ");
    format!("\nstatic void {name}{signature}\n{{\n    {unused};\n{body}}}\n")
}

/// Returns a function that calls one of several by its index.
fn chosen(name: &str, function_name: &str, indices: &[usize]) -> String {
    let case = |index: &usize| {
        format!("    if (index == {index})\n        {name}_{function_name}_{index}(t, y, p, out);\n")
    };
    let signature = format!("(int index, {}", SIGNATURE.trim_start_matches('('));
    function(&format!("{function_name}_of_model"), &signature, &indices.iter().map(case).collect::<String>())
}
