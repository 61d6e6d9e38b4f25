//! States with measured forces, as linear equations.

use std::vec::Vec;

use super::base::BaseParameters;
use super::error::IdentificationError;
use super::estimate::Estimate;
use crate::linalg::vector::StateVector;
use crate::spread::spread;
use crate::system::RegressorSystem;

/// Reach of positions, velocities, accelerations and times of states that look random.
const REACH: f64 = 3.0;
/// Number of forces in such states for each parameter.
const FORCES_EACH: usize = 8;
/// Maximum number of halvings of the reach for states in which the system is not defined.
const HALVINGS: i32 = 8;
/// Maximum number of states tried for each required one.
const TRIALS_EACH: usize = 64;

/// States with measured forces.
#[derive(Clone, Debug)]
pub struct Regression<'a, M: RegressorSystem<Scalar = f64>> {
    system: &'a M,
    /// Columns of the regressors, one below the other.
    columns: Vec<Vec<f64>>,
    /// Forces that the columns explain: those measured without the rest of the inverse dynamics.
    forces: Vec<f64>,
    /// Number of forces of a state.
    velocities: usize,
}

impl<'a, M: RegressorSystem<Scalar = f64>> Regression<'a, M> {
    pub(super) fn new(system: &'a M) -> Self {
        let columns = std::vec![Vec::new(); M::REGRESSOR_PARAMETERS.len()];
        Regression { system, columns, forces: Vec::new(), velocities: M::Velocities::ZERO.as_ref().len() }
    }

    /// Adds a state with its accelerations and the measured generalised forces. These are forces in
    /// addition to the declared ones, as computed by the inverse dynamics.
    pub fn add(
        &mut self,
        t: f64,
        q: &M::Coordinates,
        v: &M::Velocities,
        a: &M::Velocities,
        forces: &M::Velocities,
    ) -> &mut Self {
        let regressor = self.system.regressor(t, q, v, a);
        let parameters = self.system.regressor_parameters();
        let inverse_dynamics = self.system.inverse_dynamics(t, q, v, a);
        let rows = regressor.as_ref().iter().zip(inverse_dynamics.as_ref()).zip(forces.as_ref());
        for ((row, computed), measured) in rows {
            let explained = row.as_ref().iter().zip(parameters.as_ref()).map(|(y, p)| y * p).sum::<f64>();
            self.forces.push(measured - computed + explained);
            for (column, entry) in self.columns.iter_mut().zip(row.as_ref()) {
                column.push(*entry);
            }
        }
        self
    }

    /// Adds states that look random, with the forces of the system. Those in which it is not
    /// defined are moved towards zero, and left out if that does not help.
    pub(super) fn add_spread_states(&mut self) -> Result<(), IdentificationError> {
        let parameters = self.system.regressor_parameters();
        if let Some(place) = parameters.as_ref().iter().position(|parameter| !parameter.is_finite()) {
            return Err(IdentificationError::UndefinedParameter { name: M::REGRESSOR_PARAMETERS[place] });
        }
        let wanted = (FORCES_EACH * self.columns.len()).div_ceil(self.velocities.max(1));
        let trials = TRIALS_EACH * wanted;
        let is_added = |state: &usize| (0..HALVINGS).any(|halving| self.add_spread_state(*state, halving));
        let added = (0..trials).filter(is_added).take(wanted).count();
        if added == 0 && trials > 0 { Err(IdentificationError::Undefined { reach: REACH }) } else { Ok(()) }
    }

    /// Adds a state that looks random, within a reach that is halved so often; whether the system
    /// is defined there.
    fn add_spread_state(&mut self, state: usize, halvings: i32) -> bool {
        let (mut next, reach) = (0, REACH * 0.5_f64.powi(halvings));
        let mut entries = |vector: &mut [f64]| {
            for entry in vector {
                *entry = reach * spread::<f64>(state, next);
                next += 1;
            }
        };
        let (mut q, [mut v, mut a], mut t) = (M::Coordinates::ZERO, [M::Velocities::ZERO; 2], [0.0]);
        entries(q.as_mut());
        entries(v.as_mut());
        entries(a.as_mut());
        entries(&mut t);
        M::normalise(&mut q);
        let (forces, before) = (self.system.inverse_dynamics(t[0], &q, &v, &a), self.forces.len());
        self.add(t[0], &q, &v, &a, &forces);
        let is_defined = self.undefined_row(before).is_none();
        if !is_defined {
            self.forces.truncate(before);
            self.columns.iter_mut().for_each(|column| column.truncate(before));
        }
        is_defined
    }

    /// Finds the combinations of parameters that forces in these states determine.
    ///
    /// # Errors
    /// If a parameter, state or force is not finite.
    pub fn base_parameters(&self) -> Result<BaseParameters, IdentificationError> {
        self.check_finite()?;
        let known = self.system.regressor_parameters();
        Ok(BaseParameters::of(M::REGRESSOR_PARAMETERS, known.as_ref(), &self.columns))
    }

    /// Estimates these combinations from the measured forces. Parameters that forces do not tell
    /// keep the values of the system.
    ///
    /// # Errors
    /// If something is not finite, or there are too few states.
    pub fn estimate(&self) -> Result<Estimate, IdentificationError> {
        let base = self.base_parameters()?;
        let (forces, combinations) = (self.forces.len(), base.parameters().len());
        if forces <= combinations {
            return Err(IdentificationError::TooFew { forces, combinations });
        }
        let known = self.system.regressor_parameters();
        Ok(Estimate::of(
            M::REGRESSOR_PARAMETERS,
            known.as_ref(),
            (&self.columns, &self.forces),
            self.velocities,
            &base,
        ))
    }

    fn check_finite(&self) -> Result<(), IdentificationError> {
        match self.undefined_row(0) {
            Some(row) => Err(IdentificationError::NotFinite { state: row / self.velocities.max(1) }),
            None => Ok(()),
        }
    }

    /// Returns the first row from this one on that is not finite.
    fn undefined_row(&self, from: usize) -> Option<usize> {
        (from..self.forces.len()).find(|&row| {
            let entries = self.columns.iter().map(|column| column[row]).chain([self.forces[row]]);
            entries.into_iter().any(|entry| !entry.is_finite())
        })
    }
}
