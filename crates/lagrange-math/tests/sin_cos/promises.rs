//! Special values, symmetry, and that angles do not disturb each other.

use std::f64::consts::PI;

use lagrange_math::{LARGEST_ANGLE, sin_cos_each, sin_cos_each_f32};

use crate::accuracy::Random;

fn bits((sine, cosine): (f64, f64)) -> (u64, u64) {
    (sine.to_bits(), cosine.to_bits())
}

fn one(angle: f64) -> (f64, f64) {
    sin_cos_each([angle])[0]
}

#[test]
fn zeros_and_the_smallest_numbers_come_back_as_they_are() {
    for angle in [0.0, f64::from_bits(1), f64::from_bits(77), f64::MIN_POSITIVE, 1e-300, 1e-9] {
        assert_eq!(bits(one(angle)), bits((angle, 1.0)), "{angle:e}");
        assert_eq!(bits(one(-angle)), bits((-angle, 1.0)), "{angle:e}");
    }
    assert_eq!(sin_cos_each_f32([-0.0])[0].0.to_bits(), (-0.0_f32).to_bits());
}

#[test]
fn what_is_no_angle_gives_no_number() {
    for angle in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN, -f64::NAN] {
        let (sine, cosine) = one(angle);
        assert!(sine.is_nan() && cosine.is_nan(), "{angle}");
        let [_, (sine, cosine), _] = sin_cos_each_f32([1.0, angle as f32, 2.0]);
        assert!(sine.is_nan() && cosine.is_nan(), "{angle}");
    }
}

#[test]
fn sine_is_odd_and_cosine_even_to_the_last_bit() {
    let mut random = Random(4);
    for _ in 0..1000 {
        let angle = LARGEST_ANGLE * random.fraction().powi(4);
        let ((sine, cosine), opposite) = (one(angle), one(-angle));
        assert_eq!(bits(opposite), bits((-sine, cosine)), "{angle:e}");
    }
}

#[test]
fn large_angles_go_to_the_platform() {
    let next = f64::from_bits(LARGEST_ANGLE.to_bits() + 1);
    for angle in [next, -next, 1e6, 1e22, f64::MAX] {
        assert_eq!(bits(one(angle)), bits(angle.sin_cos()), "{angle:e}");
    }
}

/// Every angle with its index and neighbours of all kinds around it.
fn is_the_same_in_company<const N: usize>(random: &mut Random) {
    for case in 0..20 {
        let mut angles = std::array::from_fn::<f64, N, _>(|_| 10.0 * PI * (random.fraction() - 0.5));
        if case % 4 == 3 {
            let place = (random.bits() % N as u64) as usize;
            angles[place] = [1e7, f64::NAN, f64::INFINITY, -0.0][case / 4 % 4];
        }
        for (angle, found) in angles.into_iter().zip(sin_cos_each(angles)) {
            let alone = one(angle);
            assert!(bits(found) == bits(alone) || angle.is_nan() || angle.is_infinite(), "{angle:e} of {N}");
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
