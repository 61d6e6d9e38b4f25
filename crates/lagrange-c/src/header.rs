//! The header of a module.

use lagrange_core::pipeline::Programs;

use crate::arrays::arrays;
use crate::functions::Function;
use crate::names::with_unit;

/// The arguments of all functions.
pub(crate) const ARGUMENTS: &str = "double t, const double *y, const double *p, double *out";

/// Returns the text of the header.
pub(crate) fn header(name: &str, programs: &Programs, functions: &[Function<'_>]) -> String {
    let upper = name.to_uppercase();
    let arrays = arrays(programs);
    let arrays =
        arrays.iter().map(|array| format!("// {}\nextern {};\n", array.docs, array.declaration(name)));
    let declared = functions.iter().map(|function| declaration(name, function));
    format!(
        "// {}, written by lagrange {}.\n\
         //\n\
         // All functions have the signature (double t, const double *y, const double *p, double *out):\n\
         // the time in seconds, the state, parameters followed by inputs, and the results.\n\
         // Numbers are in coherent SI units.\n\
         {}\
         //\n\
         // Sides of switches are those of the state. Accelerations and multipliers are not finite where\n\
         // elimination in a fixed order divides by zero or loses too many digits.\n\
         \n#ifndef {upper}_H\n#define {upper}_H\n\n{}\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n{}{}{}\
         \n#ifdef __cplusplus\n}}\n#endif\n\n#endif\n",
        programs.name,
        env!("CARGO_PKG_VERSION"),
        arguments(programs),
        sizes(&upper, programs),
        arrays.collect::<String>(),
        declared.collect::<String>(),
        normalise(name, programs),
    )
}

/// Returns comments on the entries of the state and of the parameters.
fn arguments(programs: &Programs) -> String {
    let variables = &programs.variables;
    let listed = |array: &str, names: &[String]| {
        let line = |(index, name): (usize, &String)| {
            format!("//     {array}[{index}] {}\n", with_unit(variables, name))
        };
        names.iter().enumerate().map(line).collect::<String>()
    };
    format!("//\n{}{}", listed("y", &variables.state_names()), listed("p", &variables.fields))
}

fn sizes(upper: &str, programs: &Programs) -> String {
    let (layout, variables) = (&programs.layout, &programs.variables);
    let sizes = [
        ("POSITIONS", layout.positions),
        ("VELOCITIES", layout.velocities),
        ("STATES", layout.positions + layout.velocities),
        ("PARAMETERS", layout.parameters),
        ("INPUTS", layout.inputs),
        ("OUTPUTS", variables.outputs.iter().map(Vec::len).sum()),
        ("EVENTS", variables.events.len()),
        ("CONSTRAINTS", layout.multipliers),
        ("SWITCHES", layout.sides),
        ("CLOCKS", programs.clocks.len()),
    ];
    sizes.map(|(what, count)| format!("#define {upper}_{what} {count}\n")).concat()
}

fn declaration(name: &str, function: &Function<'_>) -> String {
    let docs = function.docs.iter().map(|line| format!("// {line}\n")).collect::<String>();
    let shape = function.shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
    format!("\n{docs}// Shape of out: {shape}.\n{};\n", signature(name, function))
}

/// Returns the head of a function.
pub(crate) fn signature(name: &str, function: &Function<'_>) -> String {
    format!("void {name}_{}({ARGUMENTS})", function.name)
}

fn normalise(name: &str, programs: &Programs) -> String {
    match programs.variables.quaternions[..] {
        [] => String::new(),
        _ => format!(
            "\n// Brings the quaternions of a state to length one.\nvoid {name}_normalise(double *y);\n"
        ),
    }
}
