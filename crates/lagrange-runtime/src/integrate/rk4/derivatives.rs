//! Exact derivatives of a step.
//!
//! The rates of the stages, kᵢ = f(yᵢ), have the derivatives ∂kᵢ = J(yᵢ) ∂yᵢ + ∂f/∂p. Those of the
//! stages yᵢ = y + cᵢ h kᵢ₋₁ follow from them. These are the stages of the variational equations.

use super::RungeKuttaStages;
use crate::linalg::vector::{add, combined, dot};
use crate::scalar::{Number, Scalar};
use crate::system::{ParametricSystem, StateMatrix, StateVector};

/// A step with its derivatives, from [`rk4_step_derivatives`]. Y is the state, and J a matrix of
/// its dimension.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct StepDerivatives<Y, J, const K: usize> {
    /// The state y⁺ after the step.
    pub end: Y,
    /// ∂y⁺/∂y in rows, with ∂y⁺ᵢ/∂yⱼ as entry i, j.
    pub by_state: J,
    /// ∂y⁺/∂p, one column for each of the parameters and inputs.
    pub by_numbers: [Y; K],
}

/// Computes the state after one [`rk4_step`](super::rk4_step) and its exact derivatives by the
/// state before. Derivatives by the parameters and inputs at these indices of
/// [`NUMBERS`](ParametricSystem::NUMBERS) follow as well. Inputs are constant during the step.
/// States are not projected onto constraints.
///
/// It evaluates the right-hand side and its Jacobian four times, without a heap. `None` if the
/// system has no exact derivatives: emitted types have them with `emit { jacobian }`.
///
/// ```
/// use lagrange::integrate::rk4_step_derivatives;
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
/// let step = rk4_step_derivatives(&Cart::default(), 0.0, &[0.0, 1.0], 0.1, [1]).unwrap();
/// assert_eq!(step.by_state, [[1.0, 0.1], [0.0, 1.0]]);
/// let [[x, v]] = step.by_numbers;
/// assert!((x - 0.005 / 2.0).abs() < 1e-17 && (v - 0.1 / 2.0).abs() < 1e-16);
/// ```
pub fn rk4_step_derivatives<M: ParametricSystem, const K: usize>(
    system: &M,
    t: M::Scalar,
    y: &M::State,
    h: M::Scalar,
    indices: [usize; K],
) -> Option<StepDerivatives<M::State, StateMatrix<M>, K>> {
    let (half, sixth) = (h / M::Scalar::from_f64(2.0), h / M::Scalar::from_f64(6.0));
    let third = h / M::Scalar::from_f64(3.0);
    let nodes = [(M::Scalar::ZERO, sixth), (half, third), (half, third), (h, sixth)];
    let mut rates = [y.zeros(); 4];
    let mut by_state = VariedColumns { slopes: y.zero_square(), sums: y.zero_square() };
    let mut by_numbers = VariedColumns { slopes: [y.zeros(); K], sums: [y.zeros(); K] };
    for (stage, node) in nodes.into_iter().enumerate() {
        let (time, before) = (t + node.0, stage.checked_sub(1).map_or(y.zeros(), |before| rates[before]));
        let place = combined(y, node.0, &before);
        rates[stage] = system.rhs(time, &place);
        let jacobian = system.jacobian(time, &place)?;
        let mut own = [y.zeros(); K];
        if K > 0 && !system.derivatives(time, &place, &indices, &mut own) {
            return None;
        }
        let start = |column: usize| unit(y, column);
        by_state.advance(jacobian.as_ref(), node, start, |_| y.zeros());
        by_numbers.advance(jacobian.as_ref(), node, |_| y.zeros(), |column| own[column]);
    }
    let [k1, k2, k3, k4] = rates;
    let end = combined(y, M::Scalar::ONE, &RungeKuttaStages { k1, k2, k3, k4 }.increment(h));
    let mut rows = transposed::<_, M::State>(y, by_state.sums.as_ref());
    for (index, row) in rows.as_mut().iter_mut().enumerate() {
        row.as_mut()[index] = row.as_ref()[index] + M::Scalar::ONE;
    }
    Some(StepDerivatives { end, by_state: rows, by_numbers: by_numbers.sums })
}

/// Derivatives in columns: of the rates of the last stage, and of the increment so far.
struct VariedColumns<C> {
    slopes: C,
    sums: C,
}

impl<C> VariedColumns<C> {
    /// Adds a stage, given the derivatives of its start and those of f by the variables themselves.
    fn advance<S: Scalar, Y: StateVector<S>>(
        &mut self,
        jacobian: &[Y],
        (after, weight): (S, S),
        start: impl Fn(usize) -> Y,
        own: impl Fn(usize) -> Y,
    ) where
        C: AsMut<[Y]>,
    {
        let columns = self.slopes.as_mut().iter_mut().zip(self.sums.as_mut());
        for (column, (slope, sum)) in columns.enumerate() {
            let change = combined(&start(column), after, slope);
            *slope = own(column);
            for (entry, row) in slope.as_mut().iter_mut().zip(jacobian) {
                *entry = *entry + dot(row, &change);
            }
            add(sum, weight, slope);
        }
    }
}

/// Returns the direction of an entry of the state.
fn unit<S: Scalar, Y: StateVector<S>>(y: &Y, entry: usize) -> Y {
    let mut unit = y.zeros();
    unit.as_mut()[entry] = S::ONE;
    unit
}

/// Returns the rows of a matrix in columns.
fn transposed<S: Scalar, Y: StateVector<S>>(y: &Y, columns: &[Y]) -> Y::Square {
    let mut rows = y.zero_square();
    for (index, row) in rows.as_mut().iter_mut().enumerate() {
        for (entry, column) in row.as_mut().iter_mut().zip(columns) {
            *entry = column.as_ref()[index];
        }
    }
    rows
}
