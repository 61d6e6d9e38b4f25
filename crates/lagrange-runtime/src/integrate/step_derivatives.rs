//! Exact derivatives of steps of fixed length.
//!
//! A step is a composition of products with its length and of evaluations of f(t, y, p).
//! Differentiated line by line, a change δy with the rates δf = J(t, y) δy + ∂f/∂p δp goes through
//! the same composition. The derivatives are therefore those of the step as computed, not of the
//! motion.

use crate::integrate::method::Method;
use crate::linalg::vector::{add, combined, dot};
use crate::scalar::{Number, Scalar};
use crate::system::{
    OdeSystem, ParametricSystem, SettingError, State, StateMatrix, StateVector, StepFailure,
};

/// A method in steps of fixed length whose steps have exact derivatives.
///
/// It needs neither a heap nor `std`, as predictive controllers on microcontrollers require.
#[diagnostic::on_unimplemented(
    message = "steps of `{Self}` have no exact derivatives for `{M}`",
    note = "`RungeKutta4`, `SymplecticEuler`, `StormerVerlet`, `BlanesMoan4` and `GaussLegendre` with `.plain()` have them"
)]
pub trait DifferentiableStep<M: ParametricSystem>: Method<M> {
    /// Computes the state after one step from `y` at time `t`, with its exact derivatives with
    /// respect to the state before. Derivatives with respect to the parameters and inputs at these
    /// indices of [`NUMBERS`](ParametricSystem::NUMBERS) follow as well. Inputs are constant during
    /// the step.
    ///
    /// The step is neither checked for stability nor projected onto constraints, and a negative
    /// length steps backwards in time. An explicit method evaluates the Jacobian as
    /// often as the right-hand side, `GaussLegendre` once per stage and once more.
    ///
    /// # Errors
    /// If the system has no exact derivatives; emitted types have them with `emit { jacobian }`.
    /// Also if the method keeps constraints of the system itself, if a result is not finite, or if
    /// an implicit step does not converge.
    ///
    /// # Panics
    /// If there is no parameter or input at an index.
    ///
    /// ```
    /// use lagrange::integrate::{DifferentiableStep, RungeKutta4};
    ///
    /// lagrange::system! {
    ///     struct Cart;
    ///     param m = 2.0;
    ///     coord x;
    ///     input push;
    ///     kinetic = 1/2 * m * dot(x)^2;
    ///     force x = push;
    ///     emit { jacobian }
    /// }
    ///
    /// // A discrete-time model x⁺ = A x + B u, as for predictive control.
    /// let method = RungeKutta4 { step: 0.1 };
    /// let step = method.step_derivatives(&Cart::default(), 0.0, &[0.0, 1.0], [1]).unwrap();
    /// assert_eq!(step.by_state, [[1.0, 0.1], [0.0, 1.0]]);
    /// let [[x, v]] = step.by_numbers;
    /// assert!((x - 0.005 / 2.0).abs() < 1e-17 && (v - 0.1 / 2.0).abs() < 1e-16);
    /// ```
    fn step_derivatives<const K: usize>(
        &self,
        system: &M,
        t: M::Scalar,
        y: &M::State,
        indices: [usize; K],
    ) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>>;
}

/// A step with its derivatives, from [`DifferentiableStep::step_derivatives`]. Y is the state, and
/// J a matrix of its dimension.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StepDerivatives<Y, J, const K: usize> {
    /// The state y⁺ after the step.
    pub end: Y,
    /// ∂y⁺/∂y in rows, with ∂y⁺ᵢ/∂yⱼ as entry i, j.
    pub by_state: J,
    /// ∂y⁺/∂p, one column for each of the parameters and inputs.
    pub by_numbers: [Y; K],
}

/// A step of the system M with its derivatives.
pub(super) type StepDerivativesOf<M, const K: usize> = StepDerivatives<State<M>, StateMatrix<M>, K>;

/// The derivatives of f at a place: ∂f/∂y in rows and ∂f/∂p in columns.
pub(super) struct Slopes<M: ParametricSystem, const K: usize> {
    jacobian: StateMatrix<M>,
    by_numbers: [M::State; K],
}

