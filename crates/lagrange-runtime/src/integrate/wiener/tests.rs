//! Comparison of paths with the properties of Wiener processes.

use super::WienerPath;

/// Returns W and H of the first noise over a step.
fn over(path: WienerPath, index: i64) -> [f64; 2] {
    path.increments().over(0, index)
}

/// Returns W and H of a whole from its parts of length one: the area is the sum of the integrals
/// over the parts.
fn joined(parts: &[[f64; 2]]) -> [f64; 2] {
    let (mut sum, mut integral) = (0.0, 0.0);
    for [w, h] in parts {
        integral += sum + w / 2.0 + h;
        sum += w;
    }
    [sum, integral / parts.len() as f64 - sum / 2.0]
}

#[test]
fn halves_of_a_step_are_the_step_in_more_detail() {
    let path = WienerPath::of_seed(7).of_motion(3);
    for cell in [-3, -1, 0, 1, 1 << 40] {
        let parts =
            (8 * cell..8 * cell + 8).map(|index| over(path.halved(3), index)).collect::<std::vec::Vec<_>>();
        let whole = over(path, cell).map(|value| value * 8.0_f64.sqrt());
        for (one, other) in joined(&parts).into_iter().zip(whole) {
            assert!((one - other).abs() < 1e-14, "{cell}: {one} {other}");
        }
    }
}

/// Checks that the mean of products is within five standard errors of the expected value. The
/// products of independent normal numbers with these variances have the variance of their product.
fn assert_mean(products: impl Iterator<Item = f64>, expected: f64, variance: f64) {
    let products = products.collect::<std::vec::Vec<_>>();
    let number = products.len() as f64;
    let mean = products.iter().sum::<f64>() / number;
    assert!((mean - expected).abs() < 5.0 * (variance / number).sqrt(), "{mean}, not {expected}");
}

#[test]
fn increments_and_areas_have_their_variances_and_nothing_in_common() {
    let twelfth = 1.0 / 12.0;
    for halvings in [0, 1, 5] {
        let path = WienerPath::of_seed(1).halved(halvings);
        let steps = || (-20_000..20_000).map(|index| (over(path, index), over(path, index + 1)));
        assert_mean(steps().map(|([w, _], _)| w * w), 1.0, 2.0);
        assert_mean(steps().map(|([_, h], _)| h * h), twelfth, 2.0 * twelfth * twelfth);
        assert_mean(steps().map(|([w, h], _)| w * h), 0.0, twelfth);
        assert_mean(steps().map(|([w, _], [next, _])| w * next), 0.0, 1.0);
        assert_mean(steps().map(|([_, h], [_, next])| h * next), 0.0, twelfth * twelfth);
        assert_mean(steps().map(|([_, h], [next, _])| h * next), 0.0, twelfth);
    }
}

#[test]
fn noises_motions_and_seeds_have_paths_of_their_own() {
    let path = WienerPath::of_seed(1);
    let others = [path.of_motion(1), WienerPath::of_seed(2)];
    let steps = || 0..20_000;
    for other in others {
        assert_mean(steps().map(|index| over(path, index)[0] * over(other, index)[0]), 0.0, 1.0);
    }
    let second = |index| path.increments().over(1, index)[0];
    assert_mean(steps().map(|index| over(path, index)[0] * second(index)), 0.0, 1.0);
}

/// Checks bits that must never change on any platform.
#[test]
fn paths_are_the_same_on_every_platform() {
    let bits = over(WienerPath::of_seed(7).of_motion(41).halved(2), 5).map(f64::to_bits);
    assert_eq!(bits, [0xbfe0_a3c1_c413_b5c4, 0xbfad_a548_77e5_6208]);
}
