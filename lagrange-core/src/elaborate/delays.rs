//! Delayed signals: inputs whose values come from the past of the motion.

use super::elaborator::Elaborator;
use super::messages::delays as words;
use super::operand::Operand;
use super::scope::NameKind;
use crate::model::{Delay, Parameter, Product};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::ExprId;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Name};

/// Declares a delayed signal.
pub(super) fn define_delay(elaborator: &mut Elaborator<'_>, name: &Name, [signal, lag]: [AstId; 2]) {
    let signal = elaborator.known_scalar(signal, words::SIGNAL, words::SIGNAL_HELP);
    let lag = lag_of(elaborator, lag);
    let index = elaborator.inputs.len();
    let graph = &mut elaborator.evaluator.graph;
    let (symbol, zero) = (graph.symbol(&name.text, Role::Input(index as u32)), graph.number(0));
    let (text, range) = (name.text.clone(), [None, None]);
    elaborator.inputs.push(Parameter { name: text, symbol, default: Some(zero), range });
    // What uses a mistaken signal is not to blame.
    let value = signal.map(|_| Operand::Scalar(symbol));
    elaborator.declare(name, NameKind::Input, value);
    let delay = signal.zip(lag).map(|(signal, lag)| Delay { input: index, signal, lag, before: None });
    elaborator.delays.extend(delay.map(|delay| (delay, name.span)));
}

fn lag_of(elaborator: &mut Elaborator<'_>, syntax: AstId) -> Option<ExprId> {
    let lag = elaborator.constant_in_motion(syntax, words::LAG)?;
    if let Some(number) = elaborator.numeric(lag).filter(|&number| number <= 0.0) {
        return elaborator.evaluator.refuse(syntax, words::not_positive(number), words::NOT_POSITIVE_HELP);
    }
    Some(lag)
}

/// Reports features incompatible with delays: linear models, which would treat them as inputs, and
/// reductions.
pub(super) fn check_delays(elaborator: &mut Elaborator<'_>) {
    let Some(place) = elaborator.delays.first().map(|(_, place)| Origin::from(*place)) else { return };
    let demands = elaborator.demands(Product::SystemMatrix);
    let report = &mut elaborator.evaluator.report;
    for span in demands {
        let error = report.error(span, words::LINEAR_MODEL).related(place, words::DELAYED_HERE);
        error.help(words::LINEAR_MODEL_HELP);
    }
    for reduction in &elaborator.reductions {
        let error = report.error(reduction.name.span, words::REDUCTION).related(place, words::DELAYED_HERE);
        error.help(words::REDUCTION_HELP);
    }
}
