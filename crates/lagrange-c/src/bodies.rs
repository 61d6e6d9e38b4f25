//! Bodies of functions of the state.

use lagrange_core::code::{Surroundings, Target, Unrepresentable, statements};
use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Place, Programs};
use lagrange_core::program::{Op, Program};
use lagrange_core::symbol::Role;

use crate::callables::Callables;
use crate::functions::{Function, Part};

/// Returns the statements of a function's body. In C, sides of switches follow from the state;
/// scripts receive them after the inputs.
pub(crate) fn body(
    name: &str,
    programs: &Programs,
    callables: &Callables<'_>,
    function: &Function<'_>,
) -> Result<String, Unrepresentable> {
    let mut out = preparation(name, programs, callables.target, function);
    let state = State { programs, callables, takes_residuals: function.takes_residuals };
    let mut first = 0;
    for part in &function.parts {
        out += &written(part, first, &state)?;
        first += part.count;
    }
    Ok(out)
}

/// Computes the additional arguments of programs: sides, accelerations and multipliers.
fn preparation(name: &str, programs: &Programs, target: Target, function: &Function<'_>) -> String {
    let layout = &programs.layout;
    let takes = |has: fn(Role) -> bool| function.parts.iter().any(|part| takes(part.program, has));
    let array = |what: &str, count: usize| {
        format!("    {}\n    {name}_{what}(t, y, p, {what});\n", target.array(what, count))
    };
    let mut out = String::new();
    if target != Target::JavaScript && takes(|role| matches!(role, Role::Side(_))) {
        let (count, sign) = (layout.sides, target.call("sign", "switches[i]"));
        out += &array("switches", count);
        out += &format!("    {}\n        switches[i] = {sign};\n", target.repeat(count));
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

/// Returns statements that store the results of a part from index `first` on.
fn written(part: &Part<'_>, first: usize, state: &State<'_>) -> Result<String, Unrepresentable> {
    if part.count == 0 {
        // C has no empty arrays.
        return Ok(String::new());
    }
    let (program, values) = (part.program, part.program.outputs().len());
    let target = state.callables.target;
    if first == 0 && part.count == values {
        return statements(program, target, state, "out");
    }
    let all = statements(program, target, state, "values")?;
    let copied = match guard(part) {
        Some(guard) => format!("{guard} ? values[i] : {}", target.nan()),
        None => "values[i]".to_owned(),
    };
    let copied = format!("    {}\n        out[{first} + i] = {copied};\n", target.repeat(part.count));
    Ok(format!("    {{\n    {}\n{all}{copied}    }}\n", target.array("values", values)))
}

/// Returns the condition under which the digits of results can be trusted: rounding errors grow by
/// less than ε^(−5/8), as in emitted code.
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
    /// True if residuals are passed in place of multipliers.
    takes_residuals: bool,
}

impl Surroundings for State<'_> {
    fn place(&self, role: Role) -> String {
        let is_script = self.callables.target == Target::JavaScript;
        match role {
            Role::Side(index) if !is_script => return format!("switches[{index}]"),
            Role::Acceleration(index) => return format!("accelerations[{index}]"),
            Role::Multiplier(_) if self.takes_residuals && is_script => {}
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
