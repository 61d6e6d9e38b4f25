//! Responses of the motion to forces of contacts and friction, and limits of these forces.
//!
//! The equations of motion are linear in these forces. With all of them zero they give a₀ and λ₀. A
//! unit of reaction k, acting along the gradient d_k of its velocity, adds w_k and μ_k. Without
//! constraints, w_k = M⁻¹ d_k is computed at run time. One factorisation of the mass matrix then
//! serves all reactions, and the code does not grow with their number. Constraints would make that
//! matrix indefinite and, where they depend on each other, singular. With constraints, w_k and μ_k
//! follow from the elimination for the accelerations, with −d_k as its linear part. Source:
//! Featherstone, *Rigid Body Dynamics Algorithms*, §11.5.

use super::elimination::record::Elimination;
use crate::model::{Model, ReactionKind};
use lagrange_algebra::calculus::{AccelerationTerms, Rates, gradient, substitute_all};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::functions;
use lagrange_expr::number::Number;

/// A quantity that is affine in the reactions.
#[derive(Clone, Debug)]
pub struct Affine {
    /// The value without reactions.
    pub free: ExprId,
    /// The change due to a unit of each reaction.
    pub slopes: Vec<ExprId>,
}

/// Equations of the reactions of a model, in the order of their declaration; empty without
/// reactions.
#[derive(Clone, Default, Debug)]
pub struct ReactionEquations {
    /// Accelerations that a unit of reaction k adds, in row k; rows are empty without constraints.
    pub responses: Vec<Vec<ExprId>>,
    /// The multipliers, in which symbols stand for the reactions.
    pub multipliers: Vec<ExprId>,
    /// Gradient of gap rate or slip velocity k with respect to the velocities, in row k.
    pub rows: Vec<Vec<ExprId>>,
    /// Rates of these velocities at zero acceleration.
    pub drifts: Vec<ExprId>,
    /// Kinetic limits of friction; for smooth friction, multiplied by the fraction that acts.
    pub kinetic: Vec<Affine>,
    /// Static limits of friction.
    pub fixed: Vec<Affine>,
}

impl ReactionEquations {
    /// Collects the equations. For a model with constraints, this takes the elimination for the
    /// accelerations and the multipliers without reactions.
    pub(super) fn new(
        model: &mut Model,
        elimination: Option<&Elimination>,
        multipliers: &[ExprId],
    ) -> ReactionEquations {
        if model.reactions.is_empty() {
            return ReactionEquations::default();
        }
        let velocities = model.velocities();
        let reactions = model.reactions.iter().map(|reaction| reaction.velocity).collect::<Vec<_>>();
        let rows = reactions.iter().map(|&slip| gradient(&mut model.graph, slip, &velocities));
        let rows = rows.collect::<Vec<_>>();
        let mut rates = Rates::new(AccelerationTerms::Dropped);
        let drifts = reactions.iter().map(|&slip| rates.of(&mut model.graph, slip)).collect();
        let added = rows.iter().map(|row| match elimination {
            Some(elimination) => response(model, elimination, row),
            None => Default::default(),
        });
        let (responses, multiplier_responses): (Vec<_>, Vec<_>) = added.unzip();
        let limits = Limits { multipliers, responses: &multiplier_responses };
        let (kinetic, fixed) = (0..reactions.len()).map(|k| limits.of(model, k)).unzip();
        let multipliers = with_reactions(model, multipliers, &multiplier_responses);
        ReactionEquations { responses, multipliers, rows, drifts, kinetic, fixed }
    }
}

/// Returns the accelerations and multipliers due to a unit of force along a row.
fn response(model: &mut Model, elimination: &Elimination, row: &[ExprId]) -> (Vec<ExprId>, Vec<ExprId>) {
    let unknowns = model.unknowns();
    let graph = &mut model.graph;
    let mut linear = row.iter().map(|&slope| graph.negate(slope)).collect::<Vec<_>>();
    linear.resize(unknowns.len(), graph.number(0));
    let mut accelerations = elimination.solve_again(graph, &linear, &unknowns);
    let multipliers = accelerations.split_off(row.len());
    (accelerations, multipliers)
}

