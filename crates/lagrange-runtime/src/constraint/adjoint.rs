//! Adjoints of projections: derivatives of a cost with respect to a projected state, converted into
//! those with respect to the state before and to parameters.
//!
//! A projection moves first the positions and then the velocities by a correction, x′ = x + C(x) r.
//! Residuals R vanish at x′. With derivatives ∂ by an entry of the state or a parameter,
//!
//! ```text
//! ∂x′ = ∂x + C z + (1 + C ∂R/∂x) ∂C r,    ∂R + ∂R/∂x C z = 0,
//! ```
//!
//! up to squares of the correction, where R is evaluated at x′ and C at x, and r = R(x).
//! Derivatives s by x′ thus become w + (∂C r)ᵀ w by x. Here w is the part of s along the
//! constraints, with entries s + (C z)ᵀ s. Derivatives of residuals are differences, which take no
//! corrections.
//!
//! As an example, take R = x² + y² − 1 with unit mass, at (1 + e, 0). The correction of a residual
//! r is C r = −(x, y) r/(2 (x² + y²)). It leads to (1, 0), where w = (0, s₂). With r = 2 e, ∂C r by
//! y is (0, −e). The derivative with respect to y is therefore (1 − e) s₂; the exact one is s₂/(1 +
//! e).

use super::projection::{Residuals, are_zero, correct};
use super::residuals::{gradients_times, largest, size, sizes};
use super::{ConstrainedSystem, are_finite};
use crate::differences;
use crate::linalg::vector::{add, difference, dot};
use crate::scalar::{Number, Scalar};
use crate::system::{
    MechanicalSystem, ParametricSystem, StateVector, join, normalise_described, normalised, split,
};

/// Maximum number of corrections to remove residuals.
const MAX_REMOVALS: u32 = 4;

/// Multiplies derivatives with respect to the projected state, `slope`, by the transposed
/// derivative of [`correct`] at the state `y` before. It writes the products with derivatives with
/// respect to the parameters and inputs at `indices` to `by`. Emitted types define
/// [`ParametricSystem::correct_adjoint`] with this function.
///
/// Returns false if there are none, or if squares of the correction are not negligible. This is so
/// if positions move by more than ∛ε (6·10⁻⁶ for `f64`) times the largest one or one, whichever is
/// less. The slope is then unchanged.
pub fn correct_adjoint<M: ConstrainedSystem + ParametricSystem>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    slope: &mut M::State,
    indices: &[usize],
    by: &mut [M::Scalar],
) -> bool {
    let found = adjoint(system, t, y, slope, (indices, by)).filter(|found| are_finite(found.as_ref()));
    found.inspect(|found| *slope = *found).is_some()
}

fn adjoint<M: ConstrainedSystem + ParametricSystem>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    slope: &M::State,
    (indices, by): (&[usize], &mut [M::Scalar]),
) -> Option<M::State> {
    let mut start = *y;
    normalise_described::<M>(system.description(), &mut start).ok()?;
    let mut end = start;
    correct(system, t, &mut end).ok()?;
    let ((q, v), (to, _)) = (split::<M>(&start), split::<M>(&end));
    let negligible = M::Scalar::epsilon().powf(M::Scalar::from_f64(1.0 / 3.0)) * size(q.as_ref());
    let is_small = largest(system.displacement(t, &q, &to).as_ref()) <= negligible;
    if !is_small {
        return None;
    }
    by.fill(Number::ZERO);
    let middle = join::<M>(&to, &v);
    let mut slope = *slope;
    Move::new(system, t, MovedPart::Velocities, [middle, end]).pull_back(&mut slope, (indices, by))?;
    through_normalisation(system, &middle, &mut slope)?;
    Move::new(system, t, MovedPart::Positions, [start, middle]).pull_back(&mut slope, (indices, by))?;
    through_normalisation(system, y, &mut slope)?;
    Some(slope)
}

/// Converts derivatives with respect to a state with unit quaternions into those by the state
/// before.
fn through_normalisation<M: MechanicalSystem>(system: &M, y: &M::State, slope: &mut M::State) -> Option<()> {
    let description = system.description();
    if description.velocities_are_rates() {
        return Some(());
    }
    let after = *slope;
    add_products(slope, (&[], &mut []), |argument| {
        let Argument::Entry(entry) = argument else { return Some(Number::ZERO) };
        let [product] = differences::slope(M::Scalar::ONE, |by| {
            let mut y = *y;
            y.as_mut()[entry] = y.as_ref()[entry] + by;
            Some([dot(&difference(&normalised::<M>(description, &y), &y), &after)])
        })?;
        Some(product)
    })
}

/// A move of positions or velocities onto the constraints.
struct Move<'a, M: MechanicalSystem> {
    system: &'a M,
    t: M::Scalar,
    part: MovedPart,
    start: M::State,
    end: M::State,
    sizes: M::State,
}

/// The part of a state that moves.
#[derive(Clone, Copy)]
enum MovedPart {
    Positions,
    Velocities,
}

/// An entry of the state, or a parameter or input, by its index.
#[derive(Clone, Copy)]
enum Argument {
    Entry(usize),
    Number(usize),
}

impl<'a, M: ConstrainedSystem + ParametricSystem> Move<'a, M> {
    fn new(system: &'a M, t: M::Scalar, part: MovedPart, [start, end]: [M::State; 2]) -> Self {
        let (q, v) = split::<M>(&start);
        Move { system, t, part, start, end, sizes: join::<M>(&sizes(&q), &sizes(&v)) }
    }

