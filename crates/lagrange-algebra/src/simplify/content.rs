//! Common factor of several expressions.

use super::cancel::quotient;
use super::monomial::MAX_FACTORS;
use super::monomial::Monomial;
use super::monomial::Term;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Graph;
use lagrange_expr::number::Number;

/// Returns a common factor of the expressions, and the expressions without it. Forms that differ
/// only by a product of such factors become equal. The first of the remaining expressions has a
/// positive coefficient, and a single expression is entirely content.
pub fn content(graph: &mut Graph, expressions: &[ExprId]) -> (ExprId, Vec<ExprId>) {
    let one = graph.number(1);
    if let [only] = expressions {
        return (*only, vec![one]);
    }
    let terms = expressions.iter().map(|&id| Term::of(graph, id, &Number::ONE)).collect::<Vec<_>>();
    let Some(first) = terms.first() else { return (one, Vec::new()) };
    let common = terms.iter().fold(first.monomial.clone(), |common, term| common.least(&term.monomial));
    let (common, _) = common.split(|_, exponent| !exponent.is_negative() && exponent.is_integer());
    let common_core = common.build(graph);
    // The first one may be zero, like some drifts.
    let Some(scale) = first.coefficient.reciprocal() else { return (one, expressions.to_vec()) };
    let rest = terms.iter().map(|term| {
        let core = term.monomial.over(&common).build(graph);
        graph.scale(&term.coefficient * &scale, core)
    });
    let rest = rest.collect();
    (graph.scale(first.coefficient.clone(), common_core), rest)
}

/// Returns `numerator / denominator`, unless the divisor changes during the motion and may vanish
/// somewhere.
pub fn safe_quotient(graph: &mut Graph, numerator: ExprId, denominator: ExprId) -> Option<ExprId> {
    let found = quotient(graph, numerator, denominator);
    let (_, core) = graph.split_coefficient(found);
    let flat = Monomial::of(graph, core, MAX_FACTORS)?;
    let (_, core) = graph.split_coefficient(denominator);
    let divisor = Monomial::of(graph, core, MAX_FACTORS)?;
    let is_divided = |(base, _): &(ExprId, Number)| {
        let is_below = flat.exponent(*base).is_some_and(Number::is_negative);
        is_below && !graph.dependencies(*base).is_constant_in_motion()
    };
    (!divisor.factors().iter().any(is_divided)).then_some(found)
}
