//! Predictions of slopes that are polynomials.

use super::Prediction;

/// Returns a cubic, which three nodes and the end determine.
fn slope(t: f64) -> [f64; 1] {
    [1.0 - 2.0 * t + 0.5 * t * t + t * t * t]
}

const NODES: [f64; 3] = [0.1, 0.5, 0.8];

#[test]
fn polynomials_are_continued_into_steps_of_any_length() {
    let mut prediction = Prediction::new(NODES, NODES);
    prediction.learn(NODES.map(|node| slope(2.0 * node)), 2.0);
    for h in [2.0, 2.0, 0.7, -1.5] {
        let predicted = prediction.slopes(&slope(2.0), h);
        for ([predicted], node) in predicted.into_iter().zip(NODES) {
            let [expected] = slope(2.0 + node * h);
            assert!((predicted - expected).abs() < 1e-12 * expected.abs().max(1.0), "{predicted} {expected}");
        }
    }
}

#[test]
fn without_a_last_step_slopes_are_that_of_the_start() {
    let mut prediction = Prediction::new(NODES, NODES);
    assert_eq!(prediction.slopes(&[3.0], 0.1), [[3.0]; 3]);
    prediction.learn(NODES.map(slope), 1.0);
    prediction.forget();
    assert_eq!(prediction.slopes(&[3.0], 0.1), [[3.0]; 3]);
}
