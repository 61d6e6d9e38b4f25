//! Values computed with 300 bits and stored, see `tools/sin_cos.py`.

use lagrange_math::sin_cos_each;

use crate::accuracy::BOUND;
use crate::double_double::{self, DoubleDouble, error_in_ulps};

struct Stored {
    angle: f64,
    sine: DoubleDouble,
    cosine: DoubleDouble,
}

fn stored() -> Vec<Stored> {
    let lines = include_str!("reference.txt").lines().filter(|line| !line.starts_with('#'));
    let read = lines.map(|line| {
        let numbers = line.split(' ').map(|bits| u64::from_str_radix(bits, 16).expect("bits of a double"));
        let numbers = numbers.map(f64::from_bits).collect::<Vec<_>>();
        let [angle, sine, sine_low, cosine, cosine_low] = numbers.try_into().expect("five numbers");
        Stored { angle, sine: DoubleDouble(sine, sine_low), cosine: DoubleDouble(cosine, cosine_low) }
    });
    read.collect()
}

#[test]
fn hard_angles_are_within_the_bound() {
    let stored = stored();
    assert_eq!(stored.len(), 1571);
    for Stored { angle, sine, cosine } in stored {
        let [(found_sine, found_cosine)] = sin_cos_each([angle]);
        let errors = [error_in_ulps(found_sine, sine), error_in_ulps(found_cosine, cosine)];
        assert!(errors.iter().all(|error| *error <= BOUND), "{errors:?} at {angle:e}");
    }
}

#[test]
fn the_reference_of_the_sweeps_is_right() {
    for Stored { angle, sine, cosine } in stored() {
        let computed = double_double::sin_cos(angle);
        for (found, value) in [(computed.0, sine), (computed.1, cosine)] {
            let error = (found.0 - value.0) + (found.1 - value.1);
            assert!(
                error.abs() <= 1e-8 * f64::EPSILON * value.0.abs(),
                "{found:?} for {value:?} at {angle:e}"
            );
        }
    }
}
