//! Diffusions of a model: the contribution of a unit of each white noise to the rates of the state.
//!
//! A noise w of the density S is √S dW/dt. The equations M v̇ = f + Σ wₖ dₖ and ż = h + Σ wₖ eₖ
//! have the diffusions gₖ = √Sₖ (eₖ, M⁻¹ dₖ). M is factorised only once.

use super::forms::Forms;
use super::inverse_mass_matrix::{cheapest, solved_each_way};
use crate::model::{Model, Noise};
use lagrange_algebra::calculus::{adjoint, jacobian};
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::number::Number;

/// The diffusions of a model.
#[derive(Clone, Default, Debug)]
pub struct Diffusion {
    /// Diffusion of each noise, with one entry per state variable.
    pub columns: Vec<Vec<ExprId>>,
    /// Dependence of the diffusions on the state.
    pub kind: DiffusionKind,
}

/// Dependence of diffusions on the state.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum DiffusionKind {
    /// No dependence.
    #[default]
    Additive,
    /// Dependence only on entries that no noise drives.
    Unambiguous,
    /// Any other dependence.
    Multiplicative,
}

impl Diffusion {
    /// Computes the diffusions of a model without constraints.
    pub(super) fn new(model: &mut Model, forms: &mut Forms) -> Diffusion {
        if model.noises.is_empty() {
            return Diffusion::default();
        }
        let accelerations = accelerations(model, forms);
        let noises = model.noises.clone();
        let columns = noises.iter().zip(&accelerations).map(|(noise, accelerations)| {
            let positions = model.positions();
            let rates = positions.iter().map(|position| rate(model, noise, *position)).collect::<Vec<_>>();
            let root = (noise.density, Number::HALF);
            let graph = &mut model.graph;
            let scaled = |entry| graph.product([(entry, Number::ONE), root.clone()]);
            rates.into_iter().chain(accelerations.iter().copied()).map(scaled).collect()
        });
        let columns = columns.collect::<Vec<_>>();
        let kind = kind(model, &columns);
        Diffusion { columns, kind }
    }
}

/// Returns the factor of a noise in the rate of a position.
fn rate(model: &mut Model, noise: &Noise, position: ExprId) -> ExprId {
    let found = noise.rates.iter().find(|(of, _)| *of == position);
    found.map_or_else(|| model.graph.number(0), |(_, factor)| *factor)
}

/// Computes the accelerations due to a unit of each noise, by the cheaper of two factorisations of
/// M.
fn accelerations(model: &mut Model, forms: &mut Forms) -> Vec<Vec<ExprId>> {
    let (velocities, noises) = (model.velocities(), model.noises.clone());
    let linear = noises.iter().map(|noise| {
        let forces = adjoint(&mut model.graph, &noise.loads, &velocities);
        forces.into_iter().map(|force| model.graph.negate(force)).collect::<Vec<_>>()
    });
    let linear = linear.collect::<Vec<_>>();
    let found = solved_each_way(model, forms, &linear);
    cheapest(&model.graph, found).unwrap_or_default()
}

/// Determines the dependence of the diffusions g on the state. All (gⱼ·∇) gₖ vanish if no diffusion
/// depends on an entry that one of them drives. An input counts as such an entry, since a feedback
/// law may make it a function of the state.
fn kind(model: &mut Model, columns: &[Vec<ExprId>]) -> DiffusionKind {
    let entries = columns.concat();
    let is_set = |&input: &usize| model.delays.iter().all(|delay| delay.input != input);
    let inputs = (0..model.inputs.len()).filter(is_set).map(|input| model.inputs[input].symbol);
    let inputs = inputs.collect::<Vec<_>>();
    let by_inputs = jacobian(&mut model.graph, &entries, &inputs).concat();
    if !by_inputs.iter().all(|&slope| model.graph.is_zero(slope)) {
        return DiffusionKind::Multiplicative;
    }
    let state = Dependencies::COORDINATE | Dependencies::VELOCITY | Dependencies::STATE;
    if !entries.iter().any(|&entry| model.graph.dependencies(entry).intersects(state)) {
        return DiffusionKind::Additive;
    }
    let variables = [model.positions(), model.velocities()].concat();
    let graph = &mut model.graph;
    let is_driven = |index: &usize| columns.iter().any(|column| !graph.is_zero(column[*index]));
    let driven = (0..variables.len()).filter(is_driven).map(|index| variables[index]).collect::<Vec<_>>();
    let slopes = jacobian(graph, &entries, &driven).concat();
    match slopes.iter().all(|&slope| graph.is_zero(slope)) {
        true => DiffusionKind::Unambiguous,
        false => DiffusionKind::Multiplicative,
    }
}
