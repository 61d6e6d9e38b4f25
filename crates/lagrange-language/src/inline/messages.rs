//! Messages about user-defined functions.

use crate::syntax::ast::FunctionDefinition;
use lagrange_expr::diagnostics::messages;

messages! {
    pub(super):

    FIRST_DECLARED = "first declared here";
    OTHER_NAME_HELP = "choose another name";
    DEFINED_HERE = "defined here";
    ORDER_HELP = "define it earlier; a function cannot call itself";
    NEVER_CALLED_HELP = "call it, or remove it";
    UNUSED_PARAMETER_HELP = "remove it, or begin its name with `_`";
    DECLARE_HELP = "declare it, or make it a parameter of the function";
    TOO_LONG_HELP = "name repeated expressions with `let name = e;`";
    declared_twice(name) = "the name `{name}` is declared twice";
    called_too_early(name) = "`{name}` is called before it is defined";
    too_long(name, most) = "with this call of `{name}`, calls expand to more than {most} terms";
    unused_parameter(name) = "the parameter `{name}` is never used, so neither are its arguments";
    never_called(name) = "the function `{name}` is never called";
    unknown_name(name) = "unknown name `{name}`";
    did_you_mean(name) = "did you mean `{name}`?";
}

pub(super) fn wrong_count(name: &str, wanted: usize, given: usize) -> String {
    let arguments = if wanted == 1 { "argument" } else { "arguments" };
    format!("`{name}` takes {wanted} {arguments}, not {given}")
}

pub(super) fn usage(function: &FunctionDefinition) -> String {
    let parameters: Vec<&str> = function.parameters.iter().map(|parameter| parameter.text.as_str()).collect();
    format!("write `{}({})`", function.name.text, parameters.join(", "))
}
