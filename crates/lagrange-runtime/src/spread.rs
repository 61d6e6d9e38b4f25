//! Points that appear random and are the same in every run.

use crate::scalar::Scalar;

/// Returns a number between −1 and 1 for one entry of a point.
///
/// Source: the hash splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014).
pub(crate) fn spread<S: Scalar>(point: usize, place: usize) -> S {
    let key = (point as u64).wrapping_mul(1 << 20).wrapping_add(place as u64 + 1);
    let mut hash = key.wrapping_mul(0x9e37_79b9_7f4a_7c15);
    hash = (hash ^ (hash >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    hash = (hash ^ (hash >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    S::from_f64((hash ^ (hash >> 31)) as f64 / (1_u64 << 63) as f64 - 1.0)
}
