//! The equations of an equilibrium at a point of the search, with their derivatives.

use std::vec::Vec;

use super::{EquilibriumGuess, EquilibriumSearch};
use crate::linalg::dense::DenseMatrix;
use crate::linear::error::{Equation, EquilibriumCause, Undetermined};
use crate::linear::names::Names;
use crate::linear::tangent::{Blocks, first_undefined};
use crate::system::{Component, LinearisedSystem, split};

/// Derivatives of an equation that are all below this fraction of the largest derivative are
/// rounding.
pub(super) const FLAT: f64 = 1e-10;

/// The equations at a point, linearised.
pub(super) struct LocalEquations {
    /// Derivatives of the equations by the unknowns, which are in units of their scales; the
    /// largest in each row is about one.
    pub(super) jacobian: DenseMatrix,
    /// Values of the equations.
    pub(super) residuals: Vec<f64>,
    /// Factors of the rows.
    pub(super) weights: Vec<f64>,
    /// Magnitudes of the unknowns.
    pub(super) scales: Vec<f64>,
}

impl LocalEquations {
    /// Returns residuals in units of their rows.
    pub(super) fn weighted(&self, residuals: &[f64]) -> Vec<f64> {
        residuals.iter().zip(&self.weights).map(|(residual, weight)| residual * weight).collect()
    }
}

impl<M> EquilibriumSearch<'_, M>
where
    M: LinearisedSystem,
    M::Scalar: Into<f64>,
{
    /// Returns the values of all equations: accelerations, rates of first-order states, constraints
    /// on positions.
    pub(super) fn residuals(&self, point: &EquilibriumGuess<M>) -> Vec<f64> {
        let (q, v) = split::<M>(&point.y);
        let Names { state, .. } = self.names;
        self.ask(point, |system| {
            let rates = system.rhs(self.time, &point.y);
            let [positions, _] = system.residuals(self.time, &q, &v);
            let held = self.names.holonomic().map(|(index, _)| &positions.as_ref()[index]);
            let changing = &rates.as_ref()[self.names.first_state()..];
            let (states, accelerations) = changing.split_at(state.first_order_states);
            accelerations.iter().chain(states).chain(held).map(|&value| value.into()).collect()
        })
    }

    /// Returns the name of an equation.
    pub(super) fn equation(&self, index: usize) -> Equation {
        let (n, state) = (self.names.freedoms(), self.names.state);
        if index < n {
            return Equation::Acceleration(
                Component::of_velocity(state, index).unwrap_or(Component::Index(index)),
            );
        }
        let states = &state.coordinates[self.names.first_state()..];
        if let Some(name) = states.get(index - n) {
            return Equation::Rate(name);
        }
        let held = self.names.holonomic().nth(index - n - states.len());
        Equation::Constraint(held.map_or("", |(_, name)| name))
    }

    /// Returns the equations at a point, linearised.
    ///
    /// # Errors
    /// If a derivative is undefined there.
    pub(super) fn linearised(
        &self,
        point: &EquilibriumGuess<M>,
        unknowns: &[usize],
    ) -> Result<LocalEquations, EquilibriumCause<M::Scalar>> {
        let blocks = self.ask(point, |system| Blocks::of(system, self.time, &point.y));
        if let Some(place) = first_undefined(&blocks.matrix) {
            return Err(EquilibriumCause::Derivative(Undetermined::of(&self.names, place)));
        }
        let (first, n) = (blocks.velocities(), blocks.freedoms);
        let rates = blocks.matrix.part(&(first..first + n).chain(n..first).collect::<Vec<_>>(), unknowns);
        let gradients = self.names.holonomic().map(|(index, _)| blocks.constraint_row(index));
        let gradients = gradients.collect::<Vec<_>>();
        // Gradients of constraints by displacements are those of their rates by velocities.
        let gradient = |row: usize, unknown: usize| match unknown < n {
            true => blocks.matrix[(gradients[row], first + unknown)],
            false => 0.0,
        };
        let scales = self.scales(point, unknowns);
        let count = rates.rows();
        let scaled = DenseMatrix::from_fn(count + gradients.len(), unknowns.len(), |i, j| {
            let slope = if i < count { rates[(i, j)] } else { gradient(i - count, unknowns[j]) };
            slope * scales[j]
        });
        let largest = scaled.largest();
        let weight = |row: usize| {
            let size = scaled.row(row).iter().fold(0.0, |most: f64, slope| most.max(slope.abs()));
            let size = if size > FLAT * largest { size } else { largest };
            if size > 0.0 { 1.0 / size } else { 1.0 }
        };
        let weights = (0..scaled.rows()).map(weight).collect::<Vec<_>>();
        let jacobian =
            DenseMatrix::from_fn(scaled.rows(), scaled.columns(), |i, j| weights[i] * scaled[(i, j)]);
        Ok(LocalEquations { jacobian, residuals: self.residuals(point), weights, scales })
    }

    /// Returns the magnitude of each unknown, at least one. Displacements of orientations are
    /// angles.
    fn scales(&self, point: &EquilibriumGuess<M>, unknowns: &[usize]) -> Vec<f64> {
        let (n, system) = (self.names.freedoms(), self.names.state);
        let tangent = 2 * n + system.first_order_states;
        let value = |unknown: &usize| match *unknown {
            input if input >= tangent => point.inputs[input - tangent].into(),
            state if state >= n => point.y.as_ref()[self.names.first_state() + state - n].into(),
            position if system.velocities_are_rates() => point.y.as_ref()[position].into(),
            position => match system.coordinates.iter().position(|name| *name == system.rates_of[position]) {
                Some(position) => point.y.as_ref()[position].into(),
                None => 1.0,
            },
        };
        unknowns.iter().map(|unknown| value(unknown).abs().max(1.0)).collect()
    }
}
