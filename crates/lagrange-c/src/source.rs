//! The source file of a module.

use lagrange_core::code::{Precision, Target, Unrepresentable, prelude};
use lagrange_core::pipeline::Programs;

use crate::arrays::arrays;
use crate::bodies::body;
use crate::callables::Callables;
use crate::functions::Function;
use crate::header::signature;
use crate::refusal::Refusal;

/// Returns the text of the source file.
pub(crate) fn source(
    name: &str,
    stem: &str,
    programs: &Programs,
    functions: &[Function<'_>],
) -> Result<String, Refusal> {
    let refused = |error: Unrepresentable| Refusal::Constants(error.constants);
    let callables = Callables::new(programs, functions, Target::C(Precision::Double));
    let mut out = format!("#include \"{stem}.h\"\n\n{}\n", prelude(Precision::Double));
    for array in arrays(programs) {
        out += &array.definition(name);
    }
    out += &callables.definitions().map_err(refused)?;
    for function in functions {
        let body = body(name, programs, &callables, function).map_err(refused)?;
        out += &format!("\n{}\n{{\n    (void)t, (void)y, (void)p;\n{body}}}\n", signature(name, function));
    }
    out += &normalise(name, programs);
    Ok(out)
}

fn normalise(name: &str, programs: &Programs) -> String {
    let quaternions = programs.variables.quaternions.iter();
    let statements = quaternions.map(|first| {
        let [w, x, y, z] = [0, 1, 2, 3].map(|part| format!("y[{}]", first + part));
        let length = format!("LAGRANGE_HYPOT(LAGRANGE_HYPOT({w}, {x}), LAGRANGE_HYPOT({y}, {z}))");
        let divisions = [w, x, y, z].map(|part| format!("        {part} /= length;\n")).concat();
        format!("    {{\n        const double length = {length};\n{divisions}    }}\n")
    });
    match statements.collect::<String>() {
        none if none.is_empty() => none,
        statements => format!("\nvoid {name}_normalise(double *y)\n{{\n{statements}}}\n"),
    }
}
