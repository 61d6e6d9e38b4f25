//! Handwritten pendulum chains give the reference accelerations.

use std::array::from_fn;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::handwritten::{
    Inline, Platform, absolute_chain, absolute_chain_articulated, absolute_chain_recursive, double_pendulum,
    relative_chain, relative_chain_articulated,
};

const TOLERANCE: f64 = 1e-12;

type Accelerations<const N: usize> = fn(&[f64; N], &[f64; N], &[f64; N], &[f64; N], f64) -> [f64; N];

fn reference(name: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("oracle/{name}.json"));
    let text = fs::read_to_string(path).expect("the reference is in place");
    serde_json::from_str(&text).expect("JSON")
}

fn number(value: &Value) -> f64 {
    value.as_str().expect("a number in a string").parse().expect("a number")
}

#[track_caller]
fn assert_close<const N: usize>(found: [f64; N], expected: [f64; N]) {
    let scale = 1.0 + expected.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= TOLERANCE * scale, "{found:?} is not {expected:?}");
    }
}

/// Compares at every state of a reference.
#[track_caller]
fn assert_reproduces<const N: usize>(name: &str, accelerations: Accelerations<N>) {
    let reference = reference(name);
    assert_eq!(reference["coords"].as_array().map(Vec::len), Some(N), "{name}");
    let states = reference["states"].as_array().expect("states");
    assert_eq!(states.len(), 3, "{name}");
    let m = from_fn(|k| number(&reference["params"][format!("m{}", k + 1)]));
    let l = from_fn(|k| number(&reference["params"][format!("l{}", k + 1)]));
    let g = number(&reference["params"]["g"]);
    for state in states {
        let [q, v, expected] = ["q", "v", "acceleration"].map(|key| from_fn(|k| number(&state[key][k])));
        assert_close(accelerations(&q, &v, &m, &l, g), expected);
    }
}

/// Compares with either kind of sines and cosines.
macro_rules! assert_reproduced {
    ($name:literal by $function:ident $(, $n:literal)?) => {
        assert_reproduces($name, $function::<Platform $(, $n)?>);
        assert_reproduces($name, $function::<Inline $(, $n)?>);
    };
}

#[test]
fn unrolled_double_pendulum() {
    assert_reproduced!("double_pendulum" by double_pendulum);
}

#[test]
fn articulated_chains() {
    assert_reproduced!("double_pendulum" by absolute_chain_articulated, 2);
    assert_reproduced!("chain10_absolute" by absolute_chain_articulated, 10);
    assert_reproduced!("chain6_relative" by relative_chain_articulated, 6);
}

#[test]
fn dense_absolute_chains() {
    assert_reproduced!("double_pendulum" by absolute_chain, 2);
    assert_reproduced!("chain3_absolute" by absolute_chain, 3);
    assert_reproduced!("chain5_absolute" by absolute_chain, 5);
    assert_reproduced!("chain10_absolute" by absolute_chain, 10);
}

#[test]
fn recursive_absolute_chains() {
    assert_reproduced!("double_pendulum" by absolute_chain_recursive, 2);
    assert_reproduced!("chain3_absolute" by absolute_chain_recursive, 3);
    assert_reproduced!("chain5_absolute" by absolute_chain_recursive, 5);
    assert_reproduced!("chain10_absolute" by absolute_chain_recursive, 10);
}

#[test]
fn recursive_relative_chains() {
    assert_reproduced!("chain4_relative" by relative_chain, 4);
    assert_reproduced!("chain6_relative" by relative_chain, 6);
}

#[test]
fn a_chain_of_one_rod_is_a_pendulum() {
    let (q, v, m, l, g) = ([0.4_f64], [1.5], [2.0], [0.8], 9.81);
    let expected = [-g / l[0] * q[0].sin()];
    for accelerations in [
        absolute_chain::<Platform, 1>,
        absolute_chain_recursive::<Platform, 1>,
        relative_chain::<Platform, 1>,
        relative_chain::<Inline, 1>,
    ] {
        assert_close(accelerations(&q, &v, &m, &l, g), expected);
    }
}

/// References from 60-digit arithmetic; the inputs are the nearest doubles.
#[allow(clippy::excessive_precision, reason = "references are kept as they were computed")]
#[test]
fn no_digits_are_lost_at_extreme_masses_lengths_and_angles() {
    let cases = [
        (
            [1.0, 1e12],
            [1.0, 1.0],
            [0.3, 0.3 + 1e-6],
            [1.0, -2.0],
            [7185922.5801052774695, -7185925.4791652837055],
        ),
        ([1e12, 1.0], [1.0, 1.0], [0.3, 0.7], [1.0, -2.0], [-2.8990532273424634461, -4.0389890068670782784]),
        (
            [1e-12, 1.0],
            [1.0, 1.0],
            [0.3, 0.300001],
            [1.0, 1.0],
            [5685922.5801052775267, -5685925.4791660337627],
        ),
        (
            [1.0, 1.0],
            [1.0, 1.0],
            [1e8, 1e8 + 1.0],
            [1.0, -2.0],
            [-7.8514966240371895007, 1.4623655439404468463],
        ),
        (
            [1e-160, 1e-160],
            [1.0, 1.0],
            [0.3, 0.7],
            [1.0, -2.0],
            [1.6838009146585669862, -8.2600771982687864906],
        ),
        ([1.0, 1.0], [1e-9, 1.0], [0.3, 0.7], [1.0, -2.0], [1372352914.0529459749, -7.5837962513315300026]),
        (
            [1.0, 1.0],
            [1.0, 1.0],
            [1e-9, -1e-9],
            [0.0, 0.0],
            [-2.9430000000000003183e-8, 3.9240000000000004231e-8],
        ),
    ];
    for (m, l, q, v, expected) in cases {
        for accelerations in [
            double_pendulum::<Platform>,
            double_pendulum::<Inline>,
            absolute_chain_recursive::<Platform, 2>,
            absolute_chain_recursive::<Inline, 2>,
        ] {
            let found = accelerations(&q, &v, &m, &l, 9.81);
            for (a, b) in found.iter().zip(expected) {
                assert!((a - b).abs() <= 1e-14 * b.abs(), "{found:?} is not {expected:?}");
            }
        }
    }
}

#[test]
fn long_chains_agree_among_the_methods() {
    let q: [f64; 20] = from_fn(|k| 0.3 + 0.17 * k as f64);
    let v = from_fn(|k| 0.1 * (k as f64).cos());
    let (m, l) = (from_fn(|k| 1.0 - 0.03 * k as f64), from_fn(|k| 0.5 + 0.02 * k as f64));
    let expected = absolute_chain::<Platform, 20>(&q, &v, &m, &l, 9.81);
    assert_close(absolute_chain_recursive::<Platform, 20>(&q, &v, &m, &l, 9.81), expected);

    let joints = |x: &[f64; 20]| from_fn(|k| if k == 0 { x[0] } else { x[k] - x[k - 1] });
    assert_close(relative_chain::<Inline, 20>(&joints(&q), &joints(&v), &m, &l, 9.81), joints(&expected));
}
