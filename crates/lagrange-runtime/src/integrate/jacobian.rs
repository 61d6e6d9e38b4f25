//! Jacobians for implicit methods: those provided by systems, and difference quotients otherwise.

use crate::integrate::method::Work;
use crate::integrate::newton::finite;
use crate::linalg::pivoted::Matrix;
use crate::scalar::{Number, Scalar};
use crate::system::{Domain, OdeSystem, StateVector};

/// The source of the Jacobian for methods of equal steps.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Source {
    /// The system, if it provides a Jacobian. Fixed-point iteration needs none for short steps.
    System,
    /// Difference quotients if the system provides none, for steps in which fixed-point iteration
    /// does not converge.
    Differences,
}

impl Source {
    /// Returns ∂f/∂y at this time and state, for a step of length `h`, if it is finite.
    pub(super) fn jacobian<M>(
        self,
        system: &M,
        (t, y): (M::Scalar, &M::State),
        h: M::Scalar,
        work: &mut Work,
    ) -> Option<Jacobian<M>>
    where
        M: OdeSystem + ?Sized,
    {
        let known = known(system, t, y, work);
        if known.is_some() || self == Source::System {
            return known;
        }
        let rate = system.rhs(t, y);
        work.evaluations += 1;
        let jacobian =
            differences(system, (t, y), &rate, &sizes(y, h, &rate, Number::ONE, system.domain()), work);
        finite(jacobian.0.as_ref()).then_some(jacobian)
    }
}

/// The matrix of derivatives of a system's right-hand side.
type Jacobian<M> = Matrix<<M as OdeSystem>::Scalar, <M as OdeSystem>::State>;

/// Returns ∂f/∂y from the system, if it is available and finite.
pub(super) fn known<M>(system: &M, t: M::Scalar, y: &M::State, work: &mut Work) -> Option<Jacobian<M>>
where
    M: OdeSystem + ?Sized,
{
    let jacobian = system.jacobian(t, y)?;
    work.jacobians += 1;
    // The rates may be smooth enough even if their slopes are undefined.
    finite(jacobian.as_ref()).then_some(Matrix(jacobian))
}

/// Computes ∂f/∂y by difference quotients at the state `y` with this rate. Components change by √ε
/// times their `sizes`.
pub(super) fn differences<M>(
    system: &M,
    (t, y): (M::Scalar, &M::State),
    rate: &M::State,
    sizes: &M::State,
    work: &mut Work,
) -> Jacobian<M>
where
    M: OdeSystem + ?Sized,
{
    let mut jacobian = Matrix::zeros(y);
    for (column, size) in sizes.as_ref().iter().enumerate() {
        let width = M::Scalar::epsilon().sqrt() * *size;
        let mut quotients = quotients(system, (t, y), rate, (column, width));
        work.evaluations += 1;
        if !finite(&[quotients]) {
            // The domain of the system may end here.
            quotients = self::quotients(system, (t, y), rate, (column, -width));
            work.evaluations += 1;
        }
        for (row, quotient) in quotients.as_ref().iter().enumerate() {
            jacobian[(row, column)] = *quotient;
        }
    }
    work.jacobians += 1;
    jacobian
}

/// Computes the derivatives with respect to one component.
fn quotients<M>(
    system: &M,
    (t, y): (M::Scalar, &M::State),
    rate: &M::State,
    (component, width): (usize, M::Scalar),
) -> M::State
where
    M: OdeSystem + ?Sized,
{
    let mut moved = *y;
    moved.as_mut()[component] = y.as_ref()[component] + width;
    // The rounded change of the component.
    let width = moved.as_ref()[component] - y.as_ref()[component];
    let mut quotients = system.rhs(t, &moved);
    for (quotient, rate) in quotients.as_mut().iter_mut().zip(rate.as_ref()) {
        *quotient = (*quotient - *rate) / width;
    }
    quotients
}

/// Returns the sizes of the components of a state that changes at this rate over a step of length
/// `h`. The minimum size is in nominal values.
pub(super) fn sizes<S: Scalar, Y: StateVector<S>>(y: &Y, h: S, rate: &Y, least: S, domain: &Domain) -> Y {
    let mut sizes = *y;
    for (component, (size, rate)) in sizes.as_mut().iter_mut().zip(rate.as_ref()).enumerate() {
        let least = least * S::from_f64(domain.nominal(component));
        *size = size.abs().max((h * *rate).abs()).max(least);
    }
    sizes
}
