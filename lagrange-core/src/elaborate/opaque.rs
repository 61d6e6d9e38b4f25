//! Functions without a formula in a declaration: their registration and their calls.

use proc_macro2::Span;

use super::callable::Callable;
use super::evaluator::Evaluator;
use super::messages;
use super::operand::Operand;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::{Opaque, OpaqueFunction, Source};
use lagrange_language::syntax::ast::{AstId, CONTACT_POINT_LENGTH, ExternalFunction, Name};

/// Registers a function of the user's crate.
pub(super) fn define_external(evaluator: &mut Evaluator<'_>, declared: &ExternalFunction) {
    let derivatives = declared.derivatives.as_ref();
    let named = derivatives.map(|derivatives| {
        derivatives
            .iter()
            .map(|derivative| (derivative.orders.clone(), derivative.name.text.clone()))
            .collect()
    });
    let function = OpaqueFunction {
        name: declared.name.text.clone(),
        parameters: declared.parameters.iter().map(|parameter| parameter.text.clone()).collect(),
        source: Source::Crate { derivatives: named },
    };
    define(evaluator, &declared.name, Some(Opaque::value_of(function)));
}

/// Registers a function under its name.
pub(super) fn define(evaluator: &mut Evaluator<'_>, name: &Name, function: Option<Opaque>) {
    // A repeated declaration has already been reported.
    if !evaluator.callables.contains(&name.text) {
        let callable = Callable { function, span: name.span, is_called: false };
        evaluator.callables.insert(name.text.clone(), callable);
    }
}

/// Returns the value of a call of such a function. The result is `None` if no function has that
/// name, and `Some(None)` if the call contains an error, which is reported.
pub(super) fn evaluate_callable(
    evaluator: &mut Evaluator<'_>,
    name: &Name,
    arguments: &[AstId],
    call: AstId,
) -> Option<Option<Operand>> {
    let callable = evaluator.callables.get_mut(&name.text)?;
    callable.is_called = true;
    let span = callable.span;
    let Some(function) = callable.function.clone() else { return Some(None) };
    if arguments.len() != function.arity() {
        let message = messages::names::wrong_argument_count(&name.text, function.arity(), arguments.len());
        let usage = format!("{}({})", name.text, function.function().parameters.join(", "));
        let error = evaluator.report.error(evaluator.origin(call), message);
        error.related(span.into(), messages::names::DECLARED_HERE).help(messages::names::write_call(&usage));
        return Some(None);
    }
    let what = format!("an argument of `{}`", name.text);
    let scalars = arguments.iter().map(|&argument| evaluator.scalar(argument, &what)).collect::<Vec<_>>();
    let scalars = scalars.into_iter().collect::<Option<Vec<_>>>();
    Some(scalars.map(|scalars| Operand::Scalar(evaluator.graph.opaque(function, &scalars))))
}

/// Returns a number of the contact points of two blocks, from its place, the count of numbers, and
/// the numbers of both blocks.
pub(super) fn evaluate_contact_point(evaluator: &mut Evaluator<'_>, arguments: &[AstId]) -> Option<Operand> {
    let what = "a number of a contact point";
    let scalars = arguments.iter().map(|&argument| evaluator.scalar(argument, what)).collect::<Vec<_>>();
    let scalars = scalars.into_iter().collect::<Option<Vec<_>>>()?;
    let [place, count, blocks @ ..] = &scalars[..] else { return None };
    let [place, count] = [place, count].map(|&id| evaluator.graph.as_number(id).and_then(Number::to_i32));
    let (place, count) = (usize::try_from(place?).ok()?, usize::try_from(count?).ok()?);
    let named = |number: usize| {
        format!("contact_point_{}_{}", number / CONTACT_POINT_LENGTH, number % CONTACT_POINT_LENGTH)
    };
    let function = OpaqueFunction {
        name: named(place),
        parameters: (0..blocks.len()).map(|number| format!("block_{number}")).collect(),
        source: Source::ContactPoints { numbers: (0..count).map(named).collect(), place },
    };
    Some(Operand::Scalar(evaluator.graph.opaque(Opaque::value_of(function), blocks)))
}

/// Warns about functions that are never called.
pub(super) fn report_uncalled(evaluator: &mut Evaluator<'_>) {
    let uncalled =
        evaluator.callables.iter().filter(|(name, callable)| !callable.is_called && !name.starts_with('_'));
    let uncalled = uncalled.map(|(name, callable)| (name.clone(), callable.span)).collect::<Vec<_>>();
    for (name, span) in uncalled {
        warn(evaluator.report, &name, span);
    }
}

fn warn(report: &mut Report, name: &str, span: Span) {
    report.unused(name, span, messages::names::never_called(name)).help(messages::names::NEVER_CALLED_HELP);
}
