//! States between the samples.

use super::{Oscillator, START, exact};
use crate::integrate::RungeKutta4;
use crate::simulate::dense::Dense;
use crate::simulate::{NotKept, Simulate, Trajectory};

fn largest_error(trajectory: &Trajectory<Oscillator>) -> f64 {
    let (from, to) = (trajectory.start_time(), trajectory.end_time());
    let error = |k: i32| {
        let t = from + (to - from) * f64::from(k) / 9973.0;
        let ([x, v], [x0, v0]) = (trajectory.at(t).expect("within"), exact(t));
        (x - x0).hypot(v - v0)
    };
    (0..=9973).map(error).fold(0.0, f64::max)
}

#[test]
fn states_anywhere_are_as_good_as_those_at_steps() {
    for tolerance in [1e-6, 1e-9, 1e-12] {
        for end in [10.0, -10.0] {
            let run = Oscillator.simulate(START).until(end).tolerance(tolerance).dense().run().expect("runs");
            let error = largest_error(&run);
            assert!(error < 20.0 * tolerance, "{error:e} at tolerance {tolerance:e}");
        }
    }
}

#[test]
fn they_agree_with_the_samples() {
    let simulation = || Oscillator.simulate(START).until(5.0).tolerance(1e-10);
    let dense = simulation().dense().every(0.01).run().expect("runs");
    for (t, y) in dense.iter() {
        let at = dense.at(t).expect("within");
        assert!((at[0] - y[0]).abs() < 1e-14 && (at[1] - y[1]).abs() < 1e-14, "at {t}");
    }
    assert_eq!(dense.at(5.0), Ok(dense.last()));
    assert_eq!(dense.at(0.0), Ok(START));
    assert_eq!(dense.len(), simulation().every(0.01).run().expect("runs").len());
}

#[test]
fn methods_of_low_order_keep_their_interpolation() {
    let method = RungeKutta4 { step: 0.05 };
    let trajectory = Oscillator.simulate(START).until(5.0).method(method).dense().run().expect("runs");
    let error = largest_error(&trajectory);
    assert!(error < 1e-6, "{error:e}");
}

#[test]
fn discarded_states_are_not_invented() {
    let trajectory = Oscillator.simulate(START).until(1.0).run().expect("runs");
    assert_eq!(trajectory.at(0.5), Err(NotKept::NotDense));
    let trajectory = Oscillator.simulate(START).from(1.0).until(2.0).dense().run().expect("runs");
    for time in [0.999, 2.001, f64::INFINITY] {
        assert_eq!(trajectory.at(time), Err(NotKept::Outside { time, start: 1.0, end: 2.0 }));
    }
    assert!(trajectory.at(f64::NAN).is_err());
}

#[test]
fn a_polynomial_of_the_degree_comes_back() {
    for order in [1, 4, 9] {
        let degree = i32::try_from(order).expect("small").max(4) + 1;
        let power = |t: f64| [1.0 - t.powi(degree)];
        let mut dense = Dense::<f64, [f64; 1]>::new(order);
        dense.push((0.0, 2.0), &mut |t| power(t));
        for k in 0..100 {
            let t = 0.02 * f64::from(k);
            let [y] = dense.at(t).expect("within");
            assert!((y - power(t)[0]).abs() < 1e-14 * power(2.0)[0].abs(), "order {order} at {t}");
        }
    }
}

/// Holds for times arbitrarily close to a point of a polynomial, and for very small or large times
/// and states.
#[test]
fn states_next_to_points_are_those_there() {
    for order in [1, 4, 9] {
        for (from, to) in [
            (0.0, 2.0),
            (0.0, -2.0),
            (-1.0, 1.0),
            (0.0, 1e-300),
            (0.0, 1e-323),
            (-5e-324, 5e-324),
            (1e15, 1e15 + 2.0),
        ] {
            // States are known at the numbers next to the points.
            let tolerance = 1e-13 + 4.0 * f64::EPSILON * f64::max(from, -to) / f64::abs(to - from);
            for size in [1.0, 1e-300, 1e300] {
                let line = |t: f64| [size * (3.0 + 2.0 * ((t - from) / (to - from)))];
                let mut dense = Dense::<f64, [f64; 1]>::new(order);
                dense.push((from, to), &mut |t| line(t));
                let near = |t: f64| {
                    [t.next_down().next_down(), t.next_down(), t, t.next_up(), t.next_up().next_up()]
                };
                let places =
                    (0..=16).map(|k| from + f64::from(k) / 16.0 * (to - from)).chain([0.0, 1e-308, -1e-320]);
                for t in places.flat_map(near).filter(|t| (from.min(to)..=from.max(to)).contains(t)) {
                    let [y] = dense.at(t).expect("within");
                    assert!(
                        (y / line(t)[0] - 1.0).abs() < tolerance,
                        "order {order}, {from}..{to}, {t:e}: {y:e}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_trajectory_is_known_at_the_smallest_times() {
    for (from, until) in [(0.0, 1.0), (0.0, -1.0), (-1.0, 1.0)] {
        let trajectory =
            Oscillator.simulate(exact(from)).from(from).until(until).tolerance(1e-9).dense().run();
        let trajectory = trajectory.expect("runs");
        for t in [5e-324, 1e-310, 1e-300, 1e-100].into_iter().flat_map(|t| [t, -t]) {
            let is_within = from.min(until) <= t && t <= from.max(until);
            let found = trajectory.at(t).ok().map(|[x, v]| (x - START[0]).hypot(v - START[1]) < 1e-8);
            assert_eq!(found, is_within.then_some(true), "{t:e} from {from} to {until}");
        }
    }
}
