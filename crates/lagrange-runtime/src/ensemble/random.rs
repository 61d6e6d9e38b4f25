//! Random numbers that are a function of a seed and of the index of a motion.
//!
//! Nothing is carried from motion to motion, so that every motion has its numbers whoever computes
//! it, and when.

use core::fmt::Debug;
use core::marker::PhantomData;
use core::ops::Range;

use crate::random::{Stream, normals, unit};

/// The random numbers of one motion for one purpose P: a sequence that its index and the seed of
/// the ensemble determine, on every platform.
///
/// Starts, parameters and noise have separate sequences, even under the same seed. Numbers drawn
/// for one are therefore independent of those drawn for another:
///
/// | numbers of | are |
/// |---|---|
/// | [`start`](super::Motions::start) | given to its closure, and [`Random::start`] anywhere else |
/// | [`parameters`](super::Motions::parameters) | [`Random::parameters`] |
/// | inputs, controllers, measurements | [`Random::noise`] |
///
/// Compatible versions of this crate never change a sequence:
/// - The generator is Philox4x32-10, keyed by the seed. Its counter has the index in the upper half
///   and the purpose in the upper byte of the lower half.
/// - Uniform numbers are the upper 53 bits of 64.
/// - Normal numbers are those of Box and Muller, by the elementary functions of the crate `libm`
///   instead of the platform's.
///
/// ```
/// use lagrange::ensemble::Random;
///
/// let mut random = Random::parameters(7, 41);
/// let (mass, length) = (random.uniform(1.0..2.0), random.normal());
/// let mut again = Random::parameters(7, 41);
/// assert_eq!((again.uniform(1.0..2.0), again.normal()), (mass, length));
/// assert_ne!(Random::start(7, 41).uniform(1.0..2.0), mass);
/// ```
///
/// A function that draws for one purpose takes no numbers of another:
///
/// ```compile_fail,E0308
/// use lagrange::ensemble::{OfParameters, Random};
///
/// fn mass(random: &mut Random<OfParameters>) -> f64 {
///     random.uniform(1.0..2.0)
/// }
///
/// mass(&mut Random::start(7, 41));
/// ```
#[derive(Clone, Debug)]
pub struct Random<P: Purpose = OfStart> {
    stream: Stream,
    /// Number of blocks that were taken.
    blocks: u64,
    /// The second half of the last block, if it is still to come.
    word: Option<u64>,
    /// The second of a pair of normal numbers, if it is still to come.
    normal: Option<f64>,
    purpose: PhantomData<P>,
}

/// The purpose of random numbers; each has independent sequences.
pub trait Purpose: sealed::Sealed + Clone + Debug {}

mod sealed {
    /// Purposes are those of this module.
    pub trait Sealed {
        /// Number that distinguishes the sequences of a purpose, below 256.
        const NUMBER: u8;
    }
}

macro_rules! purposes {
    ($($number:literal: $(#[$doc:meta])* $name:ident;)*) => {
        $(
            $(#[$doc])*
            #[derive(Clone, Copy, PartialEq, Eq, Debug)]
            pub enum $name {}

            impl Purpose for $name {}

            impl sealed::Sealed for $name {
                const NUMBER: u8 = $number;
            }
        )*
    };
}

purposes! {
    0: /// Of [`Random`]: where motions start.
    OfStart;
    1: /// Of [`Random`]: parameters of motions.
    OfParameters;
    2: /// Of [`Random`]: noise of inputs, controllers and measurements.
    OfNoise;
    // 3 is that of Wiener paths (`integrate::wiener`).
}

impl Random<OfStart> {
    /// Returns the numbers of the start of the motion `index` of an ensemble with this seed, from
    /// the first on.
    pub fn start(seed: u64, index: usize) -> Self {
        Random::of(seed, index)
    }
}

impl Random<OfParameters> {
    /// Returns the numbers of the parameters of the motion `index` of an ensemble with this seed,
    /// from the first on.
    pub fn parameters(seed: u64, index: usize) -> Self {
        Random::of(seed, index)
    }
}

impl Random<OfNoise> {
    /// Returns the numbers of noise in the motion `index` of an ensemble with this seed, from the
    /// first on.
    pub fn noise(seed: u64, index: usize) -> Self {
        Random::of(seed, index)
    }

    /// Returns the next value of white noise with the two-sided spectral density S, to be held for
    /// a period Δ. It is a normal number with the variance S/Δ.
    ///
    /// Its integral over the period is √S ΔW, for the increment ΔW of a Wiener process. As Δ → 0,
    /// solutions converge to those with white noise. They do so in the sense of Stratonovich where
    /// the factor of the noise depends on the state. The book states the order.
    ///
    /// Stream: Wong, Zakai, *On the convergence of ordinary integrals to stochastic integrals*,
    /// Ann. Math. Stat. 36 (1965).
    ///
    /// # Panics
    /// If the density is negative or NaN, or the period is not positive.
    pub fn white(&mut self, density: f64, period: f64) -> f64 {
        assert!(density >= 0.0, "the spectral density of noise cannot be {density:?}");
        assert!(period > 0.0, "noise cannot be held for {period:?}");
        libm::sqrt(density / period) * self.normal()
    }
}

impl<P: Purpose> Random<P> {
    fn of(seed: u64, index: usize) -> Self {
        let stream = Stream { seed, motion: index as u64, purpose: P::NUMBER };
        Random { stream, blocks: 0, word: None, normal: None, purpose: PhantomData }
    }

    /// Returns the next 64 bits.
    pub fn bits(&mut self) -> u64 {
        if let Some(word) = self.word.take() {
            return word;
        }
        let [word, next] = self.stream.block(self.blocks);
        self.blocks += 1;
        self.word = Some(next);
        word
    }

    /// Returns a number from the range, its end excluded, each part of it as likely as any other of
    /// its length.
    ///
    /// # Panics
    /// If the range is empty, or an end of it is not finite.
    pub fn uniform(&mut self, range: Range<f64>) -> f64 {
        let Range { start, end } = range;
        assert!(
            start < end && (end - start).is_finite(),
            "there is no random number in {start:?}..{end:?}: its ends must be finite, and the first below the second"
        );
        // Rounding may lead to the end itself.
        (start + (end - start) * unit(self.bits())).min(end.next_down())
    }

    /// Returns a number of the normal distribution with mean 0 and standard deviation 1; its
    /// magnitude is below 8.6.
    ///
    /// Stream: Box, Muller, *A note on the generation of random normal deviates*, Ann. Math. Stat.
    /// 29 (1958).
    pub fn normal(&mut self) -> f64 {
        if let Some(normal) = self.normal.take() {
            return normal;
        }
        let [normal, next] = normals([self.bits(), self.bits()]);
        self.normal = Some(next);
        normal
    }
}

#[cfg(test)]
mod tests;
