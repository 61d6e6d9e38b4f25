//! Signals that jump, and clocks beside delays.

use lagrange::Simulate;
use lagrange::integrate::RungeKutta4;

lagrange::system! {
    /// A signal that jumps where a state passes a level, in equations with or without jumps.
    struct Stepped;
    param lag = 0.5, bend = 0;
    state x = 0, z = 0;
    dot(x) = 1;
    dot(z) = delay(if x > 0.73 { 1 } else { 0 }, lag) + bend * max(x - 0.73, 0);
}

lagrange::system! {
    /// A counter whose past is integrated.
    struct Counted;
    param lag = 0.3, period = 0.1;
    state x = 1;
    discrete u = 0;
    dot(x) = delay(u, lag);
    every period => { u = u + 1; }
}

#[test]
fn a_signal_that_jumps_is_late_by_its_delay() {
    for lag in [0.5, 0.25, 1.0] {
        for bend in [0.0, 2.0] {
            let stepped = Stepped { lag, bend, ..Stepped::default() };
            let expected = 1.27 - lag + bend * 1.27 * 1.27 / 2.0;
            let adaptive = stepped.simulate(stepped.start()).until(2.0).with_history().run().unwrap();
            assert!((adaptive.last()[1] - expected).abs() < 1e-9, "{lag} {bend}: {:?}", adaptive.last());
            let fixed = stepped.simulate(stepped.start()).until(2.0).method(RungeKutta4 { step: 0.1 });
            let fixed = fixed.with_history().run().unwrap();
            assert!((fixed.last()[1] - expected).abs() < 1e-9, "{lag} {bend}: {:?}", fixed.last());
        }
    }
}

#[test]
fn clocks_tick_as_often_beside_delays_as_without() {
    for (period, lag) in [(0.1, 0.3), (0.1, 0.25), (0.1, 0.1), (0.25, 0.1), (0.1, 0.7)] {
        let counted = Counted { period, lag, ..Counted::default() };
        let ticks = (1.0_f64 / period).round() as i32;
        // The tick at the end of the run belongs to the next one.
        let expected =
            1.0 + (0..ticks).map(|tick| (1.0 - lag - f64::from(tick) * period).max(0.0)).sum::<f64>();
        let adaptive = counted.simulate(counted.start()).until(1.0).with_history().run().unwrap();
        let fixed = counted.simulate(counted.start()).until(1.0).method(RungeKutta4 { step: 0.07 });
        let fixed = fixed.with_history().run().unwrap();
        for [x, u] in [adaptive.last(), fixed.last()] {
            assert_eq!(u, f64::from(ticks), "{period} {lag}");
            // Before the start the signal is zero, as before the first tick.
            assert!((x - expected).abs() < 1e-9, "{period} {lag}: {x} {expected}");
        }
    }
}

#[test]
fn clocks_tick_within_roundings_of_restarts() {
    lagrange::system! {
        /// A counter.
        struct Plain;
        state x = 0;
        discrete u = 0;
        dot(x) = u;
        every 0.1 => { u = u + 1; }
    }
    let plain = Plain;
    let restarts = [0.1 + 0.2, 0.4, 0.1 + 0.5, 0.7000000000000001, 0.8];
    let run = plain.simulate(plain.start()).until(1.0).restart_at(restarts).run().unwrap();
    assert_eq!(run.last()[1], 10.0);
    assert!((run.last()[0] - 5.5).abs() < 1e-12, "{:?}", run.last());
}

#[test]
fn many_delays_cost_a_bounded_number_of_steps() {
    lagrange::system! {
        /// A state with many delays.
        struct Many;
        state x = 1;
        dot(x) = -0.1 * (delay(x, 0.31) + delay(x, 0.43) + delay(x, 0.59) + delay(x, 0.67)
            + delay(x, 0.71) + delay(x, 0.83) + delay(x, 0.97) + delay(x, 1.03));
    }
    let many = Many::default();
    let run = many.simulate(many.start()).until(10.0).with_history().run().unwrap();
    assert!(run.work().steps < 1000, "{:?}", run.work());
    let fine = many.simulate(many.start()).until(10.0).tolerance(1e-12).with_history().run().unwrap();
    assert!((run.last()[0] - fine.last()[0]).abs() < 1e-8);
}
