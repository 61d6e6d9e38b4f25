//! Products of a model other than accelerations and both sides of M q̈ = f.

use super::centroidal::{center_of_mass, centroidal_momentum, centroidal_momentum_matrix};
use super::constraints::ConstraintEquations;
use super::coriolis::coriolis_matrix;
use super::elimination::solution::{Solution, push_down};
use super::energy_function::energy_function;
use super::event_jacobian::event_jacobian;
use super::forms::Forms;
use super::inverse_dynamics::{inverse_dynamics_jacobian, residual};
use super::inverse_mass_matrix::inverse_mass_matrix;
use super::jacobian::{Derivatives, lagrangian_hessian};
use super::least_constraint::{SplitLagrangian, Terms};
use super::quadratic_form::QuadraticForm;
use super::responses::{ReactionEquations, reaction_forces};
use super::strategies::Strategy;
use super::virtual_displacements::{add_slopes, add_turning, applied_forces};
use crate::model::{Model, Product};
use lagrange_algebra::calculus::{AccelerationTerms, gradient};
use lagrange_expr::expr::ExprId;

/// The solution of a motion, from which products follow.
pub(super) struct SolvedMotion<'a> {
    pub(super) solution: &'a Solution,
    pub(super) strategy: Strategy,
    pub(super) constraints: &'a ConstraintEquations,
    pub(super) reactions: &'a ReactionEquations,
}

/// Requested products.
pub(super) struct DerivedProducts {
    /// The products in the order of their requests, derivatives first; matrices row by row.
    pub(super) products: Vec<(Product, Vec<ExprId>)>,
    /// ∂L/∂q + Q, by which the momenta change without constraints, if requested.
    pub(super) free_momentum_rates: Option<Vec<ExprId>>,
}

/// Generalised forces that several products contain.
struct Forces {
    /// Applied forces, if requested.
    applied: Vec<ExprId>,
    /// Forces of contacts and friction.
    touching: Vec<ExprId>,
}

impl SolvedMotion<'_> {
    /// Derives the requested products.
    pub(super) fn products(
        &self,
        model: &mut Model,
        split: &SplitLagrangian,
        forms: &mut Forms,
    ) -> DerivedProducts {
        let mut products = jacobians(model, split, forms, (self.solution, self.strategy));
        let wants = |product| model.products.contains(&product);
        let [wants_rates, wants_forces] = [Product::MomentumRates, Product::GeneralisedForces].map(wants);
        let applied = if wants_rates || wants_forces { applied_forces(model) } else { Vec::new() };
        let rates = wants_rates.then(|| free_momentum_rates(model, &applied));
        let forces = Forces { applied, touching: reaction_forces(model, self.reactions) };
        let mut free = None;
        for product in model.products.clone() {
            let found = match (product, &rates) {
                (Product::MomentumRates, Some(rates)) => {
                    let held = sums(model, rates, &[&self.constraints.forces, &forces.touching]);
                    free = Some(sums(model, rates, &[&[], &forces.touching]));
                    Some(held)
                }
                _ => self.product(model, split, &forces, product),
            };
            products.extend(found.map(|found| (product, found)));
        }
        DerivedProducts { products, free_momentum_rates: free }
    }

    /// Derives a product; `None` if it is derived elsewhere or does not exist.
    fn product(
        &self,
        model: &mut Model,
        split: &SplitLagrangian,
        Forces { applied, touching }: &Forces,
        product: Product,
    ) -> Option<Vec<ExprId>> {
        let found = match product {
            Product::Bias => residual(model, split, AccelerationTerms::Dropped, Terms::Inertial),
            Product::CoriolisMatrix => coriolis_matrix(model, split),
            Product::CenterOfMass => center_of_mass(model),
            Product::CentroidalMomentum => centroidal_momentum(model),
            Product::CentroidalMomentumMatrix => centroidal_momentum_matrix(model),
            Product::EventJacobian => {
                event_jacobian(model, &self.solution.values, &self.constraints.multipliers)
            }
            Product::InverseDynamicsJacobian => inverse_dynamics_jacobian(model, split),
            Product::InverseMassMatrix => inverse_mass_matrix(model, split)?,
            Product::Momenta => {
                let velocities = model.velocities();
                gradient(&mut model.graph, model.lagrangian, &velocities)
            }
            Product::Energy => vec![energy_function(model)],
            Product::Lagrangian => vec![model.lagrangian],
            Product::LagrangianHessian => lagrangian_hessian(model),
            Product::GeneralisedForces => sums(model, applied, &[&self.constraints.forces, touching]),
            Product::InverseDynamics => residual(model, split, AccelerationTerms::Kept, Terms::All),
            _ => return None,
        };
        Some(found)
    }
}

/// Computes the requested derivatives of accelerations, by the state and by parameters and inputs.
fn jacobians(
    model: &mut Model,
    split: &SplitLagrangian,
    forms: &mut Forms,
    (solution, strategy): (&Solution, Strategy),
) -> Vec<(Product, Vec<ExprId>)> {
    let wanted = model.products.iter().copied().filter(|product| product.is_derivative());
    let wanted = wanted.collect::<Vec<_>>();
    if wanted.is_empty() {
        return Vec::new();
    }
    let derivatives = Derivatives::new(model, split, forms, (&solution.values, strategy));
    let state = [model.positions(), model.velocities()].concat();
    let constants = model.parameters.iter().chain(&model.inputs).map(|parameter| parameter.symbol);
    let constants = constants.collect::<Vec<_>>();
    let with_inputs = [&state[..], &constants[model.parameters.len()..]].concat();
    let derived = |product| {
        let arguments = match product {
            Product::ParameterJacobian => &constants,
            Product::SystemMatrix => &with_inputs,
            _ => &state,
        };
        let slopes = derivatives.by(model, arguments).concat();
        (product, solution.balanced(&mut model.graph, &slopes))
    };
    wanted.into_iter().map(derived).collect()
}

/// Computes ∂L/∂q + Q, which equals the rate of ∂L/∂v by Lagrange's equations, unless constraints
/// act. An angular momentum p in rotating axes also changes by −ω × p.
fn free_momentum_rates(model: &mut Model, forces: &[ExprId]) -> Vec<ExprId> {
    let (positions, velocities) = (model.positions(), model.velocities());
    let slopes = gradient(&mut model.graph, model.lagrangian, &positions);
    let mut form = QuadraticForm::default();
    add_slopes(model, &mut form, &slopes);
    if !model.orientations.is_empty() {
        let momenta = gradient(&mut model.graph, model.lagrangian, &velocities);
        add_turning(model, &mut form, &momenta);
    }
    let graph = &mut model.graph;
    let form = push_down(graph, form, &velocities);
    let rates = velocities.iter().zip(forces).map(|(&velocity, &force)| {
        let slope = form.linear(graph, velocity);
        graph.subtract(force, slope)
    });
    rates.collect()
}

/// Adds the corresponding entries of `added`, if any, to each of `values`.
fn sums(model: &mut Model, values: &[ExprId], added: &[&[ExprId]]) -> Vec<ExprId> {
    let sum = |(i, &value): (usize, &ExprId)| {
        let terms = added.iter().filter_map(|list| list.get(i).copied()).chain([value]).collect::<Vec<_>>();
        model.graph.total(terms)
    };
    values.iter().enumerate().map(sum).collect()
}
