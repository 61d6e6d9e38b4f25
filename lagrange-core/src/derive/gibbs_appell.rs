//! Equations of motion from a Gibbs function.
//!
//! S = ½ Σ m |a|², summed over all masses, is the Gibbs function or energy of acceleration, and
//! ∂S/∂q̈ = Q are the equations of motion. Sources: Gibbs, "On the fundamental formulae of
//! dynamics", Amer. J. Math. 2 (1879) 49–64; Appell, C. R. Acad. Sci. 129 (1900); Lurie, *Analytical
//! Mechanics*, §10.4. A rigid body has the acceleration a of its centre of mass, the angular
//! acceleration α and the tensor of inertia J. Without terms free of accelerations, its S is ½ m |a|² +
//! ½ α·Jα + α·(ω × Jω).
//!
//! Accelerations are affine in q̈. The principal part of an acceleration is its part linear in q̈
//! with q̇ in place of q̈. It is a velocity: for ω̇ it is ω. The second derivatives of S with
//! respect to accelerations are therefore coefficients of the quadratic form at velocities, in
//! addition to those of T. The slope of S along an acceleration is a linear coefficient there. The
//! terms that are pushed down from these nodes are forces and moments. Inverse dynamics then is the
//! recursive Newton–Euler algorithm, and the form over q̇ yields the mass matrix by the
//! composite-body algorithm. See Featherstone, *Rigid Body Dynamics Algorithms*, §5.3 and §6.2.
//! Neither velocities of points nor rates of momenta are needed. Gravity enters as an acceleration
//! of the base. Inertia that a joint cannot distinguish from that of its carrier may be moved to
//! the carrier in advance, since S need not separate bodies. See Khalil and Dombre, *Modeling,
//! Identification and Control of Robots*, §9.4.
//!
//! # A pendulum in numbers
//!
//! Take m = 1 on a rod of length 5 under g = 10, at sin θ = 3/5 with θ̇ = 1. In the axes of the
//! rod, the acceleration of its end is −5 θ̇² along the rod and 5 θ̈ across it. With the base
//! accelerated upwards by 10, it is 5 θ̈ + 10 · 3/5 across.
//!
//! | node | principal part | square | linear part at θ̈ = 0 |
//! |---|---|---|---|
//! | 5 θ̈ + 6 | 5 θ̇ | 1 | 6 |
//! | | θ̇ | 25 | 30 |
//!
//! Then θ̈ = −30/25 = −6/5, as from the energies; the acceleration along the rod never occurs.

use std::collections::BTreeMap;

use super::curvature::Curvature;
use super::quadratic_form::QuadraticForm;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_algebra::calculus::Degree;
use lagrange_algebra::calculus::Degrees;
use lagrange_algebra::calculus::adjoint;
use lagrange_algebra::calculus::partials;
use lagrange_algebra::calculus::substitute_all;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::expr::Dependencies;
use lagrange_expr::expr::ExprId;
use lagrange_expr::expr::Graph;
use lagrange_expr::expr::Node;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Second derivatives and slopes of a Gibbs function, assigned to velocities.
#[derive(Debug)]
pub(super) struct GibbsForm {
    /// The second derivatives with respect to accelerations, at their principal parts.
    pub(super) quadratic: QuadraticForm,
    /// Principal parts of accelerations, each with its numeric factor.
    principal: Vec<(ExprId, Number)>,
    /// The slope of S along each of these accelerations.
    slopes: Vec<ExprId>,
    /// Slopes with all q̈ zero.
    slopes_at_rest: Vec<ExprId>,
}

