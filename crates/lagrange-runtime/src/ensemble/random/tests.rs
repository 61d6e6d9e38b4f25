//! Random numbers against their expected statistics.

use super::Random;
use crate::ensemble::{Moments, Reduce};

#[test]
fn the_first_bits_are_those_of_the_published_vector() {
    let mut random = Random::start(0, 0);
    assert_eq!([random.bits(), random.bits()], [0xe169_c58d_6627_e8d5, 0x9b00_dbd8_bc57_ac4c]);
}

/// These bits must never change on any platform.
#[test]
fn numbers_are_the_same_on_every_platform() {
    let mut random = Random::start(7, 41);
    let numbers = [random.normal(), random.normal(), random.normal(), random.uniform(-1.0..3.0)];
    assert_eq!(numbers.map(f64::to_bits), NUMBERS, "{numbers:?}");
}

const NUMBERS: [u64; 4] =
    [0x3fd6_aa8d_1f8b_450c, 0x3fb0_52c1_ef21_7c34, 0xbf8c_46a2_04a1_da3c, 0x3fb3_8292_3c32_c480];

/// Returns the first bits of every purpose.
fn first_bits(seed: u64, index: usize) -> [u64; 3] {
    [
        Random::start(seed, index).bits(),
        Random::parameters(seed, index).bits(),
        Random::noise(seed, index).bits(),
    ]
}

/// Draws under one seed are independent. The bound is five standard deviations of a correlation of
/// this many.
#[test]
fn purposes_are_independent_of_each_other() {
    let number = 20_000;
    let mut products = [0.0; 3];
    for index in 0..number {
        let (a, b, c) = (
            Random::start(7, index).normal(),
            Random::parameters(7, index).normal(),
            Random::noise(7, index).normal(),
        );
        for (product, value) in products.iter_mut().zip([a * b, b * c, c * a]) {
            *product += value;
        }
    }
    let correlations = products.map(|product| product / number as f64);
    assert!(correlations.iter().all(|value| value.abs() < 5.0 / (number as f64).sqrt()), "{correlations:?}");
}

#[test]
fn motions_seeds_and_purposes_have_numbers_of_their_own() {
    let firsts = |seed| (0..100).flat_map(move |index| first_bits(seed, index));
    let mut all: std::vec::Vec<u64> = (0..100).flat_map(firsts).collect();
    all.sort_unstable();
    all.dedup();
    assert_eq!(all.len(), 3 * 10_000);
}

#[test]
fn moments_are_those_of_the_distributions() {
    let mut random = Random::start(3, 0);
    let (mut uniform, mut normal, mut cubes) = (Moments::new(), Moments::new(), Moments::new());
    for _ in 0..200_000 {
        uniform.add(random.uniform(2.0..5.0));
        let value = random.normal();
        normal.add(value);
        cubes.add(value.powi(4));
    }
    // Five standard deviations of each.
    assert!((uniform.mean() - 3.5).abs() < 0.01, "{uniform:?}");
    assert!((uniform.variance() - 0.75).abs() < 0.008, "{uniform:?}");
    assert!(uniform.min() >= 2.0 && uniform.max() < 5.0, "{uniform:?}");
    assert!(normal.mean().abs() < 0.0112 && (normal.variance() - 1.0).abs() < 0.016, "{normal:?}");
    assert!((cubes.mean() - 3.0).abs() < 0.11, "{cubes:?}");
    normal.merge(Moments::new());
    assert_eq!(normal.count(), 200_000);
}

#[test]
fn a_range_of_neighbours_gives_its_start() {
    let (start, end) = (1.0_f64, 1.0_f64.next_up());
    assert!((0..100).all(|index| Random::start(0, index).uniform(start..end) == start));
}

/// Twice the standard deviation for a quarter of the period, and the numbers of the sequence.
#[test]
fn white_noise_has_the_variance_of_its_density_over_its_period() {
    let (mut white, mut normal) = (Random::noise(7, 3), Random::noise(7, 3));
    for _ in 0..4 {
        assert_eq!(white.white(3.0, 0.75), 2.0 * normal.normal());
    }
    assert_eq!(white.white(0.0, 1.0), 0.0);
}
