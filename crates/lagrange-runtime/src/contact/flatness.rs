//! Rims that lie flat at the start of a motion.
//!
//! A gap with a rounded kink is c − R √(s² + ε²), where s is an inclination. It is negative at the
//! exact height, where c is R s. It is −R ε if the rim is flat, and −R ε²/2s if it is inclined.
//! This is no overlap. The radius follows from the gap itself. An inclination of a flat rim by
//! d lowers the gap by R d below its linear part.
//!
//! A flat disk with R = 0.1 at the height 0 has the gap −10⁻¹⁰. Inclined by 0.01, its gap is
//! −0.001, so R is 0.1.

use super::padding::own;
use super::{ContactSystem, Terms};
use crate::linalg::vector::dot;
use crate::scalar::Scalar;
use crate::system::displaced;

/// The inclination ε over which `lagrange-language` rounds the kink.
const ROUNDED: f64 = 1e-9;
/// Inclination by which bodies are turned. At larger ones, the gap of a rim at its exact height is
/// zero to rounding.
const TURNED: f64 = 0.01;

impl<S: Scalar, const N: usize, const K: usize> Terms<S, N, K> {
    /// True if gap k is negative only because its kink is rounded.
    #[cold]
    pub(super) fn is_flat<M>(&self, system: &M, k: usize, t: S, q: &M::Coordinates) -> bool
    where
        M: ContactSystem<N, K, Scalar = S>,
    {
        let (mut still, mut sharpest) = ([S::ZERO; N], S::ZERO);
        for i in 0..system.velocities() {
            for turned in [TURNED, -TURNED].map(S::from_f64) {
                still[i] = turned;
                let to = displaced(system, t, q, [(S::ONE, &own(system, &still))]);
                let linear = self.gaps[k] + dot(&self.rows[k], &still);
                still[i] = S::ZERO;
                let lowered = linear - system.terms(t, &to, &still).gaps[k];
                sharpest = sharpest.max(lowered / turned.abs());
            }
        }
        let kink = S::from_f64(ROUNDED) * sharpest;
        self.gaps[k] >= -(kink + kink)
    }
}
