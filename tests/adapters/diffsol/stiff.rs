//! Backward differentiation by the crate `diffsol`, for stiff systems.
//!
//! A system is stiff if its fastest motion has decayed or hardly moves, but still limits the steps
//! of explicit methods. Backward differentiation damps such a motion instead of following it: its
//! steps are as long as the slow motion allows. It needs the heap.
//!
//! Source: Byrne, Hindmarsh, "A polyalgorithm for the numerical solution of ordinary differential
//! equations", *ACM Transactions on Mathematical Software* 1 (1975) 71–96.

use diffsol::NalgebraLU;
use lagrange::integrate::{IntegrationError, Outcome};
use lagrange::system::{OdeSystem, SettingError, StepFailure};

use crate::drive::drive;
use crate::problem::problem;

/// Backward differentiation of orders one to five for stiff systems, with steps and orders chosen
/// by the tolerance.
///
/// Each step solves one implicit equation. The method is not symplectic; motions faster than the
/// steps are damped.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Stiff {
    /// Error of a step as a fraction of the state.
    pub(crate) relative: f64,
    /// Error of a step in the units of the state.
    pub(crate) absolute: f64,
    /// Largest number of steps.
    pub(crate) max_steps: u64,
}

impl Stiff {
    /// Returns backward differentiation with a tolerance that is both relative and absolute.
    pub(crate) fn tolerance(tolerance: f64) -> Self {
        Stiff { relative: tolerance, absolute: tolerance, max_steps: 10_000_000 }
    }

    fn check(&self) -> Result<(), SettingError<f64>> {
        let is_tolerance = |part: f64| part > 0.0 && part.is_finite();
        if is_tolerance(self.relative) && is_tolerance(self.absolute) {
            return Ok(());
        }
        Err(SettingError::Invalid("tolerances must be positive and finite"))
    }
}

/// Integrates from `y0` at `t0` to `t_end`, which may lie before `t0`, and returns the final state.
///
/// `observe` is called with time and state at the start and after every step. Newton's iterations
/// take the Jacobian emitted for `emit { jacobian }`, and central differences without it.
///
/// # Errors
/// Returns the failure of the method with the last good state. All states passed to `observe` are
/// finite.
pub(crate) fn integrate_stiff<M>(
    system: &M,
    t0: f64,
    y0: M::State,
    t_end: f64,
    method: &Stiff,
    mut observe: impl FnMut(f64, &M::State),
) -> Outcome<M, M::State>
where
    M: OdeSystem<Scalar = f64> + ?Sized,
{
    let failed = |cause| IntegrationError { cause, time: t0, state: y0 };
    method.check().map_err(|error| failed(error.into()))?;
    let is_finite = |y: &M::State| y.as_ref().iter().all(|component| component.is_finite());
    if !(t0.is_finite() && t_end.is_finite() && is_finite(&y0) && is_finite(&system.rhs(t0, &y0))) {
        return Err(failed(StepFailure::NotFinite));
    }
    observe(t0, &y0);
    if t0 == t_end {
        return Ok(y0);
    }
    let problem = problem(system, t0, &y0, t_end, method).map_err(failed)?;
    let refused = |_| failed(StepFailure::Stuck("diffsol refused the initial state"));
    let span = (t0, y0, t_end);
    drive(problem.bdf::<NalgebraLU<f64>>().map_err(refused)?, span, method, observe)
}
