//! Constraints of interpreted systems, and projections onto them, as for emitted types.

use lagrange_core::model::Product;
use lagrange_runtime::constraint::{self, ConstrainedSystem};
use lagrange_runtime::system::{StateVector, StepFailure, normalise_described};

use crate::inline::Inline;
use crate::system::DynamicSystem;

type Outcome = Result<(), StepFailure<f64>>;

impl<const CAPACITY: usize> DynamicSystem<CAPACITY> {
    fn is_held(&self) -> bool {
        self.programs().layout.multipliers > 0
    }

    /// True if states are projected onto constraints after each step instead of being stabilised.
    pub(crate) fn is_projected(&self) -> bool {
        self.is_held() && !self.programs().variables.is_stabilised
    }

    pub(crate) fn put_on_constraints(&self, t: f64, y: &mut Inline<CAPACITY>) -> Outcome {
        match self.is_projected() {
            true => constraint::correct(self, t, y)?,
            false => self.normalised(y)?,
        }
        self.touches(t, y)
    }

    pub(crate) fn admit_to_constraints(&self, t: f64, y: &mut Inline<CAPACITY>) -> Outcome {
        if self.is_held() { constraint::admit(self, t, y) } else { self.normalised(y) }?;
        self.touches(t, y)
    }

    pub(crate) fn restore_to_constraints(&self, t: f64, y: &mut Inline<CAPACITY>) -> Outcome {
        if self.is_held() { constraint::restore(self, t, y) } else { self.normalised(y) }?;
        self.touches(t, y)
    }

    fn normalised(&self, y: &mut Inline<CAPACITY>) -> Outcome {
        match self.names.description.quaternions {
            [] => Ok(()),
            _ => normalise_described::<Self>(&self.names.description, y),
        }
    }

    /// Returns a product that systems with constraints always have; NaN otherwise.
    fn of_constraints(&self, product: Product, t: f64, q: &[f64], v: &[f64], length: usize) -> Vec<f64> {
        self.numeric.product(product, t, q, v).unwrap_or_else(|| vec![f64::NAN; length])
    }

    fn touches(&self, t: f64, y: &mut Inline<CAPACITY>) -> Outcome {
        if self.is_touching() { self.correct_touching(t, y) } else { Ok(()) }
    }
}

impl<const CAPACITY: usize> ConstrainedSystem for DynamicSystem<CAPACITY> {
    type Multipliers = Inline<CAPACITY>;

    const CONSTRAINTS: &'static [&'static str] = &[];

    fn constraint_names(&self) -> &'static [&'static str] {
        self.names.layout.constraints
    }

    fn multipliers(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let (q, v) = (q.as_ref(), v.as_ref());
        if !self.is_touching() {
            return Inline::of(&self.numeric.multipliers(t, q, v));
        }
        let [_, reactions] = self.accelerations_and_reactions(t, q, v);
        Inline::of(&self.numeric.multipliers_under(t, q, v, &reactions))
    }

    /// Residuals do not depend on velocities, which are set to zero.
    fn position_residuals(&self, t: f64, q: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let (programs, at_rest) = (self.programs(), vec![0.0; self.programs().layout.velocities]);
        Inline::of(&self.numeric.evaluate(&programs.position_residuals, t, q.as_ref(), &at_rest))
    }

    fn velocity_residuals(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let count = self.programs().layout.multipliers;
        Inline::of(&self.of_constraints(Product::ConstraintVelocity, t, q.as_ref(), v.as_ref(), count))
    }

    fn residual_scales(&self, t: f64, q: &Inline<CAPACITY>, by: &Inline<CAPACITY>) -> Inline<CAPACITY> {
        let layout = &self.programs().layout;
        let (at_rest, entries) = (vec![0.0; layout.velocities], layout.multipliers * layout.velocities);
        let jacobian = self.of_constraints(Product::ConstraintJacobian, t, q.as_ref(), &at_rest, entries);
        let scale = |row: &[f64]| {
            row.iter().zip(by.as_ref()).fold(0.0, |sum, (entry, share)| sum + entry.abs() * share)
        };
        Inline::of(&jacobian.chunks(layout.velocities.max(1)).map(scale).collect::<Vec<_>>())
    }

    fn correction(
        &self,
        t: f64,
        q: &Inline<CAPACITY>,
        v: &Inline<CAPACITY>,
        residuals: &Inline<CAPACITY>,
    ) -> Inline<CAPACITY> {
        Inline::of(&self.numeric.correction(t, q.as_ref(), v.as_ref(), residuals.as_ref()))
    }

    fn mass_times(
        &self,
        t: f64,
        q: &Inline<CAPACITY>,
        v: &Inline<CAPACITY>,
        change: &Inline<CAPACITY>,
    ) -> Inline<CAPACITY> {
        Inline::of(&self.numeric.mass_times(t, q.as_ref(), v.as_ref(), change.as_ref()))
    }
}
