//! Random numbers, the same in every run.

/// The generator SplitMix64 (Steele, Lea and Flood, *Fast splittable pseudorandom number
/// generators*, 2014).
pub(crate) struct Random {
    state: u64,
}

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random { state: seed }
    }

    /// Returns the generator for one case, independent of those of its neighbours.
    pub(crate) fn of_case(case: u64) -> Random {
        Random::new(case.wrapping_mul(0xd134_2543_de82_ef95))
    }

    fn bits(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.state;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^ (bits >> 31)
    }

    /// Draws a number between two bounds.
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / 53.0_f64.exp2())
    }

    /// Draws one of 0, 1, … n − 1.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.bits() % n.max(1) as u64) as usize
    }

    /// Draws an element of a nonempty list.
    pub(crate) fn choice<'a, T>(&mut self, list: &'a [T]) -> &'a T {
        &list[self.below(list.len())]
    }

    /// Draws a number of either sign whose magnitude lies between two powers of ten, with a
    /// uniformly distributed exponent.
    pub(crate) fn decades(&mut self, low: f64, high: f64) -> f64 {
        let magnitude = 10.0_f64.powf(self.between(low, high));
        if self.below(2) == 0 { magnitude } else { -magnitude }
    }
}
