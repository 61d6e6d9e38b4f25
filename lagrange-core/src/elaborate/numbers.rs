//! Checks of numbers in a declaration: whether they can be kept exact, are real, and are in the
//! range of the scalar.
//!
//! A value without symbols that is not real is always an error. A number that is too large for the
//! scalar is an error only if it remains in an expression to be computed: `1e400 / 1e399` is ten.

use super::evaluator::Evaluator;
use super::messages;
use super::operand::Operand;
use lagrange_expr::elementary;
use lagrange_expr::expr::{Dependencies, ExprId, Node};
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Axis;
use lagrange_language::syntax::ast::{AstId, Expression};

/// True if elaboration can continue with a value, which is reported otherwise.
pub(super) fn is_sound(evaluator: &mut Evaluator<'_>, value: &Operand, id: AstId) -> bool {
    is_short(evaluator, value, id) && is_real(evaluator, value, id)
}

/// True if exact numbers are short. They grow with every operation, and double in length in each of
/// `a1 = a0*a0 + 1/7`, `a2 = a1*a1 + 1/7`, ….
fn is_short(evaluator: &mut Evaluator<'_>, value: &Operand, id: AstId) -> bool {
    let has_short_powers = |id: ExprId| match evaluator.graph.node(id) {
        Node::Product(factors) => factors.iter().all(|(_, exponent)| exponent.is_short()),
        _ => true,
    };
    let is_short = |&component: &ExprId| {
        let (coefficient, core) = evaluator.graph.split_coefficient(component);
        let number = evaluator.graph.as_number(core);
        coefficient.is_short() && number.is_none_or(Number::is_short) && has_short_powers(core)
    };
    let short = value.components().iter().all(is_short);
    if !short {
        evaluator.refuse::<()>(id, messages::NUMBER_TOO_LONG, messages::NUMBER_TOO_LONG_HELP);
    }
    short
}

fn is_real(evaluator: &mut Evaluator<'_>, value: &Operand, id: AstId) -> bool {
    let graph = &evaluator.graph;
    let unknown = |&component: &ExprId| {
        graph.dependencies(component) == Dependencies::NONE && graph.as_number(component).is_none()
    };
    let mut constants = value.components().iter().copied().filter(unknown);
    let is_real = constants.all(|component| evaluator.constants.first_unreal(graph, component).is_none());
    if !is_real {
        let help = match evaluator.syntax(id) {
            Expression::Call(function, _) => {
                let row = elementary::by_name(&function.text);
                row.map(|row| messages::defined_where(row.name, row.domain.words()))
                    .or_else(|| reach_of_table(evaluator, &function.text))
            }
            _ => None,
        };
        evaluator.refuse::<()>(
            id,
            messages::NOT_REAL,
            help.unwrap_or_else(|| messages::NEGATIVE_BASE_HELP.to_owned()),
        );
    }
    is_real
}

/// Describes the range in which a table is defined; `None` for other functions.
fn reach_of_table(evaluator: &Evaluator<'_>, name: &str) -> Option<String> {
    let function = evaluator.callables.get(&name.to_owned())?.function.as_ref()?;
    let ends = |axis: &Axis| [axis.knots[0], axis.knots[axis.knots.len() - 1]];
    let reach = function.table()?.axes.iter().map(ends).collect::<Vec<_>>();
    Some(messages::tables::reaches(name, &reach))
}
