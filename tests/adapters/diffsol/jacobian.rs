//! Jacobians for methods that require them.

use lagrange::scalar::{Number, Scalar};
use lagrange::system::{OdeSystem, StateMatrix, StateVector};

/// Returns ∂f/∂y in rows: the system's own, or central differences, accurate to about two thirds of
/// the digits of f.
pub(crate) fn jacobian<M: OdeSystem + ?Sized>(system: &M, t: M::Scalar, y: &M::State) -> StateMatrix<M> {
    let is_finite = |jacobian: &StateMatrix<M>| {
        jacobian.as_ref().iter().all(|row| row.as_ref().iter().all(|entry| entry.is_finite()))
    };
    system.jacobian(t, y).filter(is_finite).unwrap_or_else(|| central_differences(system, t, y))
}

fn central_differences<M: OdeSystem + ?Sized>(system: &M, t: M::Scalar, y: &M::State) -> StateMatrix<M> {
    let mut rows = M::State::ZERO_SQUARE;
    // Balances the truncated cubic terms with the rounding of f.
    let part = M::Scalar::epsilon().powf(M::Scalar::from_f64(1.0 / 3.0));
    for column in 0..y.as_ref().len() {
        let step = part * y.as_ref()[column].abs().max(M::Scalar::ONE);
        let (mut below, mut above) = (*y, *y);
        below.as_mut()[column] = y.as_ref()[column] - step;
        above.as_mut()[column] = y.as_ref()[column] + step;
        // The actual distance between the sums, not the intended one.
        let apart = above.as_ref()[column] - below.as_ref()[column];
        let (low, high) = (system.rhs(t, &below), system.rhs(t, &above));
        let differences = high.as_ref().iter().zip(low.as_ref());
        for (row, (high, low)) in rows.as_mut().iter_mut().zip(differences) {
            row.as_mut()[column] = (*high - *low) / apart;
        }
    }
    rows
}
