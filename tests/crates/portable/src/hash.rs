//! A hash of numbers by their bits (FNV-1a, over words).

/// The hash of all numbers added so far.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Hash(u64);

impl Hash {
    pub(crate) const NEW: Hash = Hash(0xcbf2_9ce4_8422_2325);

    /// Adds a number; all NaNs count as one.
    pub(crate) fn add(&mut self, number: impl Into<f64>) {
        let number: f64 = number.into();
        let bits = if number.is_nan() { 0x7ff8 << 48 } else { number.to_bits() };
        self.0 = (self.0 ^ bits).wrapping_mul(0x100_0000_01b3).rotate_left(23);
    }

    /// Adds several numbers.
    pub(crate) fn add_all(&mut self, numbers: impl IntoIterator<Item: Into<f64>>) {
        numbers.into_iter().for_each(|number| self.add(number));
    }

    /// Returns the hash as a number.
    #[must_use]
    pub fn value(self) -> u64 {
        self.0
    }
}