/// Returns λ₀ + Σ μ_k r_k.
fn with_reactions(model: &mut Model, multipliers: &[ExprId], responses: &[Vec<ExprId>]) -> Vec<ExprId> {
    let symbols = model.reactions.iter().map(|reaction| reaction.symbol).collect::<Vec<_>>();
    let graph = &mut model.graph;
    let total = |(m, &multiplier): (usize, &ExprId)| {
        let parts = responses.iter().zip(&symbols).map(|(row, &symbol)| graph.multiply(row[m], symbol));
        let parts = parts.chain([multiplier]).collect::<Vec<_>>();
        graph.total(parts)
    };
    multipliers.iter().enumerate().map(total).collect()
}

/// Quantities from which limits of friction are computed.
struct Limits<'a> {
    /// Multipliers without reactions.
    multipliers: &'a [ExprId],
    /// Multipliers due to a unit of each reaction.
    responses: &'a [Vec<ExprId>],
}

impl Limits<'_> {
    /// Returns the kinetic and the static limit of a reaction; zero for a contact.
    fn of(&self, model: &mut Model, k: usize) -> (Affine, Affine) {
        let reaction = model.reactions[k].clone();
        let zero = model.graph.number(0);
        match reaction.kind {
            ReactionKind::Contact { .. } => (self.affine(model, zero), self.affine(model, zero)),
            ReactionKind::Friction { kinetic, fixed } | ReactionKind::Across { kinetic, fixed } => {
                (self.affine(model, kinetic), self.affine(model, fixed))
            }
            ReactionKind::Smooth { limit, width } => {
                let share = share(&mut model.graph, reaction.velocity, width);
                let limit = model.graph.multiply(limit, share);
                (self.affine(model, limit), self.affine(model, zero))
            }
        }
    }

    /// Rewrites a limit that is affine in multipliers and reactions as a function of reactions
    /// alone.
    fn affine(&self, model: &mut Model, limit: ExprId) -> Affine {
        let multipliers = model.multipliers();
        let reactions = model.reactions.iter().map(|reaction| reaction.symbol).collect::<Vec<_>>();
        let graph = &mut model.graph;
        let zero = graph.number(0);
        let by_multipliers = gradient(graph, limit, &multipliers);
        let by_reactions = gradient(graph, limit, &reactions);
        let known = multipliers.into_iter().zip(self.multipliers.iter().copied());
        let known = known.chain(reactions.into_iter().map(|symbol| (symbol, zero))).collect();
        let free = substitute_all(graph, &[limit], &known)[0];
        let slope = |(direct, row): (ExprId, &Vec<ExprId>)| {
            let by_way = by_multipliers.iter().zip(row).map(|(&slope, &part)| graph.multiply(slope, part));
            let terms = by_way.chain([direct]).collect::<Vec<_>>();
            graph.total(terms)
        };
        let slopes = by_reactions.into_iter().zip(self.responses).map(slope).collect();
        Affine { free, slopes }
    }
}

/// Returns tanh(velocity / width).
fn share(graph: &mut Graph, velocity: ExprId, width: ExprId) -> ExprId {
    let inverse = graph.reciprocal(width);
    let ratio = graph.multiply(velocity, inverse);
    functions::apply(graph, lagrange_expr::expr::Function::Tanh, &[ratio])
}

/// Returns Σ d_k r_k, with symbols for the reactions.
pub(super) fn reaction_forces(model: &mut Model, equations: &ReactionEquations) -> Vec<ExprId> {
    let symbols = model.reactions.iter().map(|reaction| reaction.symbol).collect::<Vec<_>>();
    let (count, graph) = (model.speeds.len(), &mut model.graph);
    let force = |i: usize| {
        let terms = equations
            .rows
            .iter()
            .zip(&symbols)
            .map(|(row, &symbol)| (graph.multiply(row[i], symbol), Number::ONE));
        let terms = terms.collect::<Vec<_>>();
        graph.sum(Number::ZERO, terms)
    };
    (0..count).map(force).collect()
}