    /// Converts derivatives with respect to the end into derivatives with respect to the start, and
    /// adds to those by parameters.
    fn pull_back(&self, slope: &mut M::State, (indices, by): (&[usize], &mut [M::Scalar])) -> Option<()> {
        let after = *slope;
        add_products(slope, (indices, by), |argument| self.through_residuals(argument, &after))?;
        let (along, residuals) = (*slope, self.residuals(self.system, &self.start));
        if are_zero(residuals.as_ref()) {
            return Some(());
        }
        let change = self.change(self.system, &self.start, &residuals);
        add_products(slope, (indices, by), |argument| {
            let step = M::Scalar::epsilon().sqrt() * self.scale(argument);
            let moved =
                self.moved(&self.start, argument, step, |system, y| self.change(system, y, &residuals));
            Some(dot(&difference(&moved, &change), &along) / step)
        })
    }

    /// Computes (C z)ᵀ s for derivatives s by the end.
    fn through_residuals(&self, argument: Argument, after: &M::State) -> Option<M::Scalar> {
        let scale = self.scale(argument);
        let residuals = differences::slope(M::Scalar::ONE, |by| {
            let residuals =
                self.moved(&self.end, argument, by * scale, |system, y| self.residuals(system, y));
            are_finite(residuals.as_ref()).then_some(residuals)
        })?;
        if are_zero(residuals.as_ref()) {
            return Some(Number::ZERO);
        }
        let (q, _) = split::<M>(&self.start);
        let removal = self.removal(&residuals)?;
        Some(dot(&self.state_change(self.system, &q, &removal), after) / scale)
    }

    /// Computes the combination C z of corrections at the start that removes these residuals at the
    /// end, where ∂R/∂x C is not exactly −1. `None` if there is none, as for dependent constraints
    /// that a parameter brings into contradiction.
    fn removal(&self, residuals: &Residuals<M>) -> Option<M::Velocities> {
        let ((q, v), (end, _)) = (split::<M>(&self.start), split::<M>(&self.end));
        let negligible =
            M::Scalar::epsilon().powf(M::Scalar::from_f64(2.0 / 3.0)) * largest(residuals.as_ref());
        let (mut removal, mut rest) = (v.zeros(), *residuals);
        for _ in 0..MAX_REMOVALS {
            add(&mut removal, Number::ONE, &self.system.correction(self.t, &q, &v, &rest));
            rest = gradients_times(self.system, self.t, &end, &removal);
            add(&mut rest, Number::ONE, residuals);
            if largest(rest.as_ref()) <= negligible {
                return Some(removal);
            }
        }
        None
    }

    fn residuals(&self, system: &M, y: &M::State) -> Residuals<M> {
        let (q, v) = split::<M>(y);
        match self.part {
            MovedPart::Positions => system.position_residuals(self.t, &q),
            MovedPart::Velocities => system.velocity_residuals(self.t, &q, &v),
        }
    }

    /// Computes the change of the state by the correction of these residuals.
    fn change(&self, system: &M, y: &M::State, residuals: &Residuals<M>) -> M::State {
        let (q, v) = split::<M>(y);
        self.state_change(system, &q, &system.correction(self.t, &q, &v, residuals))
    }

    /// Computes the change of the state by a correction at these positions.
    fn state_change(&self, system: &M, q: &M::Coordinates, correction: &M::Velocities) -> M::State {
        match self.part {
            MovedPart::Positions => {
                join::<M>(&system.position_change(self.t, q, correction), &correction.zeros())
            }
            MovedPart::Velocities => join::<M>(&q.zeros(), correction),
        }
    }

    /// Evaluates a function where this argument has changed.
    fn moved<T>(
        &self,
        y: &M::State,
        argument: Argument,
        by: M::Scalar,
        ask: impl FnOnce(&M, &M::State) -> T,
    ) -> T {
        match argument {
            Argument::Entry(entry) => {
                let mut y = *y;
                y.as_mut()[entry] = y.as_ref()[entry] + by;
                ask(self.system, &y)
            }
            Argument::Number(index) => {
                let value = self.system.number(index).unwrap_or(Number::ZERO);
                ask(&self.system.with_number(index, value + by), y)
            }
        }
    }

    /// Returns the magnitude of an argument; one for a parameter that is zero.
    fn scale(&self, argument: Argument) -> M::Scalar {
        match argument {
            Argument::Entry(entry) => self.sizes.as_ref()[entry],
            Argument::Number(index) => {
                let size = self.system.number(index).map_or(Number::ZERO, Number::abs);
                if size == Number::ZERO { Number::ONE } else { size }
            }
        }
    }
}

/// Adds a product to the derivatives with respect to each argument.
fn add_products<S: Scalar>(
    slope: &mut impl StateVector<S>,
    (indices, by): (&[usize], &mut [S]),
    product: impl Fn(Argument) -> Option<S>,
) -> Option<()> {
    for (entry, slope) in slope.as_mut().iter_mut().enumerate() {
        *slope = *slope + product(Argument::Entry(entry))?;
    }
    for (&index, by) in indices.iter().zip(by) {
        *by = *by + product(Argument::Number(index))?;
    }
    Some(())
}
