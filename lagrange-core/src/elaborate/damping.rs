//! Rayleigh functions of lengths at zero length.
//!
//! The rate of a length ‖r‖ is σ/‖r‖ with σ = r·ṙ, which is 0/0 where both ends meet. Its square
//! has a limit: along any motion through r = 0 both vectors become parallel, and σ²/r·r tends to
//! ṙ·ṙ. A damper then acts with the force −c ṙ, as it does just before and after. The square is
//! written without division by zero in either case,
//!
//! > σ²/(r·r if that is positive, else 1) + (0 if r·r is positive, else 1) ṙ·ṙ,
//!
//! which involves no root. On a line, r = (x, 0), the square of the rate is simply ẋ².

use super::elaborator::Elaborator;
use lagrange_algebra::calculus::{AccelerationTerms, Rates, substitute};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node, Relation};
use lagrange_expr::number::Number;

/// The rate of a length.
struct LengthRate {
    /// r·r
    square: ExprId,
    /// r·ṙ, multiplied by the factor of the rate.
    along: ExprId,
    /// ṙ·ṙ, multiplied by the square of that factor.
    speed: ExprId,
}

/// Rewrites squared rates of lengths in a Rayleigh function so that they have their limits at zero
/// length. Lengths on which the potential depends other than by their squares keep their roots,
/// since the elastic force has no limit.
pub(super) fn with_limits(elaborator: &mut Elaborator<'_>, dissipation: ExprId) -> ExprId {
    let potential =
        elaborator.potential.iter().chain(&elaborator.lagrangian).map(|term| term.value).collect::<Vec<_>>();
    let bent = roots_in(&elaborator.evaluator.graph, &potential);
    let graph = &mut elaborator.evaluator.graph;
    let mut replacements = HashMap::default();
    for id in graph.reachable(&[dissipation]) {
        let Node::Product(factors) = graph.node(id).clone() else { continue };
        let squared = factors.iter().position(|(base, exponent)| {
            *exponent == Number::TWO && elaborator.evaluator.named_rates.contains(base)
        });
        let Some(at) = squared else { continue };
        let rate = factors[at].0;
        let Some(&position) = elaborator.evaluator.named_rates.get(&rate) else { continue };
        let Some(length) = length_rate(graph, rate, position).filter(|length| !bent.contains(&length.square))
        else {
            continue;
        };
        let mut others = factors.to_vec();
        others.remove(at);
        let square = limited_square(graph, &length);
        others.push((square, Number::ONE));
        replacements.insert(id, graph.product(others));
    }
    substitute(graph, dissipation, &replacements)
}

/// Returns the sums of squares under square roots.
fn roots_in(graph: &Graph, exprs: &[ExprId]) -> Vec<ExprId> {
    let mut found = Vec::new();
    for id in graph.reachable(exprs) {
        if let Node::Product(factors) = graph.node(id) {
            found
                .extend(factors.iter().filter(|(_, exponent)| !exponent.is_integer()).map(|(base, _)| *base));
        }
    }
    found
}

/// Returns σ²/(s if s > 0, else 1) + (0 if s > 0, else 1) ṙ·ṙ with s = r·r.
fn limited_square(graph: &mut Graph, length: &LengthRate) -> ExprId {
    let [zero, one] = [0, 1].map(|number| graph.number(number));
    let divisor = graph.choose(Relation::Less, zero, length.square, length.square, one);
    let is_zero = graph.choose(Relation::Less, zero, length.square, zero, one);
    let quotient = graph.product([(length.along, Number::TWO), (divisor, Number::MINUS_ONE)]);
    let limit = graph.multiply(is_zero, length.speed);
    graph.add(quotient, limit)
}

/// Returns the parts of a velocity that is the rate of the root of a sum of squares. All squares
/// may vanish during the motion.
fn length_rate(graph: &mut Graph, rate: ExprId, position: ExprId) -> Option<LengthRate> {
    let (scale, root) = graph.split_coefficient(position);
    let Node::Product(factors) = graph.node(root).clone() else { return None };
    let is_root = |(_, exponent): &(ExprId, Number)| *exponent == Number::HALF;
    let (square, _) = factors.iter().find(|factor| is_root(factor))?.clone();
    let mut beside = factors.to_vec();
    beside.retain(|(base, _)| *base != square);
    let is_fixed = |id: ExprId| graph.dependencies(id).is_constant_in_motion();
    if !beside.iter().all(|(base, _)| is_fixed(*base)) {
        return None;
    }
    let components = components(graph, square)?;
    let mut rates = Rates::new(AccelerationTerms::Kept);
    let mut speeds = Vec::with_capacity(components.len());
    for (weight, component) in components {
        let speed = rates.of(graph, component);
        speeds.push((graph.square(speed), weight));
    }
    let speed = graph.sum(Number::ZERO, speeds);
    beside.push((graph.number(scale), Number::ONE));
    let squares = beside.into_iter().map(|(base, exponent)| (base, &exponent * &Number::TWO));
    let factor = graph.product(squares.collect::<Vec<_>>());
    let root = graph.power(square, Number::HALF);
    Some(LengthRate { square, along: graph.multiply(rate, root), speed: graph.multiply(factor, speed) })
}

/// Returns `(c, r)` of Σ c r², if an expression is such a sum without a constant part.
fn components(graph: &mut Graph, sum: ExprId) -> Option<Vec<(Number, ExprId)>> {
    let Node::Sum { constant, terms } = graph.node(sum).clone() else { return None };
    if !constant.is_zero() {
        return None;
    }
    let mut found = Vec::with_capacity(terms.len());
    for (term, coefficient) in terms {
        let Node::Product(factors) = graph.node(term).clone() else { return None };
        let is_square = !coefficient.is_negative() && factors.iter().all(|(_, exponent)| exponent.is_even());
        if !is_square || graph.dependencies(term).is_constant_in_motion() {
            return None;
        }
        let root =
            factors.iter().map(|(base, exponent)| (*base, exponent * &Number::HALF)).collect::<Vec<_>>();
        found.push((coefficient, graph.product(root)));
    }
    Some(found)
}
