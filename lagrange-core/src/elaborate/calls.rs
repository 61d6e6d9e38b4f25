//! Function calls of the language: elementary functions, rates, vector operations, energies.

use super::carried::record_rate;
use super::chains::power;
use super::evaluator::Evaluator;
use super::function_names::{arity, function_names, mass_function, usage};
use super::inertia::evaluate_mass_function;
use super::messages;
use super::opaque::{evaluate_callable, evaluate_contact_point};
use super::operand::{Operand, cross, half_square, inner, norm, transposed};
use super::scope::NameKind;
use super::unknown_names::may_use_accelerations;
use lagrange_expr::diagnostics::nearest;
use lagrange_expr::elementary;
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::evaluate;
use lagrange_expr::functions;
use lagrange_language::syntax::ast::AstId;
use lagrange_language::syntax::ast::CONTACT_POINT;
use lagrange_language::syntax::ast::Expression;
use lagrange_language::syntax::ast::Name;
use lagrange_language::syntax::foreign;
use lagrange_language::syntax::print;

pub(super) fn evaluate_call(
    evaluator: &mut Evaluator<'_>,
    name: &Name,
    arguments: &[AstId],
    call: AstId,
) -> Option<Operand> {
    if let Some(function) = mass_function(&name.text) {
        return evaluate_mass_function(evaluator, function, name, arguments, call);
    }
    if let Some(value) = evaluate_callable(evaluator, name, arguments, call) {
        return value;
    }
    if name.text == CONTACT_POINT {
        return evaluate_contact_point(evaluator, arguments);
    }
    let Some(arity) = arity(&name.text) else {
        let is_read = |&id: &AstId| !matches!(evaluator.syntax(id), Expression::Invalid);
        // Advice about a word such as `sum` makes no sense beside a mistake in what it sums.
        let is_unclear = foreign::without_counterpart(&name.text).is_some()
            && arguments.iter().any(|&id| evaluator.value(id).is_none());
        if arguments.iter().all(is_read) && !is_unclear {
            report_no_function(evaluator, name, arguments);
        }
        return None;
    };
    let is_of_any_number = matches!(name.text.as_str(), "min" | "max");
    if arguments.len() != arity && !(is_of_any_number && arguments.len() > arity) {
        let message = messages::names::wrong_argument_count(&name.text, arity, arguments.len());
        let meant = meant_function(evaluator, &name.text, arguments);
        let meant = meant.filter(|meant| is_accepted(evaluator, meant));
        let help = messages::names::write_call(meant.unwrap_or_else(|| usage(&name.text, arity)));
        return evaluator.refuse(call, message, help);
    }
    match name.text.as_str() {
        "dot" | "ddot" => evaluate_rate(evaluator, &name.text, arguments[0], call),
        "delay" => evaluator.refuse(call, messages::delays::PLACE, messages::delays::PLACE_HELP),
        "transpose" => evaluate_transpose(evaluator, arguments[0]),
        "norm" | "inner" | "cross" => evaluate_vector_function(evaluator, &name.text, arguments),
        "kinetic_energy" | "spring_energy" => {
            let weight = evaluator
                .scalar(arguments[0], &format!("the first argument of `{name}`", name = name.text))?;
            let components = evaluator.value(arguments[1])?;
            if name.text == "kinetic_energy" {
                check_mass(evaluator, arguments[0], weight)?;
            }
            Some(Operand::Scalar(half_square(&mut evaluator.graph, weight, components.components())))
        }
        _ => evaluate_elementary(evaluator, &name.text, arguments, call),
    }
}

/// Reports a mass or moment of inertia that is negative for all values of the parameters.
fn check_mass(evaluator: &mut Evaluator<'_>, syntax: AstId, mass: ExprId) -> Option<()> {
    let is_judged = evaluator.graph.dependencies(mass) == Dependencies::NONE
        && !evaluator.obliged_masses.contains(&syntax);
    if !is_judged || evaluate(&evaluator.graph, &[mass], |_| f64::NAN)[0] >= 0.0 {
        return Some(());
    }
    evaluator.refuse(syntax, messages::NEGATIVE_INERTIA, messages::NEGATIVE_INERTIA_HELP)
}

