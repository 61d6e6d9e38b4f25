//! Bodies of functions of the state.

use lagrange_core::code::{Precision, Surroundings, Unrepresentable, statements};
use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Place, Programs};
use lagrange_core::program::{Op, Program};
use lagrange_core::symbol::Role;

use crate::callables::Callables;
use crate::functions::{Function, Part};

/// Statements of the body of a function.
pub(crate) fn body(
    name: &str,
    programs: &Programs,
    callables: &Callables<'_>,
    function: &Function<'_>,
) -> Result<String, Unrepresentable> {
    let mut out = preparation(name, programs, function);
    let state = State { programs, callables, takes_residuals: function.takes_residuals };
    let mut first = 0;
    for part in &function.parts {
        out += &written(part, first, &state)?;
        first += part.count;
    }
    Ok(out)
}

/// Computes what programs take beside the state: sides, accelerations and multipliers.
fn preparation(name: &str, programs: &Programs, function: &Function<'_>) -> String {
    let layout = &programs.layout;
    let takes = |has: fn(Role) -> bool| function.parts.iter().any(|part| takes(part.program, has));
    let array = |what: &str, count: usize| {
        format!("    double {what}[{count}];\n    {name}_{what}(t, y, p, {what});\n")
    };
    let mut out = String::new();
    if takes(|role| matches!(role, Role::Side(_))) {
        let count = layout.sides;
        out += &array("switches", count);
        out += &format!(
            "    for (int i = 0; i < {count}; i++)\n        switches[i] = LAGRANGE_SIGN(switches[i]);\n"
        );
    }
    if takes(|role| matches!(role, Role::Acceleration(_))) {
        out += &array("accelerations", layout.velocities);
    }
    if !function.takes_residuals && takes(|role| matches!(role, Role::Multiplier(_))) {
        out += &array("multipliers", layout.multipliers);
    }
    out
}

fn takes(program: &Program, has: fn(Role) -> bool) -> bool {
    program.values().any(|(_, op)| matches!(op, Op::Input(role) if has(*role)))
}

/// Statements that store the results of a part from a place on.
fn written(part: &Part<'_>, first: usize, state: &State<'_>) -> Result<String, Unrepresentable> {
    if part.count == 0 {
        // C has no arrays without entries.
        return Ok(String::new());
    }
    let (program, values) = (part.program, part.program.outputs().len());
    if first == 0 && part.count == values {
        return statements(program, Precision::Double, state, "out");
    }
    let all = statements(program, Precision::Double, state, "values")?;
    let copied = format!(
        "    for (int i = 0; i < {}; i++)\n        out[{first} + i] = {};\n",
        part.count,
        match guard(part) {
            Some(guard) => format!("{guard} ? values[i] : NAN"),
            None => "values[i]".to_owned(),
        }
    );
    Ok(format!("    {{\n    double values[{values}];\n{all}{copied}    }}\n"))
}

/// The condition under which the digits of results can be trusted: rounding errors grow by less
/// than ε^(−5/8), as in emitted code.
fn guard(part: &Part<'_>) -> Option<String> {
    let values = part.program.outputs().len();
    let limit = f64::EPSILON.powf(0.625);
    let is_small = |index: usize| format!("values[{index}] * {limit:?} < 1.0");
    let conditions = (values - part.growths..values).map(is_small).collect::<Vec<_>>();
    (!conditions.is_empty()).then(|| conditions.join(" && "))
}

/// The arguments of functions of the state.
struct State<'a> {
    programs: &'a Programs,
    callables: &'a Callables<'a>,
    /// True if residuals take the places of multipliers.
    takes_residuals: bool,
}

impl Surroundings for State<'_> {
    fn place(&self, role: Role) -> String {
        match role {
            Role::Side(index) => return format!("switches[{index}]"),
            Role::Acceleration(index) => return format!("accelerations[{index}]"),
            Role::Multiplier(index) if self.takes_residuals => {
                return format!("p[{}]", self.programs.layout.fields() + index as usize);
            }
            Role::Multiplier(index) => return format!("multipliers[{index}]"),
            _ => {}
        }
        match self.programs.layout.place(role) {
            Some(Place::Time) => "t".to_owned(),
            Some(Place::State(index)) => format!("y[{index}]"),
            Some(Place::Parameter(index)) => format!("p[{index}]"),
            None => unreachable!("no program takes {role:?}"),
        }
    }

    fn name(&self, role: Role) -> Option<String> {
        let variables = &self.programs.variables;
        match self.programs.layout.place(role)? {
            Place::Time => None,
            Place::State(index) => variables.state_names().get(index).cloned(),
            Place::Parameter(index) => variables.fields.get(index).cloned(),
        }
    }

    fn call(&self, function: &Opaque, arguments: &[&str]) -> String {
        self.callables.call(function, arguments)
    }
}
