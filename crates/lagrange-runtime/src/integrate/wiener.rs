//! Paths of Wiener processes as functions of a seed, the index of a motion, and time.
//!
//! Time is divided into cells of equal length L, starting at zero. In each cell the path has an
//! increment W with the variance L. The area between the path and its chord, divided by L, is H,
//! with the variance L/12. All are independent. A cell is halved by
//!
//! > W₁ = W/2 + 3H/2 + a,  W₂ = W − W₁,  H₁ = H/4 − a/2 + b/2,  H₂ = H/4 − a/2 − b/2,
//!
//! where a and b are normal numbers with the variances L/16 and L/12. The paths of shorter steps
//! are therefore those of longer ones in more detail. Within a step, the path is its expectation
//! for given W and H, the parabola p(s) = s W + 6 s (1 − s) H.
//!
//! Sources: Lévy, *Processus stochastiques et mouvement brownien*, 1948, §1.2; Foster, Lyons,
//! Oberhauser, *An optimal polynomial approximation of Brownian motion*, SIAM J. Numer. Anal. 58
//! (2020), theorem 3.1.

use crate::random::{Stream, normals, words};

/// The purpose of these numbers; others belong to `ensemble::Random`.
const PURPOSE: u8 = 3;
/// Maximum number of halvings. Nodes of the halvings of a cell are numbered by 32 bits.
pub(super) const MAX_HALVINGS: u32 = 31;

/// A path of the Wiener processes that drive a system: one for each noise, all independent.
///
/// It is a function of its seed, of the index of the motion, and of time. Runs that are continued,
/// interrupted by events, or computed on other threads therefore have the same path.
///
/// Steps of half the length follow the same path if it is [halved](Self::halved). Motions then
/// differ only by the error of the method.
///
/// ```
/// use lagrange::Simulate;
/// use lagrange::integrate::{EulerMaruyama, WienerPath};
///
/// lagrange::system! {
///     /// Brownian motion of a free particle.
///     struct Particle;
///     param m = 1, c = 1;
///     coord x;
///     noise w, density: 2;
///     kinetic = 1/2 * m * dot(x)^2;
///     force x = w - c * dot(x);
/// }
///
/// let particle = Particle::default();
/// let end = |step: f64, path| {
///     let run = particle.simulate([0.0, 0.0]).until(4.0).method(EulerMaruyama { step, path }).run();
///     run.map(|motion| motion.last()[0])
/// };
/// let path = WienerPath::of_seed(7);
/// let [long, short] = [end(1.0 / 64.0, path)?, end(1.0 / 128.0, path.halved(1))?];
/// assert!((long - short).abs() < 0.05);
/// # Ok::<(), lagrange::simulate::SimulationError<Particle>>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WienerPath {
    seed: u64,
    motion: u64,
    halvings: u32,
}

impl WienerPath {
    /// Returns the path of this seed. Its cells have the length of a step.
    pub const fn of_seed(seed: u64) -> Self {
        WienerPath { seed, motion: 0, halvings: 0 }
    }

    /// Returns the path of the motion with this index. Ensembles call it for each motion; a single
    /// run is motion 0 by default.
    #[must_use]
    pub const fn of_motion(self, index: usize) -> Self {
        WienerPath { motion: index as u64, ..self }
    }

    /// Returns the path for steps whose length was halved this number of times, at most 31.
    #[must_use]
    pub const fn halved(self, times: u32) -> Self {
        WienerPath { halvings: self.halvings.saturating_add(times), ..self }
    }

    /// Returns the number of halvings from a cell to a step.
    pub(super) const fn halvings(self) -> u32 {
        self.halvings
    }

    /// Returns the increments of the path.
    pub(super) fn increments(self) -> Increments {
        let stream = Stream { seed: self.seed, motion: self.motion, purpose: PURPOSE };
        let [key, _] = stream.block(0);
        Increments { key, halvings: self.halvings }
    }
}

/// Increments of a path over its steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Increments {
    /// Key of the seed and of the motion. The whole counter is then available for place and noise.
    key: u64,
    halvings: u32,
}

impl Increments {
    /// Returns W and H of a noise over the step from `index` to `index + 1`, in units of its
    /// length.
    pub(super) fn over(&self, noise: u32, index: i64) -> [f64; 2] {
        let cell = (index >> self.halvings) as u64;
        let normals = |node: u32| normals(words([cell, u64::from(noise) << 32 | u64::from(node)], self.key));
        let mut length = (1_u64 << self.halvings) as f64;
        let [first, second] = normals(0);
        let (mut w, mut h) = (libm::sqrt(length) * first, libm::sqrt(length / 12.0) * second);
        let mut node = 1;
        for bit in (0..self.halvings).rev() {
            let [first, second] = normals(node);
            let (a, b) = (libm::sqrt(length / 16.0) * first, libm::sqrt(length / 12.0) * second);
            let (left, rest) = (w / 2.0 + 1.5 * h + a, h / 4.0 - a / 2.0);
            let is_right = index >> bit & 1 == 1;
            (w, h) = if is_right { (w - left, rest - b / 2.0) } else { (left, rest + b / 2.0) };
            node = node << 1 | u32::from(is_right);
            length /= 2.0;
        }
        [w, h]
    }
}

#[cfg(test)]
mod tests;
