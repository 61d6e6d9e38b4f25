//! Measurement noise, the same in every run.

/// Normally distributed numbers, as sums of twelve uniform ones.
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    fn even(&mut self) -> f64 {
        // Knuth's constants.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.even()).sum::<f64>() - 6.0
    }
}
