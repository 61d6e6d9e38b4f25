//! Random numbers, the same in every run.

use std::env;

/// The generator SplitMix64 (Steele, Lea and Flood, *Fast splittable pseudorandom number generators*, 2014).
pub(crate) struct Random {
    state: u64,
}

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random { state: seed }
    }

    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// Between two numbers.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / 53.0_f64.exp2())
    }

    /// One of 0, 1, … n − 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Of either sign, its magnitude between two powers of ten with an even distribution of the exponent.
    pub(crate) fn decades(&mut self, low: f64, high: f64) -> f64 {
        let magnitude = 10.0_f64.powf(self.between(low, high));
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }
}

/// How many cases to take: `usual`, times `LAGRANGE_EXTREMES` if that is set.
pub(crate) fn cases(usual: usize) -> usize {
    let factor = env::var("LAGRANGE_EXTREMES").ok();
    usual * factor.map_or(1, |factor| factor.parse().expect("LAGRANGE_EXTREMES is a whole number"))
}
