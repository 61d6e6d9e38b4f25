//! Histories that a declaration states, against closed forms.

use lagrange::Simulate;
use lagrange::integrate::{Radau5, RungeKutta4};

lagrange::system! {
    /// A state that followed a straight line up to the start.
    #[derive(Clone, Debug)]
    struct Line;
    param slope = 1;
    state x = 1;
    history x = 1 + slope * t;
    let past = delay(x, 1);
    dot(x) = -past;
}

/// x is 1 − s t²/2 − (1 − s) t up to one.
#[test]
fn a_line_is_seen_before_the_start() {
    for slope in [1.0, 0.5] {
        let line = Line { slope, ..Line::default() };
        let motion = line.simulate(line.start()).until(1.0).every(0.25).with_history().run().unwrap();
        for ((t, x), past) in motion.times().iter().zip(motion.x()).zip(motion.column("past").unwrap()) {
            assert!((x - (1.0 - slope * t * t / 2.0 - (1.0 - slope) * t)).abs() < 1e-13, "{x} at {t}");
            assert!((past - (1.0 + slope * (t - 1.0))).abs() < 1e-13, "{past} at {t}");
        }
    }
    // From 1/2 at one on, the rate is −1 + (t − 1)²/2.
    let line = Line::default();
    let motion = line.simulate(line.start()).until(2.0).with_history().run().unwrap();
    assert!((motion.last()[0] + 1.0 / 3.0).abs() < 1e-12, "{:?}", motion.last());
    let motion = line.simulate(line.start()).until(2.0).with_history().method(Radau5::tolerance(1e-10));
    assert!((motion.run().unwrap().last()[0] + 1.0 / 3.0).abs() < 1e-9);
}

/// Histories are functions of time itself, not of the time since the start.
#[test]
fn a_later_start_sees_later_parts_of_the_formula() {
    let line = Line::default();
    let motion = line.simulate([7.0]).from(2.0).until(3.0).with_history().run().unwrap();
    assert!((motion.last()[0] - 4.5).abs() < 1e-12, "{:?}", motion.last());
}

/// A second run from the end of the first one sees the formula up to its own start. Its rate from
/// one to two is −t, not −1 + (t − 1)²/2.
#[test]
fn a_run_that_continues_another_one_sees_the_formula() {
    let line = Line::default();
    let first = line.simulate(line.start()).until(1.0).with_history().run().unwrap();
    let second = line.simulate(first.last()).from(1.0).until(2.0).with_history().run().unwrap();
    assert!((second.last()[0] + 1.0).abs() < 1e-12, "{:?}", second.last());
}

/// The state jumps from zero to one at the start, and its rate one delay later.
#[test]
fn a_jump_at_the_start_is_noticed_one_delay_later() {
    let line = Line { slope: 0.0, ..Line::default() };
    let smooth = line.simulate([1.0]).until(2.0).with_history().run().unwrap();
    assert!((smooth.last()[0] + 0.5).abs() < 1e-12);
    let jump = Jump::default();
    for step in [0.07, 0.3] {
        let fixed = jump.simulate(jump.start()).until(2.0).with_history().method(RungeKutta4 { step });
        assert!(fixed.run().unwrap().last()[0].abs() < 1e-12);
    }
    let motion = jump.simulate(jump.start()).until(2.0).with_history().run().unwrap();
    assert!(motion.last()[0].abs() < 1e-12, "{:?}", motion.last());
    assert!(motion.times().iter().any(|t| (t - 1.0).abs() < 1e-12), "{:?}", motion.times());
}

lagrange::system! {
    struct Jump;
    state x = 1;
    history x = 0;
    dot(x) = -delay(x, 1);
}

lagrange::system! {
    /// An oscillator whose forces are as late as its phase is early. It follows its history.
    struct Wave<S>;
    param w = 3, lag = 0.2;
    coord x = 1, spectator = 0.5;
    history x = cos(w * t);
    kinetic = 1/2 * (dot(x)^2 + dot(spectator)^2);
    let (near, far) = (delay(x, lag), delay(dot(x) + 0 * spectator, lag));
    force x = -w^2 * cos(w * lag) * near - w * sin(w * lag) * far;
}

#[test]
fn velocities_before_the_start_are_rates_of_the_history() {
    let wave = Wave::<f64>::default();
    let motion = wave.simulate(wave.start()).until(5.0).every(0.05).tolerance(1e-11).with_history();
    let motion = motion.run().unwrap();
    for (t, x) in motion.times().iter().zip(motion.x()) {
        assert!((x - (3.0 * t).cos()).abs() < 1e-8, "{x} at {t}");
    }
    let single = Wave::<f32>::default();
    let motion = single.simulate(single.start()).until(1.0).with_history().run().unwrap();
    assert!((motion.last()[0] - 3.0_f32.cos()).abs() < 1e-4, "{:?}", motion.last());
}

lagrange::system! {
    /// A delay of a delay, of a sum with an input.
    struct Nested;
    input u = 2;
    state x[2] = 1;
    history x[0] = 1 + t;
    let once = delay(x[0] + u, 1);
    dot(x[0]) = -delay(once, 1/2);
    dot(x[1]) = delay(x[1] * t, 1);
}

/// The first state is 1 − ∫ (1 + s − 3/2 + 2) ds, and the second 1 + ∫ (s − 1) ds, up to one.
#[test]
fn delays_of_delays_look_further_back() {
    let nested = Nested::default();
    let motion = nested.simulate(nested.start()).until(1.0).with_history().run().unwrap();
    let [x, y] = motion.last();
    assert!((x + 1.0).abs() < 1e-12 && (y - 0.5).abs() < 1e-12, "{x} {y}");
    // An input that changes after the start does not change the past.
    let control = |nested: &Nested, t: f64, _: NestedState| {
        let u = if t < 0.25 { 2.0 } else { 9.0 };
        NestedInputs { u, ..lagrange::system::ControlledSystem::inputs(nested) }
    };
    let driven = nested.simulate(nested.start()).until(1.0).sampled(0.5, control).with_history();
    assert!((driven.run().unwrap().last()[0] + 1.0).abs() < 1e-12);
}

#[test]
#[cfg(feature = "ensemble")]
fn motions_of_ensembles_have_the_bits_of_single_runs() {
    use lagrange::Ensembles;
    let line = Line::default();
    let slopes = |index: usize| 0.1 * index as f64;
    let ensemble = line.ensemble(9).start(|_, _| [1.0]).parameters(|index, line| line.slope = slopes(index));
    let ends = ensemble.until(3.0).with_history().run().unwrap();
    for (index, x) in ends.x().iter().enumerate() {
        let single = Line { slope: slopes(index), ..Line::default() };
        let motion = single.simulate([1.0]).until(3.0).with_history().run().unwrap();
        assert_eq!(motion.last()[0].to_bits(), x.to_bits(), "{index}");
    }
}
