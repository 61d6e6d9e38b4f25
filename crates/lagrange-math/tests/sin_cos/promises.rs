//! Special values, symmetry, and independence of angles.

use std::f64::consts::PI;

use lagrange_math::{LARGEST_ANGLE, precise_sines_and_cosines, sin_cos_each, sin_cos_each_f32};

use crate::accuracy::{FUNCTIONS, Random, fast, precise};

fn bits((sine, cosine): (f64, f64)) -> (u64, u64) {
    (sine.to_bits(), cosine.to_bits())
}

#[test]
fn zeros_and_the_smallest_numbers_come_back_as_they_are() {
    for angle in [0.0, f64::from_bits(1), f64::from_bits(77), f64::MIN_POSITIVE, 1e-300, 1e-9] {
        for (of, _) in FUNCTIONS {
            assert_eq!(bits(of(angle)), bits((angle, 1.0)), "{angle:e}");
            assert_eq!(bits(of(-angle)), bits((-angle, 1.0)), "{angle:e}");
        }
    }
    assert_eq!(sin_cos_each_f32([-0.0])[0].0.to_bits(), (-0.0_f32).to_bits());
}

#[test]
fn nan_and_infinity_give_nan() {
    for angle in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN] {
        for (of, _) in FUNCTIONS {
            let (sine, cosine) = of(angle);
            assert!(sine.is_nan() && cosine.is_nan(), "{angle}");
        }
        let [_, (sine, cosine), _] = sin_cos_each_f32([1.0, angle as f32, 2.0]);
        assert!(sine.is_nan() && cosine.is_nan(), "{angle}");
    }
}

#[test]
fn sine_is_odd_and_cosine_even_to_the_last_bit() {
    let mut random = Random(4);
    for _ in 0..1000 {
        let angle = 2.0 * LARGEST_ANGLE * random.fraction().powi(4);
        for (of, _) in FUNCTIONS {
            let ((sine, cosine), opposite) = (of(angle), of(-angle));
            assert_eq!(bits(opposite), bits((-sine, cosine)), "{angle:e}");
        }
    }
}

/// Tests every angle with its index among neighbours of all kinds.
fn is_the_same_in_company<const N: usize>(random: &mut Random) {
    for case in 0..20 {
        let mut angles = std::array::from_fn::<f64, N, _>(|_| 10.0 * PI * (random.fraction() - 0.5));
        if case % 4 == 3 {
            let place = (random.bits() % N as u64) as usize;
            angles[place] = [1e7, f64::NAN, f64::INFINITY, -0.0][case / 4 % 4];
        }
        let (sines, cosines) = precise_sines_and_cosines(angles);
        for (i, found) in sin_cos_each(angles).into_iter().enumerate() {
            let (angle, is_angle) = (angles[i], angles[i].is_finite());
            assert!(bits(found) == bits(fast(angle)) || !is_angle, "{angle:e} of {N}");
            assert!(bits((sines[i], cosines[i])) == bits(precise(angle)) || !is_angle, "{angle:e} of {N}");
        }
    }
}

#[test]
fn an_angle_gives_the_same_in_any_company() {
    let random = &mut Random(5);
    is_the_same_in_company::<1>(random);
    is_the_same_in_company::<2>(random);
    is_the_same_in_company::<3>(random);
    is_the_same_in_company::<4>(random);
    is_the_same_in_company::<5>(random);
    is_the_same_in_company::<7>(random);
    is_the_same_in_company::<8>(random);
    is_the_same_in_company::<11>(random);
    is_the_same_in_company::<16>(random);
    is_the_same_in_company::<29>(random);
    is_the_same_in_company::<100>(random);
    assert_eq!(sin_cos_each([]), []);
}