impl<M: ParametricSystem, const K: usize> Slopes<M, K> {
    /// Returns derivatives of zero.
    pub(super) fn zeros(y: &M::State) -> Self {
        Slopes { jacobian: y.zero_square(), by_numbers: [y.zeros(); K] }
    }

    /// Evaluates the derivatives.
    ///
    /// # Errors
    /// If the system has none.
    pub(super) fn at(
        system: &M,
        t: M::Scalar,
        y: &M::State,
        indices: &[usize; K],
    ) -> Result<Self, StepFailure<M::Scalar>> {
        let missing = || SettingError::Invalid("a step has exact derivatives only with `emit { jacobian }`");
        let jacobian = system.jacobian(t, y).ok_or_else(missing)?;
        let mut by_numbers = [y.zeros(); K];
        if K > 0 && !system.derivatives(t, y, indices, &mut by_numbers) {
            return Err(missing().into());
        }
        Ok(Slopes { jacobian, by_numbers })
    }

    /// Computes J δy + ∂f/∂p for the variable with this index: states come first, then numbers.
    pub(super) fn along(&self, variable: usize, change: &M::State) -> M::State {
        let number = variable.checked_sub(change.as_ref().len());
        let mut rates = number.map_or(change.zeros(), |number| self.by_numbers[number]);
        for (rate, row) in rates.as_mut().iter_mut().zip(self.jacobian.as_ref()) {
            *rate = *rate + dot(row, change);
        }
        rates
    }
}

/// The derivatives of a state or of its rates, a column for each variable.
pub(super) struct DerivativeColumns<M: OdeSystem, const K: usize> {
    by_state: StateMatrix<M>,
    by_numbers: [M::State; K],
}

impl<M: ParametricSystem, const K: usize> DerivativeColumns<M, K> {
    /// Returns columns of zeros.
    pub(super) fn zeros(y: &M::State) -> Self {
        DerivativeColumns { by_state: y.zero_square(), by_numbers: [y.zeros(); K] }
    }

    /// Returns the derivatives of the state before a step.
    pub(super) fn start(y: &M::State) -> Self {
        let mut start = Self::zeros(y);
        for (index, column) in start.by_state.as_mut().iter_mut().enumerate() {
            column.as_mut()[index] = M::Scalar::ONE;
        }
        start
    }

    /// Replaces each column, given the index of its variable.
    pub(super) fn update(&mut self, mut column: impl FnMut(usize, &mut M::State)) {
        self.iter_mut().enumerate().for_each(|(variable, values)| column(variable, values));
    }

    fn iter_mut(&mut self) -> impl Iterator<Item = &mut M::State> {
        self.by_state.as_mut().iter_mut().chain(&mut self.by_numbers)
    }

    fn iter(&self) -> impl Iterator<Item = &M::State> {
        self.by_state.as_ref().iter().chain(&self.by_numbers)
    }

    /// Adds c times other columns.
    pub(super) fn add(&mut self, c: M::Scalar, other: &Self) {
        self.iter_mut().zip(other.iter()).for_each(|(column, other)| add(column, c, other));
    }

    /// Replaces rates by those at self + c · rates, where f has these derivatives.
    pub(super) fn rates_at(&self, c: M::Scalar, rates: &mut Self, slopes: &Slopes<M, K>) {
        for (variable, (rate, start)) in rates.iter_mut().zip(self.iter()).enumerate() {
            *rate = slopes.along(variable, &combined(start, c, rate));
        }
    }

    /// Returns these derivatives of the state at the end of a step.
    ///
    /// # Errors
    /// If a number is not finite.
    pub(super) fn of_end(self, end: M::State) -> Result<StepDerivativesOf<M, K>, StepFailure<M::Scalar>> {
        let is_finite = |column: &M::State| column.as_ref().iter().all(|entry| entry.is_finite());
        if !is_finite(&end) || !self.iter().all(is_finite) {
            return Err(StepFailure::NotFinite);
        }
        let mut by_state = end.zero_square();
        for (index, row) in by_state.as_mut().iter_mut().enumerate() {
            for (entry, column) in row.as_mut().iter_mut().zip(self.by_state.as_ref()) {
                *entry = column.as_ref()[index];
            }
        }
        Ok(StepDerivatives { end, by_state, by_numbers: self.by_numbers })
    }
}
