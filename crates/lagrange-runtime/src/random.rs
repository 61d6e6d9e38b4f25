//! The random number generator, as a function of a key and a counter.
//!
//! Philox4x32-10: ten rounds of multiplication and exclusive or transform a counter with a key.
//! Calls share no state, so numbers do not depend on the order of requests.
//!
//! Sources: Salmon, Moraes, Dror, Shaw, *Parallel random numbers: as easy as 1, 2, 3*, SC'11, §3.3,
//! and the vectors of Random123; Box, Muller, *A note on the generation of random normal deviates*,
//! Ann. Math. Stat. 29 (1958).

use core::f64::consts::TAU;

const ROUNDS: u32 = 10;
const MULTIPLIERS: [u32; 2] = [0xD251_1F53, 0xCD9E_8D57];
/// The golden ratio and √3 − 1, which are added to the key between rounds.
const WEYL: [u32; 2] = [0x9E37_79B9, 0xBB67_AE85];
/// 2⁻⁵³
const UNIT: f64 = 1.0 / (1_u64 << 53) as f64;
/// Number of counter bits that number the blocks of one purpose.
const BLOCK_BITS: u32 = u64::BITS - 8;

/// A seed, a motion of an ensemble, and the purpose of the numbers drawn for it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stream {
    pub(crate) seed: u64,
    pub(crate) motion: u64,
    /// Number of the purpose, below 256. Different purposes have independent numbers.
    pub(crate) purpose: u8,
}

impl Stream {
    /// Returns two words of 64 bits: the block with this number, which must be below 2⁵⁶. No
    /// sequence is that long.
    pub(crate) fn block(self, number: u64) -> [u64; 2] {
        let blocks = u64::from(self.purpose) << BLOCK_BITS | number;
        words([blocks, self.motion], self.seed)
    }
}

/// Returns two words of 64 bits for a counter of the same size and a key.
pub(crate) fn words([lower, upper]: [u64; 2], key: u64) -> [u64; 2] {
    let ([a, b], [c, d]) = (halves(lower), halves(upper));
    let [a, b, c, d] = philox([a, b, c, d], halves(key));
    [joined(a, b), joined(c, d)]
}

/// Returns a number in [0, 1).
pub(crate) fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 * UNIT
}

/// Returns two independent normal numbers with mean 0 and standard deviation 1, by the formula of
/// Box and Muller. Their magnitude is below 8.6.
pub(crate) fn normals([first, second]: [u64; 2]) -> [f64; 2] {
    // In (0, 1], so that the logarithm is finite.
    let radius = libm::sqrt(-2.0 * libm::log(unit(first) + UNIT));
    let (sin, cos) = libm::sincos(TAU * unit(second));
    [radius * cos, radius * sin]
}

/// Applies ten rounds of Philox.
fn philox(counter: [u32; 4], key: [u32; 2]) -> [u32; 4] {
    let ([mut a, mut b, mut c, mut d], [mut left, mut right]) = (counter, key);
    for _ in 0..ROUNDS {
        let [low, high] = halves(u64::from(MULTIPLIERS[0]) * u64::from(a));
        let [lower, higher] = halves(u64::from(MULTIPLIERS[1]) * u64::from(c));
        [a, b, c, d] = [higher ^ b ^ left, lower, high ^ d ^ right, low];
        (left, right) = (left.wrapping_add(WEYL[0]), right.wrapping_add(WEYL[1]));
    }
    [a, b, c, d]
}

/// Returns the lower and the upper half.
fn halves(word: u64) -> [u32; 2] {
    [word as u32, (word >> 32) as u32]
}

fn joined(low: u32, high: u32) -> u64 {
    u64::from(low) | u64::from(high) << 32
}

#[cfg(test)]
mod tests {
    use super::philox;

    /// The rows `philox4x32 10` of `kat_vectors` in Random123: counter, key, result.
    const KNOWN: [([u32; 4], [u32; 2], [u32; 4]); 3] = [
        ([0; 4], [0; 2], [0x6627_e8d5, 0xe169_c58d, 0xbc57_ac4c, 0x9b00_dbd8]),
        ([u32::MAX; 4], [u32::MAX; 2], [0x408f_276d, 0x41c8_3b0e, 0xa20b_c7c6, 0x6d54_51fd]),
        (
            [0x243f_6a88, 0x85a3_08d3, 0x1319_8a2e, 0x0370_7344],
            [0xa409_3822, 0x299f_31d0],
            [0xd16c_fe09, 0x94fd_cceb, 0x5001_e420, 0x2412_6ea1],
        ),
    ];

    #[test]
    fn ten_rounds_give_the_published_vectors() {
        for (counter, key, expected) in KNOWN {
            assert_eq!(philox(counter, key), expected);
        }
    }
}
