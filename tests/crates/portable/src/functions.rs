//! Elementary functions at random numbers of all sizes.

use lagrange::scalar::Lanes;
use lagrange::{Number, Portable};

use crate::hash::Hash;

const COUNT: u32 = 20_000;

/// A fixed sequence of numbers (G. Marsaglia, "Xorshift RNGs", 2003).
struct Random(u64);

impl Random {
    const NEW: Random = Random(0x9e37_79b9_7f4a_7c15);

    /// Draws a number up to 10, up to 10⁵, or of any magnitude.
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        let fraction = (self.0 >> 11) as f64 / 9_007_199_254_740_992.0 - 0.5;
        match self.0 % 4 {
            0 => 20.0 * fraction,
            1 => 2.0 * fraction,
            2 => 2e5 * fraction,
            _ => f64::from_bits(self.0),
        }
    }
}

fn values<S: Number>(x: S) -> [S; 14] {
    let (sine, cosine) = x.sin_cos();
    [
        sine,
        cosine,
        x.tan(),
        x.asin(),
        x.acos(),
        x.atan(),
        x.sinh(),
        x.cosh(),
        x.tanh(),
        x.exp(),
        x.ln(),
        x.sqrt(),
        x.powi(-7),
        x.multiply_add(x, -sine),
    ]
}

pub(crate) fn of_one() -> Hash {
    let (mut hash, mut random) = (Hash::NEW, Random::NEW);
    for _ in 0..COUNT {
        let x = random.number();
        hash.add_all(values(Portable(x)));
        hash.add_all(values(Portable(x as f32)));
    }
    hash
}

pub(crate) fn of_two() -> Hash {
    let (mut hash, mut random) = (Hash::NEW, Random::NEW);
    for _ in 0..COUNT {
        let (x, y) = (Portable(random.number()), Portable(random.number()));
        hash.add_all([x.atan2(y), x.hypot(y), x.abs().powf(y), x.min(y)]);
    }
    hash
}

/// Hashes lanes with and without fused products: both give the bits of scalar evaluation.
pub(crate) fn in_lanes() -> Hash {
    let (mut hash, mut random) = (Hash::NEW, Random::NEW);
    for _ in 0..COUNT / 8 {
        let numbers = [(); 8].map(|()| Portable(random.number()));
        let alone = numbers.map(values);
        for values in alone {
            hash.add_all(values);
        }
        for lanes in [transposed(Lanes::<_, 8, true>(numbers)), transposed(Lanes::<_, 8, false>(numbers))] {
            for values in lanes {
                hash.add_all(values);
            }
        }
    }
    hash
}

/// Returns the values in each lane.
fn transposed<const FUSED: bool>(numbers: Lanes<Portable, 8, FUSED>) -> [[Portable; 14]; 8] {
    let rows = values(numbers);
    core::array::from_fn(|lane| rows.map(|Lanes(row)| row[lane]))
}
