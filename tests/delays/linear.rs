//! ẋ = −k x(t − 1) with x = 1 up to the start, whose motion is a polynomial between integers.

use lagrange::Simulate;
use lagrange::integrate::Radau5;

lagrange::system! {
    #[derive(Clone, Debug)]
    pub struct Late;
    param k = 1, lag = 1;
    state x = 1;
    dot(x) = -k * delay(x, lag);
}

lagrange::system! {
    #[scalar(f32)]
    struct LateSingle;
    state x = 1;
    dot(x) = -delay(x, 1);
}

/// Returns x(t) = Σ (−k)ʲ (t − j + 1)ʲ / j! over j up to ⌊t⌋ + 1.
fn closed_form(k: f64, t: f64) -> f64 {
    let (mut sum, mut factorial) = (1.0, 1.0);
    for j in 1..=t.floor() as i32 + 1 {
        factorial *= f64::from(j);
        sum += (-k).powi(j) * (t - f64::from(j) + 1.0).powi(j) / factorial;
    }
    sum
}

#[test]
fn the_adaptive_method_follows_the_polynomials() {
    let late = Late::default();
    let motion = late.simulate([1.0]).until(12.0).every(0.05).tolerance(1e-12).with_history().run().unwrap();
    for (t, x) in motion.times().iter().zip(motion.x()) {
        assert!((x - closed_form(1.0, *t)).abs() < 2e-12, "{x} at {t}");
    }
    // Degrees up to nine are exact for the method, whatever its tolerance.
    let coarse = late.simulate([1.0]).until(7.5).tolerance(1e-4).with_history().run().unwrap();
    assert!((coarse.last()[0] - closed_form(1.0, 7.5)).abs() < 1e-13);
}

#[test]
fn steps_end_where_derivatives_jump_and_nowhere_else() {
    let late = Late::default();
    let motion = late.simulate([1.0]).until(40.0).tolerance(1e-9).with_history().run().unwrap();
    for jump in 1..=8 {
        assert!(motion.times().iter().any(|t| (t - f64::from(jump)).abs() < 1e-12), "{jump}");
    }
    let is_of_no_concern = |t: &f64| (t - 10.0).abs() > 1e-12 && (t - 11.0).abs() > 1e-12;
    assert!(motion.times().iter().all(is_of_no_concern), "{:?}", motion.times());
}

#[test]
fn an_implicit_method_follows_them_too() {
    let late = Late::default();
    let motion =
        late.simulate([1.0]).until(6.5).with_history().method(Radau5::tolerance(1e-10)).run().unwrap();
    let error = (motion.last()[0] - closed_form(1.0, 6.5)).abs();
    assert!(error < 1e-8, "{error}");
}

#[test]
fn single_precision_loses_no_more_than_its_digits() {
    let late = LateSingle::default();
    let motion = late.simulate([1.0]).until(5.5).with_history().run().unwrap();
    assert!((f64::from(motion.last()[0]) - closed_form(1.0, 5.5)).abs() < 2e-5);
}

#[test]
fn times_far_from_zero_change_little() {
    let late = Late::default();
    let motion =
        late.simulate([1.0]).from(1e6).until(1e6 + 4.5).tolerance(1e-11).with_history().run().unwrap();
    assert!((motion.last()[0] - closed_form(1.0, 4.5)).abs() < 1e-9);
}

/// Source: Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, §II.17: the zero
/// solution is stable for 0 ≤ k < π/2, where λ = ± iπ/2 solves λ = −k e^(−λ).
#[test]
fn motions_neither_grow_nor_decay_at_the_boundary_of_stability() {
    let largest = |k: f64, from: f64, to: f64| {
        let late = Late { k, ..Late::default() };
        let motion = late.simulate([1.0]).until(to).every(0.02).with_history().run().unwrap();
        let late = motion.times().iter().zip(motion.x()).filter(|(t, _)| **t >= from);
        late.map(|(_, x)| x.abs()).fold(0.0, f64::max)
    };
    let boundary = std::f64::consts::FRAC_PI_2;
    let ratio = |k: f64| largest(k, 76.0, 80.0) / largest(k, 36.0, 40.0);
    assert!((ratio(boundary) - 1.0).abs() < 1e-6);
    // The dominant root moves by dλ = Re(λ/(k (1 + λ))) dk, over 40.
    let rate = boundary / (1.0 + boundary * boundary);
    for change in [-0.02, 0.02] {
        let expected = (40.0 * rate * change).exp();
        assert!((ratio(boundary + change) / expected - 1.0).abs() < 0.05, "{change}");
    }
}

#[test]
fn short_delays_cost_steps_and_no_accuracy() {
    let late = Late { lag: 1e-3, ..Late::default() };
    let motion = late.simulate([1.0]).until(1.0).with_history().run().unwrap();
    // λ = −e^(−λ/1000) of the dominant root, and its residue 1/(1 + λ/1000).
    let mut root = -1.0_f64;
    for _ in 0..50 {
        root = -(-root * 1e-3).exp();
    }
    let expected = root.exp() / (1.0 + root * 1e-3) / -root;
    assert!((motion.last()[0] - expected).abs() < 1e-9, "{}", motion.last()[0] - expected);
    assert!(motion.work().steps >= 1000);
}

lagrange::system! {
    /// A delay of a delay, and one as long as both. A parameter may have the name of the function.
    struct Twice;
    param delay = 1/2;
    state x = 1, y = 1;
    let once = delay(x, 1);
    dot(x) = -delay(once, delay);
    dot(y) = -delay(y, 3/2);
}

#[test]
fn delays_of_delays_add_up() {
    let twice = Twice::default();
    let motion = twice.simulate(twice.start()).until(9.0).every(0.25).tolerance(1e-12).with_history();
    let motion = motion.run().unwrap();
    for ((t, x), y) in motion.times().iter().zip(motion.x()).zip(motion.y()) {
        let expected = closed_form(1.5, t / 1.5);
        assert!(
            (x - expected).abs() < 1e-11 && (y - expected).abs() < 1e-11,
            "{x}, {y} and {expected} at {t}"
        );
    }
}

#[test]
#[cfg(feature = "ensemble")]
fn motions_of_ensembles_have_the_bits_of_single_runs() {
    use lagrange::Ensembles;
    let late = Late::default();
    let lags = |index: usize| 0.5 + 0.1 * index as f64;
    let ensemble = late.ensemble(20).start(|_, _| [1.0]).parameters(|index, late| late.lag = lags(index));
    let ends = ensemble.until(5.0).with_history().run().unwrap();
    for (index, x) in ends.x().iter().enumerate() {
        let single = Late { lag: lags(index), ..late.clone() };
        let motion = single.simulate([1.0]).until(5.0).with_history().run().unwrap();
        assert_eq!(motion.last()[0].to_bits(), x.to_bits(), "{index}");
    }
}
