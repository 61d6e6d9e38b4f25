//! Systems as JavaScript functions.

use lagrange_core::code::{SCRIPT_PRELUDE, Target, Unrepresentable};
use lagrange_core::pipeline::Programs;

use crate::bodies::body;
use crate::callables::Callables;
use crate::functions::{Function, functions, of_drawing};
use crate::header::ARGUMENTS;
use crate::refusal::{self, Refusal};
use crate::syntax::head;

/// The prefix of all functions.
const PREFIX: &str = "system";

/// JavaScript functions: those of the C module, under names such as `system_rhs`, and
/// `system_drawing` if a drawing is requested.
///
/// `p` holds parameters, inputs, then the sides of the switches: 1 or −1, fixed by the caller. For
/// functions with residuals of constraints, the residuals follow the sides.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Script {
    /// Self-contained text.
    pub text: String,
    /// Names of the functions, without the prefix `system_`.
    pub functions: Vec<String>,
}

impl Script {
    /// Writes the requested functions of a system, and the functions that they call.
    ///
    /// # Errors
    /// If the system has parts that only compiled Rust can run, or a constant is too large.
    pub fn new(programs: &Programs, is_wanted: impl Fn(&str) -> bool) -> Result<Script, Refusal> {
        refusal::check(programs)?;
        let refused = |error: Unrepresentable| Refusal::Constants(error.constants);
        let mut functions = functions(programs);
        functions.extend(of_drawing(programs));
        let callables = Callables::new(programs, &functions, Target::JavaScript);
        let written = |function: &Function<'_>| {
            let body = body(PREFIX, programs, &callables, function).map_err(refused)?;
            let head = head(Target::JavaScript, "", &format!("{PREFIX}_{}", function.name), ARGUMENTS);
            Ok(format!("\n// {}\n{head}\n{{\n{body}}}\n", function.docs.join("\n// ")))
        };
        let (mut text, mut names) =
            (SCRIPT_PRELUDE.to_owned() + &callables.definitions().map_err(refused)?, Vec::new());
        // Other functions call those of accelerations and multipliers, which precede them.
        for function in functions.iter().rev() {
            let is_called = text.contains(&format!(" {PREFIX}_{}(t, y, p, ", function.name));
            if is_wanted(&function.name) || is_called {
                text += &written(function)?;
                names.insert(0, function.name.clone());
            }
        }
        Ok(Script { text, functions: names })
    }
}
