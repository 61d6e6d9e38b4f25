//! Final states of motions, with their derivatives with respect to the initial state.

use std::string::ToString;

use super::error::OrbitError;
use crate::linalg::dense::DenseMatrix;
use crate::simulate::Simulate;
use crate::system::{OdeSystem, ParametricSystem};

/// Names of the initial values by which one run is differentiated; more need further runs. Their
/// number is fixed so that the integration is compiled only once.
const NAMES: [&str; 4] = ["first", "second", "third", "fourth"];

/// The end of a motion.
pub(super) struct FlowEnd<const N: usize> {
    pub(super) state: [f64; N],
    /// Derivatives of the final state by the initial one, a column for each entry of the latter.
    pub(super) matrix: DenseMatrix,
}

/// Returns the end of the motion from a state over a time.
///
/// # Errors
/// If the motion fails or ends early.
pub(super) fn flow<M, const N: usize>(
    system: &M,
    start: &[f64; N],
    [from, to]: [f64; 2],
    tolerance: f64,
) -> Result<FlowEnd<N>, OrbitError>
where
    M: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]>,
{
    let mut end = FlowEnd { state: *start, matrix: DenseMatrix::zeros(N, N) };
    for first in (0..N).step_by(NAMES.len()) {
        let run = system.simulate(*start).from(from).until(to).ends_only().tolerance(tolerance);
        let run = run.by_initial_values::<N, { NAMES.len() + 1 }>(first, &NAMES).run();
        let motion = run.map_err(|error| OrbitError::Motion(error.to_string()))?;
        if motion.end_time() != to {
            return Err(OrbitError::Ends(motion.end_time()));
        }
        end.state = motion.last();
        let columns = motion.sensitivities(motion.len() - 1).unwrap_or_default();
        for (column, change) in columns.iter().enumerate() {
            for (row, entry) in change.iter().enumerate() {
                end.matrix[(row, first + column)] = *entry;
            }
        }
    }
    Ok(end)
}
