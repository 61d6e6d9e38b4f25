//! Messages about functions that a declaration defines.

use crate::syntax::ast::FunctionDefinition;

pub(super) const FIRST_DECLARED: &str = "first declared here";
pub(super) const OTHER_NAME_HELP: &str = "choose another name";
pub(super) const DEFINED_HERE: &str = "defined here";
pub(super) const ORDER_HELP: &str = "define it earlier; a function cannot call itself";
pub(super) const NEVER_CALLED_HELP: &str = "call it, or remove it";
pub(super) const UNUSED_PARAMETER_HELP: &str = "remove it, or begin its name with `_`";
pub(super) const DECLARE_HELP: &str = "declare it, or make it a parameter of the function";
pub(super) const TOO_LONG_HELP: &str = "name repeated expressions with `let name = e;`";

pub(super) fn declared_twice(name: &str) -> String {
    format!("the name `{name}` is declared twice")
}

pub(super) fn wrong_count(name: &str, wanted: usize, given: usize) -> String {
    let arguments = if wanted == 1 { "argument" } else { "arguments" };
    format!("`{name}` takes {wanted} {arguments}, not {given}")
}

pub(super) fn usage(function: &FunctionDefinition) -> String {
    let parameters: Vec<&str> = function.parameters.iter().map(|parameter| parameter.text.as_str()).collect();
    format!("write `{}({})`", function.name.text, parameters.join(", "))
}

pub(super) fn called_too_early(name: &str) -> String {
    format!("`{name}` is called before it is defined")
}

pub(super) fn too_long(name: &str, most: u64) -> String {
    format!("with this call of `{name}`, calls expand to more than {most} terms")
}

pub(super) fn unused_parameter(name: &str) -> String {
    format!("the parameter `{name}` is never used, so neither are its arguments")
}

pub(super) fn never_called(name: &str) -> String {
    format!("the function `{name}` is never called")
}

pub(super) fn unknown_name(name: &str) -> String {
    format!("unknown name `{name}`")
}

pub(super) fn did_you_mean(name: &str) -> String {
    format!("did you mean `{name}`?")
}