impl GibbsForm {
    /// Splits a polynomial of degree one or two in the accelerations.
    pub(super) fn new(graph: &mut Graph, function: ExprId) -> GibbsForm {
        // The product of an acceleration and a velocity has no principal part that is affine in the
        // velocities.
        let degrees = Degrees::in_terms_of(Dependencies::ACCELERATION);
        let mut degrees = degrees.with_coefficients_free_of(Dependencies::VELOCITY);
        degrees.classify(graph, &[function]);
        let accelerations = affine_operands(graph, &degrees, function);
        let principal = principal_parts(graph, &degrees, &accelerations);
        let quadratic = second_derivatives(graph, degrees, function, &principal);
        let one = graph.number(1);
        let slopes = adjoint(graph, &[(function, one)], &accelerations);
        let slopes_at_rest = at_rest(graph, &slopes);
        let of = |id| principal.get(id).cloned().unwrap_or((*id, Number::ZERO));
        let principal = accelerations.iter().map(of).collect();
        GibbsForm { quadratic, principal, slopes, slopes_at_rest }
    }

    /// Adds the slopes to the linear part of a form.
    pub(super) fn add_linear(
        &self,
        graph: &mut Graph,
        form: &mut QuadraticForm,
        accelerations: AccelerationTerms,
    ) {
        let slopes = match accelerations {
            AccelerationTerms::Kept => &self.slopes,
            AccelerationTerms::Dropped => &self.slopes_at_rest,
        };
        for ((velocity, factor), slope) in self.principal.iter().zip(slopes) {
            let load = graph.scale(factor.clone(), *slope);
            form.add_linear(graph, *velocity, load);
        }
    }
}

