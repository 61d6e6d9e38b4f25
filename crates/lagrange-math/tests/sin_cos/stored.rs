//! Values computed with 300 bits and stored, see `tools/sin_cos.py`.

use lagrange_math::LARGEST_ANGLE;

use crate::accuracy::{FUNCTIONS, error};
use crate::double_double::{self, DoubleDouble};

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
    let large = stored.iter().filter(|stored| stored.angle > LARGEST_ANGLE).count();
    assert_eq!((stored.len() - large, large), (1571, 2451));
    for (function, bound) in FUNCTIONS {
        let mut largest = (0.0, 0.0);
        for Stored { angle, sine, cosine } in &stored {
            let error = error(function(*angle), (*sine, *cosine));
            assert!(error <= bound, "{error} at {angle:e}");
            largest = if error > largest.0 { (error, *angle) } else { largest };
        }
        println!("{largest:?}");
        assert!(largest.0 > 0.49);
    }
}

#[test]
fn the_reference_of_the_sweeps_is_right() {
    for Stored { angle, sine, cosine } in stored().into_iter().filter(|stored| stored.angle <= LARGEST_ANGLE)
    {
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