/// Evaluates `dot` or `ddot`. An argument without anything that moves is an error instead of having
/// a zero rate.
fn evaluate_rate(
    evaluator: &mut Evaluator<'_>,
    function: &str,
    argument: AstId,
    call: AstId,
) -> Option<Operand> {
    let value = evaluator.value(argument)?;
    if evaluator.declaration.expressions.is_written(call) && is_at_rest(evaluator, argument) {
        let text = print::expression(&evaluator.declaration.expressions, argument);
        return evaluator.refuse(call, messages::rate_of_constant(&text), messages::RATE_OF_CONSTANT_HELP);
    }
    let rate = evaluator.rate(&value, argument)?;
    record_rate(evaluator, &value, call);
    if function == "dot" {
        return Some(rate);
    }
    let has_input = |value: &Operand| {
        let mut components = value.components().iter();
        components.any(|&c| evaluator.graph.dependencies(c).intersects(Dependencies::INPUT))
    };
    // Inputs can only enter through the equation of a state.
    if has_input(&rate) && !has_input(&value) {
        let (place, name) = evaluator.blame(argument, Dependencies::STATE);
        let error = evaluator.report.error(place, messages::states::second_rate(&name));
        error.help(messages::states::SECOND_RATE_HELP);
        return None;
    }
    evaluator.rate(&rate, argument)
}

/// True if an expression contains only numbers, constants, parameters and discrete states, whatever
/// its value is.
fn is_at_rest(evaluator: &Evaluator<'_>, root: AstId) -> bool {
    let mut pending = vec![root];
    while let Some(id) = pending.pop() {
        match evaluator.syntax(id) {
            Expression::Name(name) => {
                let entry = evaluator.scope.find(name).filter(|entry| !entry.is_ambiguous);
                let kind = entry.map(|entry| entry.kind);
                let is_at_rest = name == "pi"
                    || matches!(kind, Some(NameKind::Parameter | NameKind::Constant | NameKind::Discrete));
                if !is_at_rest {
                    return false;
                }
            }
            Expression::Array(_) | Expression::Invalid => return false,
            _ => pending.extend(evaluator.constituents(id)),
        }
    }
    true
}

/// Maximum length of an argument in messages; longer ones are replaced by letters.
const LONGEST_ARGUMENT: usize = 60;

/// Returns the spelling here of a call that is valid in other languages.
fn meant_function(evaluator: &Evaluator<'_>, name: &str, arguments: &[AstId]) -> Option<String> {
    let texts = arguments.iter().map(|&id| print::expression(&evaluator.declaration.expressions, id));
    let texts = texts.collect::<Vec<_>>();
    let is_long = texts.iter().any(|text| text.len() > LONGEST_ARGUMENT);
    let letters = ["a", "b", "c"].map(str::to_owned);
    foreign::function(name, if is_long { letters.get(..texts.len())? } else { &texts })
}

/// Returns false for an acceleration where accelerations are not allowed.
fn is_accepted(evaluator: &Evaluator<'_>, meant: &str) -> bool {
    !meant.starts_with("ddot(") || may_use_accelerations(evaluator)
}

fn report_no_function(evaluator: &mut Evaluator<'_>, name: &Name, arguments: &[AstId]) {
    if let Some(entry) = evaluator.scope.resolve(&name.text) {
        let message = messages::names::not_a_function(&name.text, entry.kind.describe());
        let is_time = |&id: &AstId| matches!(evaluator.syntax(id), Expression::Name(t) if t == "t");
        let help = match arguments {
            [argument] if is_time(argument) => messages::names::of_time(&name.text),
            _ => messages::names::PRODUCT_HELP.to_owned(),
        };
        evaluator.report.error(name.span, message).help(help);
        return;
    }
    if report_too_early(evaluator, name) || report_array(evaluator, name, arguments) {
        return;
    }
    let nearest = nearest_function(evaluator, &name.text, arguments.len());
    let without_counterpart = foreign::without_counterpart(&name.text);
    let help = match (meant_function(evaluator, &name.text, arguments), nearest) {
        (Some(meant), _) if !is_accepted(evaluator, &meant) => {
            messages::ONLY_OUTPUTS_HOLD_ACCELERATIONS.to_owned()
        }
        (Some(meant), _) => messages::names::write_call(&meant),
        (None, nearest) => match (without_counterpart, nearest) {
            (Some(advice), _) => advice.to_owned(),
            (None, Some(nearest)) => messages::names::did_you_mean(nearest),
            (None, None) => messages::names::declare_function(&name.text, arguments.len()),
        },
    };
    evaluator.report.error(name.span, messages::names::unknown_function(&name.text)).help(help);
}