/// Returns affine nodes that are operands of nonlinear nodes, or of none.
pub(super) fn affine_operands(graph: &mut Graph, degrees: &Degrees, function: ExprId) -> Vec<ExprId> {
    let is_affine = |graph: &Graph, id| degrees.of(graph, id) == Degree::Affine;
    let mut found = Vec::new();
    for id in graph.reachable_until(&[function], |id| degrees.of(graph, id) != Degree::Nonlinear) {
        if degrees.of(graph, id) == Degree::Nonlinear {
            let operands = partials(graph, id).into_iter().map(|(operand, _)| operand);
            found.extend(operands.filter(|&operand| is_affine(graph, operand)));
        } else if id == function {
            found.push(id);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// Returns `(velocity, factor)` for each acceleration, which is the factor times the velocity with
/// q̈ for q̇, plus terms free of q̈.
fn principal_parts(
    graph: &mut Graph,
    degrees: &Degrees,
    accelerations: &[ExprId],
) -> HashMap<ExprId, (ExprId, Number)> {
    let mut known: HashMap<ExprId, ExprId> = HashMap::default();
    for id in graph.reachable_until(accelerations, |id| degrees.of(graph, id) == Degree::Free) {
        if degrees.of(graph, id) == Degree::Affine {
            let part = principal_part(graph, id, &known);
            known.insert(id, part);
        }
    }
    let parts = accelerations.iter().filter_map(|id| {
        let (factor, velocity) = graph.split_coefficient(*known.get(id)?);
        Some((*id, (velocity, factor)))
    });
    parts.collect()
}

/// Returns the principal part of an affine node from those of its affine operands.
fn principal_part(graph: &mut Graph, id: ExprId, known: &HashMap<ExprId, ExprId>) -> ExprId {
    match graph.node(id).clone() {
        Node::Symbol(symbol) => {
            let symbol = graph.symbols().get(symbol).clone();
            match symbol.role {
                Role::Acceleration(i) => graph.symbol(&symbol.name, Role::Velocity(i)),
                _ => id,
            }
        }
        Node::Sum { terms, .. } => {
            let parts = terms.iter().filter_map(|(term, c)| Some((*known.get(term)?, c.clone())));
            graph.sum(Number::ZERO, parts.collect::<Vec<_>>())
        }
        Node::Product(factors) => {
            let part = |base: ExprId| known.get(&base).copied().unwrap_or(base);
            graph.product(factors.iter().map(|(base, exponent)| (part(*base), exponent.clone())))
        }
        Node::Choose { relation, left, right, then, otherwise } => {
            let zero = graph.number(0);
            let [then, otherwise] =
                [then, otherwise].map(|branch| known.get(&branch).copied().unwrap_or(zero));
            graph.choose(relation, left, right, then, otherwise)
        }
        _ => id,
    }
}

fn second_derivatives(
    graph: &mut Graph,
    degrees: Degrees,
    function: ExprId,
    principal: &HashMap<ExprId, (ExprId, Number)>,
) -> QuadraticForm {
    let mut curvature = Curvature::new(degrees);
    for id in graph.reachable(&[function]).into_iter().rev() {
        if curvature.degrees.of(graph, id) == Degree::Nonlinear {
            let adjoint = match id == function {
                true => Some(graph.number(1)),
                false => curvature.take_adjoint(graph, id),
            };
            curvature.sweep(graph, id, adjoint);
        }
    }
    let mut form = curvature.quadratic;
    for id in form.variables() {
        let part = principal.get(&id).map(|(velocity, factor)| (*velocity, graph.number(factor.clone())));
        form.push(graph, id, part.as_slice());
    }
    form
}

fn at_rest(graph: &mut Graph, values: &[ExprId]) -> Vec<ExprId> {
    let zero = graph.number(0);
    let is_acceleration =
        |id: ExprId| graph.symbol_of(id).is_some_and(|symbol| matches!(symbol.role, Role::Acceleration(_)));
    let symbols = graph.reachable(values).into_iter().filter(|&id| is_acceleration(id));
    let zeros = symbols.map(|symbol| (symbol, zero)).collect::<HashMap<_, _>>();
    substitute_all(graph, values, &zeros)
}

/// Returns whole − part, with the sums of both expanded as far as they have terms in common.
pub(super) fn remainder(graph: &mut Graph, whole: ExprId, part: ExprId) -> ExprId {
    let common = common_terms(graph, whole, part);
    let mut pending = BTreeMap::from([(whole, Number::ONE)]);
    let add = |pending: &mut BTreeMap<ExprId, Number>, term: ExprId, coefficient: Number| {
        let sum = pending.entry(term).or_insert(Number::ZERO);
        *sum = &*sum + &coefficient;
    };
    add(&mut pending, part, Number::MINUS_ONE);
    let (mut constant, mut terms) = (Number::ZERO, Vec::new());
    // Operands have smaller ids, so all contributions to a term are present when it is processed.
    while let Some((id, coefficient)) = pending.pop_last() {
        match graph.node(id) {
            _ if coefficient.is_zero() => {}
            Node::Sum { constant: inner, terms: parts } if common.contains(&id) => {
                constant = &constant + &(inner * &coefficient);
                for (term, weight) in parts {
                    add(&mut pending, *term, weight * &coefficient);
                }
            }
            _ => terms.push((id, coefficient)),
        }
    }
    graph.sum(constant, terms)
}

/// Returns the sums of both expressions that contain a common term, directly or in nested sums.
fn common_terms(graph: &Graph, whole: ExprId, part: ExprId) -> HashSet<ExprId> {
    let is_sum = |id: ExprId| matches!(graph.node(id), Node::Sum { .. });
    let closures = [whole, part].map(|root| graph.reachable_until(&[root], |id| !is_sum(id)));
    let of_part = closures[1].iter().copied().collect::<HashSet<_>>();
    let shared = closures[0].iter().filter(|id| of_part.contains(id)).copied();
    let shared = shared.collect::<HashSet<_>>();
    let mut holding: HashSet<ExprId> = HashSet::default();
    for id in graph.reachable_until(&[whole, part], |id| !is_sum(id)).into_iter().filter(|&id| is_sum(id)) {
        let mut holds = false;
        graph.node(id).for_each_child(|child| holds |= shared.contains(&child) || holding.contains(&child));
        if holds {
            holding.insert(id);
        }
    }
    holding
}

#[cfg(test)]
mod tests;
