//! Coefficients of restitution, which are from 0 to 1.

use super::{Mode, Terms};
use crate::integrate::Cause;
use crate::scalar::Scalar;

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// Coefficients of restitution of contacts; zero for friction.
    ///
    /// # Errors
    /// If one is not from 0 to 1, with its name.
    pub(super) fn checked_restitutions(
        &self,
        modes: &[Mode; K],
        names: &[&'static str; K],
    ) -> Result<[S; K], Cause<S>> {
        let mut restitutions = [S::ZERO; K];
        for k in (0..K).filter(|k| matches!(modes[*k], Mode::Contact(_))) {
            let value = self.restitutions[k];
            if !(value >= S::ZERO && value <= S::ONE) {
                return Err(Cause::Restitution { contact: names[k], value });
            }
            restitutions[k] = value;
        }
        Ok(restitutions)
    }
}
