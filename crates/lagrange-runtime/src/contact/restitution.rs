//! Coefficients of restitution, which are from 0 to 1.

use super::{ContactSystem, Mode, Terms};
use crate::scalar::Scalar;
use crate::system::StepFailure;

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Returns the coefficients of restitution of contacts; zero for friction.
    ///
    /// # Errors
    /// If a `judged` coefficient is not from 0 to 1.
    pub(super) fn restitutions<M>(
        &self,
        system: &M,
        modes: &[Mode; K],
        is_judged: impl Fn(usize) -> bool,
    ) -> Result<[S; K], StepFailure<S>>
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let mut restitutions = [S::ZERO; K];
        for k in (0..K).filter(|k| matches!(modes[*k], Mode::Contact(_))) {
            let value = self.restitutions[k];
            if is_judged(k) && !(value >= S::ZERO && value <= S::ONE) {
                return Err(StepFailure::Restitution { contact: system.reaction_name(k), value });
            }
            restitutions[k] = value;
        }
        Ok(restitutions)
    }
}
