//! Motions and functions with the same bits on every platform, each as a hash that is compared with
//! a constant.
//!
//! The constants are from x86-64. Every target must reproduce them, at every level of optimisation
//! and with every instruction set: `tools/portable.py`.
#![no_std]
#![forbid(unsafe_code)]

mod functions;
mod hash;
mod motions;

pub use hash::Hash;

/// A computation and the hash of its bits.
#[derive(Debug)]
pub struct Row {
    /// Name of the computation.
    pub name: &'static str,
    /// The computation.
    pub compute: fn() -> Hash,
    /// The hash on x86-64.
    pub expected: u64,
}

const fn row(name: &'static str, compute: fn() -> Hash, expected: u64) -> Row {
    Row { name, compute, expected }
}

/// All computations.
pub const ROWS: [Row; 10] = [
    row("functions of one number", functions::of_one, 0xb30c_5293_f25a_70c6),
    row("functions of two numbers", functions::of_two, 0x88a6_ad91_3f6b_ef62),
    row("functions in lanes", functions::in_lanes, 0xba32_4dfa_5877_561e),
    row("chaos, a million steps", motions::chaos, 0x4191_28e5_c18f_4001),
    row("chaos in single precision", motions::single, 0x69b4_fc20_60b2_e375),
    row("adaptive steps", motions::adaptive, 0x2cb5_30b5_1107_b2f7),
    row("Taylor series", motions::series, 0x20bf_6696_0e5b_3ac2),
    row("implicit steps", motions::implicit, 0xb48e_8050_ad13_8801),
    row("contacts, impacts and friction", motions::contacts, 0xa189_9e73_ded2_3079),
    row("constraints and events", motions::events, 0xd47b_c1fd_bb16_fbfd),
];

#[cfg(test)]
mod tests {
    /// Takes half a minute unoptimised. `tools/portable.py` computes it on all targets.
    const LONG: &str = "chaos, a million steps";

    #[test]
    fn bits_are_those_of_all_platforms() {
        for row in super::ROWS.iter().filter(|row| !cfg!(debug_assertions) || row.name != LONG) {
            assert_eq!((row.compute)().value(), row.expected, "{}", row.name);
        }
    }
}
