//! Numbers with the same bits everywhere: alone, in groups, and in lanes with and without fused
//! products.

use std::vec::Vec;

use super::super::{Lanes, Number, Portable, Scalar};
use super::expect;

const ARGUMENTS: [f64; 8] = [0.3, -0.7, 0.999, -2.5, 7.0, 1e6, -1e22, 650.0];

/// Computes the values of all functions at each argument.
fn values<S: Number>(x: S) -> [S; 15] {
    let (sine, cosine) = x.sin_cos();
    let small = sine * S::from_f64(0.9);
    let positive = x.abs();
    [
        sine,
        cosine,
        x.sin(),
        x.cos(),
        x.tan(),
        small.asin(),
        small.acos(),
        x.atan(),
        x.atan2(cosine),
        x.hypot(sine),
        x.sinh() + x.cosh(),
        x.tanh() + small.exp(),
        positive.ln(),
        positive.powf(small) + x.powi(5),
        x.multiply_add(sine, -cosine),
    ]
}

fn lanes<T, const FUSED: bool>(arguments: [T; 8]) -> Vec<[T; 8]>
where
    T: Scalar,
{
    values(Lanes::<T, 8, FUSED>(arguments)).map(|Lanes(values)| values).to_vec()
}

fn check<T>()
where
    T: Copy + PartialEq + core::fmt::Debug,
    Portable<T>: Scalar,
{
    let arguments = ARGUMENTS.map(Portable::<T>::from_f64);
    let alone = arguments.map(values);
    for found in [lanes::<_, true>(arguments), lanes::<_, false>(arguments)] {
        for (row, found) in found.into_iter().enumerate() {
            for (found, alone) in found.into_iter().zip(alone) {
                expect(found, alone[row]);
            }
        }
    }
    let together = Portable::sin_cos_each(arguments);
    assert_eq!(together, arguments.map(Portable::sin_cos));
}

#[test]
fn lanes_have_the_bits_of_a_single_number() {
    check::<f64>();
    check::<f32>();
}

#[test]
fn products_are_never_fused() {
    let more = Portable(1.0 + f64::EPSILON);
    assert_eq!(more.multiply_add(more, -(more * more)), Portable(0.0));
    assert_eq!(more.fused_multiply_add(more, -(more * more)), Portable(0.0));
}

#[test]
fn single_precision_is_rounded_once() {
    for x in ARGUMENTS.map(|x| x as f32) {
        let exact = Portable(f64::from(x)).sin().0;
        assert_eq!(Portable(x).sin().0, exact as f32);
        assert_eq!(Portable(x).tan().0, Portable(f64::from(x)).tan().0 as f32);
    }
}

/// Numbers are formatted as in files.
#[test]
fn numbers_are_written_as_what_they_are() {
    assert_eq!(std::format!("{0:?} {0}", Portable(0.1)), "0.1 0.1");
    assert_eq!(std::format!("{:.2}", Portable(2.0_f32)), "2.00");
}
