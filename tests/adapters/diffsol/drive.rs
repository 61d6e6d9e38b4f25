//! Steps of a solver of `diffsol`, watched.

use diffsol::error::OdeSolverError;
use diffsol::{DiffsolError, OdeEquations, OdeSolverMethod, OdeSolverStopReason};

use crate::problem::{Context, Vector, direction};
use crate::stiff::Stiff;
use lagrange::integrate::IntegrationError;
use lagrange::system::{StateVector, StepFailure};

/// Takes steps from start to end.
pub(crate) fn drive<'a, E, K, Y>(
    mut solver: K,
    (t0, y0, t_end): (f64, Y, f64),
    method: &Stiff,
    mut observe: impl FnMut(f64, &Y),
) -> Result<Y, IntegrationError<f64, Y>>
where
    E: OdeEquations<T = f64, V = Vector, C = Context> + 'a,
    K: OdeSolverMethod<'a, E>,
    Y: StateVector<f64>,
{
    let direction = direction(t0, t_end);
    let (mut time, mut state) = (t0, y0);
    let failed = |cause, time, state| IntegrationError { cause, time, state };
    solver.set_stop_time(direction * t_end).map_err(|error| failed(cause(&error, 0.0), time, state))?;
    for _ in 0..method.max_steps {
        let reason = solver.step().map_err(|error| failed(cause(&error, solver.state().h), time, state))?;
        let mut next = Y::ZERO;
        next.as_mut().copy_from_slice(solver.state().y.batch_as_slice(0));
        if next.as_ref().iter().any(|component| !component.is_finite()) {
            return Err(failed(StepFailure::NotFinite, time, state));
        }
        let is_end = reason == OdeSolverStopReason::TstopReached;
        (time, state) = (if is_end { t_end } else { direction * solver.state().t }, next);
        observe(time, &state);
        if is_end {
            return Ok(state);
        }
    }
    Err(failed(StepFailure::TooManySteps { limit: method.max_steps }, time, state))
}

/// Returns the cause of a failed step, where `h` is the last attempted size.
fn cause(error: &DiffsolError, h: f64) -> StepFailure<f64> {
    match error {
        DiffsolError::OdeSolverError(OdeSolverError::StepSizeTooSmall { .. }) => {
            StepFailure::StepUnderflow { step: h }
        }
        DiffsolError::OdeSolverError(OdeSolverError::TooManyNonlinearSolverFailures { .. }) => {
            StepFailure::Stuck("diffsol could not solve the equations of a step, however short")
        }
        DiffsolError::OdeSolverError(OdeSolverError::TooManyErrorTestFailures { .. }) => {
            StepFailure::Stuck("diffsol found the error of a step too large, however short")
        }
        DiffsolError::LaError(_) => StepFailure::Stuck("diffsol met a singular matrix"),
        _ => StepFailure::Stuck("diffsol could not take a step"),
    }
}
