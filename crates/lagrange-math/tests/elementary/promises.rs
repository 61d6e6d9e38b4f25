//! Special values, symmetry, arguments beyond the formulas, and independence of lanes.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use lagrange_math::{Elementary, angles, angles_f32, lengths, lengths_f32, values, values_f32};

use crate::rows::OF_ONE;

/// A fixed sequence of 64-bit numbers (S. Vigna's SplitMix64).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// Draws a number between 0 and 1.
    pub(crate) fn fraction(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2.0_f64.powi(-53)
    }
}

/// Numbers at which functions are most often wrong.
const SPECIAL: [f64; 22] = [
    0.0,
    5e-324,
    1e-310,
    f64::MIN_POSITIVE,
    1e-280,
    1e-9,
    0.5,
    0.999_999_999_999_999_9,
    1.0,
    1.5,
    2.0,
    22.5,
    99_999.0,
    1e6,
    600.5,
    709.9,
    745.2,
    1e22,
    1e280,
    f64::MAX,
    f64::INFINITY,
    f64::NAN,
];

fn specials() -> impl Iterator<Item = f64> + Clone {
    SPECIAL.into_iter().flat_map(|x| [x, -x])
}

fn is_near(found: f64, expected: f64) -> bool {
    let is_same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
    is_same || found != 0.0 && expected != 0.0 && found.to_bits().abs_diff(expected.to_bits()) <= 2
}

fn platform(function: Elementary, x: f64) -> f64 {
    match function {
        Elementary::Tan => x.tan(),
        Elementary::Asin => x.asin(),
        Elementary::Acos => x.acos(),
        Elementary::Atan => x.atan(),
        Elementary::Sinh => x.sinh(),
        Elementary::Cosh => x.cosh(),
        Elementary::Tanh => x.tanh(),
        Elementary::Exp => x.exp(),
        Elementary::Ln => x.ln(),
    }
}

#[test]
fn special_values_are_those_of_the_platform() {
    for function in OF_ONE {
        for x in specials() {
            let expected = platform(function, x);
            for [found] in [values::<false, 1>(function, [x]), values::<true, 1>(function, [x])] {
                assert!(is_near(found, expected), "{function:?} of {x:e}: {found:e}, not {expected:e}");
            }
            let single = x as f32;
            let [found] = values_f32::<false, 1>(function, [single]);
            let expected = platform(function, f64::from(single)) as f32;
            assert!(found == expected || found.is_nan() && expected.is_nan(), "{function:?} of {single:e}");
        }
    }
}

#[test]
fn special_points_are_those_of_the_platform() {
    for y in specials() {
        for x in specials() {
            let ([angle], [length]) = (angles::<false, 1>([y], [x]), lengths::<false, 1>([y], [x]));
            assert!(is_near(angle, y.atan2(x)), "({x:e}, {y:e}): {angle:e}");
            assert!(is_near(length, y.hypot(x)), "({x:e}, {y:e}): {length:e}");
            let ([angle], [length]) = (angles::<true, 1>([y], [x]), lengths::<true, 1>([y], [x]));
            assert!(is_near(angle, y.atan2(x)), "({x:e}, {y:e}): {angle:e}");
            assert!(is_near(length, y.hypot(x)), "({x:e}, {y:e}): {length:e}");
        }
    }
    let found = angles::<false, 6>([0.0, 1.0, 1.0, 0.0, -0.0, -1.0], [1.0, 1.0, 0.0, -1.0, -1.0, -0.0]);
    assert_eq!(found, [0.0, FRAC_PI_4, FRAC_PI_2, PI, -PI, -FRAC_PI_2]);
    assert_eq!(
        angles_f32::<true, 2>([1.0, -1.0], [0.0, 0.0]),
        [1.0, -1.0].map(|sign| sign * FRAC_PI_2 as f32)
    );
    assert_eq!(lengths_f32::<true, 2>([3.0, 1e30], [-4.0, 0.0]), [5.0, 1e30]);
}

/// Tests every number beside neighbours of all kinds.
fn are_the_same_in_company<const N: usize, const FUSED: bool>(random: &mut Random) {
    let bits = |numbers: [f64; N]| numbers.map(|x| if x.is_nan() { 0 } else { x.to_bits() });
    for case in 0..10 {
        let [x, y] = [(); 2].map(|()| {
            let mut numbers = [(); N].map(|()| 8.0 * (random.fraction() - 0.5));
            if case % 2 == 1 {
                numbers[random.bits() as usize % N] = SPECIAL[random.bits() as usize % SPECIAL.len()];
            }
            numbers
        });
        for function in OF_ONE {
            let alone = x.map(|x| values::<FUSED, 1>(function, [x])[0]);
            assert_eq!(bits(values::<FUSED, N>(function, x)), bits(alone), "{function:?} of {x:?}");
        }
        let alone: [f64; N] = std::array::from_fn(|i| angles::<FUSED, 1>([y[i]], [x[i]])[0]);
        assert_eq!(bits(angles::<FUSED, N>(y, x)), bits(alone), "{x:?} {y:?}");
        let alone: [f64; N] = std::array::from_fn(|i| lengths::<FUSED, 1>([x[i]], [y[i]])[0]);
        assert_eq!(bits(lengths::<FUSED, N>(x, y)), bits(alone), "{x:?} {y:?}");
    }
}

#[test]
fn a_number_gives_the_same_in_any_company() {
    let random = &mut Random(5);
    are_the_same_in_company::<2, false>(random);
    are_the_same_in_company::<4, true>(random);
    are_the_same_in_company::<8, false>(random);
    are_the_same_in_company::<8, true>(random);
    are_the_same_in_company::<16, true>(random);
}

#[test]
fn odd_functions_are_odd_and_even_ones_even_to_the_last_bit() {
    let mut random = Random(4);
    for _ in 0..300 {
        let x = 2.0 * random.fraction();
        for function in OF_ONE {
            let [found, opposite] = values::<false, 2>(function, [x, -x]).map(f64::to_bits);
            match function {
                Elementary::Cosh => assert_eq!(found, opposite),
                Elementary::Acos | Elementary::Exp | Elementary::Ln => {}
                _ if x > 1.0 && function == Elementary::Asin => {}
                _ => assert_eq!(found ^ opposite, 1 << 63, "{function:?} of {x}"),
            }
        }
    }
}