/// Returns the function with the most similar name, preferably one with this number of arguments.
fn nearest_function<'e>(evaluator: &'e Evaluator<'_>, name: &str, count: usize) -> Option<&'e str> {
    let takes = |known: &str| match mass_function(known) {
        Some(function) => {
            let (least, or_more) = function.arity();
            count == least || or_more && count > least
        }
        None => match evaluator.callables.get(&known.to_owned()) {
            Some(callable) => callable.function.as_ref().is_none_or(|function| function.arity() == count),
            None => arity(known) == Some(count),
        },
    };
    let own = evaluator.callables.iter().map(|(name, _)| -> &'e str { name });
    let known = own.chain(function_names().map(|known| -> &'e str { known })).collect::<Vec<_>>();
    let fitting = known.iter().copied().filter(|known| takes(known));
    nearest(name, fitting).or_else(|| nearest(name, known.iter().copied()))
}

/// Reports a call of an array; false if the name is not an array.
fn report_array(evaluator: &mut Evaluator<'_>, name: &Name, arguments: &[AstId]) -> bool {
    if !evaluator.declaration.arrays.iter().any(|array| array.name.text == name.text) {
        return false;
    }
    let expressions = &evaluator.declaration.expressions;
    let indices = arguments.iter().map(|argument| format!("[{}]", print::expression(expressions, *argument)));
    let help = messages::names::element_help(&name.text, indices.collect::<String>());
    evaluator.report.error(name.span, messages::names::array_called(&name.text)).help(help);
    true
}

/// Reports a call of a function that is declared further down; false if there is none.
fn report_too_early(evaluator: &mut Evaluator<'_>, name: &Name) -> bool {
    let mut declared = evaluator.declaration.statements.iter().filter_map(|one| one.kind.declared_function());
    let Some(declared) = declared.find(|declared| declared.text == name.text) else { return false };
    let error = evaluator.report.error(name.span, messages::names::used_too_early(&name.text));
    error.related(declared.span.into(), messages::names::DECLARED_HERE).help(messages::names::ORDER_HELP);
    true
}

fn evaluate_vector_function(
    evaluator: &mut Evaluator<'_>,
    name: &str,
    arguments: &[AstId],
) -> Option<Operand> {
    let what = format!("an argument of `{name}`");
    let vectors = arguments.iter().map(|&argument| evaluator.vector(argument, &what)).collect::<Vec<_>>();
    let vectors = vectors.into_iter().collect::<Option<Vec<_>>>()?;
    if name == "norm" {
        return Some(Operand::Scalar(norm(&mut evaluator.graph, &vectors[0])));
    }
    if vectors[0].len() != vectors[1].len() {
        let kinds = [0, 1].map(|i| Operand::Vector(vectors[i].clone()).kind());
        let message = messages::kinds_differ(format!("take `{name}` of"), &kinds[0], &kinds[1]);
        evaluator.report.error(evaluator.origin(arguments[1]), message).help(messages::KINDS_HELP);
        return None;
    }
    if name == "cross" && !matches!(vectors[0].len(), 2 | 3) {
        let message = messages::no_cross(vectors[0].len());
        return evaluator.refuse(arguments[0], message, messages::CROSS_HELP);
    }
    Some(match name {
        "inner" => Operand::Scalar(inner(&mut evaluator.graph, &vectors[0], &vectors[1])),
        _ => cross(&mut evaluator.graph, &vectors[0], &vectors[1]),
    })
}

fn evaluate_transpose(evaluator: &mut Evaluator<'_>, argument: AstId) -> Option<Operand> {
    match evaluator.value(argument)? {
        Operand::Matrix(sizes, entries) => Some(transposed(sizes, &entries)),
        other => {
            let message = messages::matrix_needed("transpose", other.kind());
            evaluator.refuse(argument, message, messages::MATRIX_HELP)
        }
    }
}

fn evaluate_elementary(
    evaluator: &mut Evaluator<'_>,
    name: &str,
    arguments: &[AstId],
    call: AstId,
) -> Option<Operand> {
    let what = format!("an argument of `{name}`");
    let scalars = arguments.iter().map(|&argument| evaluator.scalar(argument, &what)).collect::<Vec<_>>();
    let scalars = scalars.into_iter().collect::<Option<Vec<_>>>()?;
    Some(Operand::Scalar(match name {
        "gravitational_energy" => evaluator.graph.product(scalars.into_iter().map(|s| (s, 1.into()))),
        "pow" | "powi" | "powf" => power(evaluator, scalars[0], scalars[1], evaluator.origin(call))?,
        _ => {
            let (function, graph) = (elementary::by_name(name)?.function, &mut evaluator.graph);
            match scalars[..] {
                // The smallest or largest of several arguments, pair by pair.
                [first, second, ref others @ ..] if !others.is_empty() => {
                    let both = functions::apply(graph, function, &[first, second]);
                    others.iter().fold(both, |all, other| functions::apply(graph, function, &[all, *other]))
                }
                _ => functions::apply(graph, function, &scalars),
            }
        }
    }))
}
