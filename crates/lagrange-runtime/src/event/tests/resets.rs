//! Events that replace the state at ever shorter intervals.

use std::vec::Vec;

use super::Ball;
use crate::event::Occurrence;
use crate::integrate::{Method, RungeKutta4, Verner98};
use crate::run::integrate_with_events;
use crate::system::{Action, Direction, EventSource, StepFailure};

/// Lets a ball fall by 5 m onto a floor at this height, where it keeps a part of its speed. Follows
/// the ball beyond the time at which it comes to rest. Returns the outcome, and the lowest height
/// observed above the floor.
fn bounce(
    method: &impl Method<Ball>,
    floor: f64,
    kept: f64,
) -> (Result<f64, StepFailure<f64>>, f64, Vec<f64>) {
    let (mut lowest, mut times) = (0.0_f64, Vec::new());
    let watch = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0] - floor]);
    let react = |event: &Occurrence<f64, [f64; 2]>| {
        lowest = lowest.min(event.state[0] - floor);
        times.push(event.time);
        Action::Replace([event.state[0], -kept * event.state[1]])
    };
    let rest = 1.0 + 2.0 * kept / (1.0 - kept);
    let ended = integrate_with_events(&Ball, (0.0, [floor + 5.0, 0.0]), rest + 2.0, method, watch, react);
    let result = match ended {
        Ok((_, end)) => Ok(end[0] - floor),
        Err(error) => {
            lowest = lowest.min(error.state[0] - floor);
            Err(error.cause)
        }
    };
    (result, lowest, times)
}

/// Nothing falls through the floor: infinitely many bounces are an error, and every bounce that
/// exceeds rounding occurs.
#[test]
fn no_ball_tunnels_through_a_floor() {
    for floor in [0.0, -3.7, 100.0] {
        for kept in [0.0, 0.05, 0.3, 0.6, 0.8, 0.9] {
            for tolerance in [1e-4, 1e-9, 1e-13] {
                let (result, lowest, times) = bounce(&Verner98::tolerance(tolerance), floor, kept);
                let what =
                    std::format!("{floor} {kept} {tolerance:e}: {result:?} after {} bounces", times.len());
                assert!(
                    matches!(result, Err(StepFailure::EventsAccumulate { event: EventSource::Given(0), .. })),
                    "{what}"
                );
                assert!(lowest > -1e-6 * (1.0 + floor.abs()), "{what}: {lowest}");
                let mut wanted = 1.0;
                for (n, time) in times.iter().take(12).enumerate().filter(|_| kept > 0.0) {
                    assert!(
                        (time - wanted).abs() < (1e4 * tolerance).clamp(1e-7, 1e-3),
                        "{what}: {time} for {wanted}"
                    );
                    wanted += 2.0 * kept.powi(n as i32 + 1);
                }
            }
            let (result, lowest, _) = bounce(&RungeKutta4 { step: 0.1 }, floor, kept);
            assert!(
                matches!(result, Err(StepFailure::EventsAccumulate { .. })),
                "{floor} {kept}: {result:?}"
            );
            assert!(lowest > -1e-6 * (1.0 + floor.abs()), "{floor} {kept}: {lowest}");
        }
    }
}

/// A ball that is slowed down at a surface sinks through it. This is one event, however little
/// speed remains.
#[test]
fn motions_that_continue_in_their_direction_have_one_event() {
    for kept in [1.0, 0.5, 1e-3, 1e-6] {
        let mut events = Vec::new();
        let watch = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0]]);
        let react = |event: &Occurrence<f64, [f64; 2]>| {
            events.push(event.time);
            Action::Replace([event.state[0], kept * event.state[1]])
        };
        let end =
            integrate_with_events(&Ball, (0.0, [5.0, 0.0]), 2.0, &Verner98::tolerance(1e-10), watch, react);
        let (_, [y, v]) = end.expect("sinks");
        assert_eq!(events.len(), 1, "{kept}: {events:?}");
        assert!(
            (y + 10.0 * kept + 5.0).abs() < 1e-8 && (v + 10.0 * kept + 10.0).abs() < 1e-8,
            "{kept}: {y} {v}"
        );
    }
}

/// A reset to another state starts afresh, on whichever side of zero it is.
#[test]
fn resets_elsewhere_count_from_there() {
    for (to, wanted) in [(5.0, 3), (-7.0, 1), (1.25, 5)] {
        let mut events = 0;
        let watch = ([Direction::Falling], |_: f64, y: &[f64; 2]| [y[0]]);
        let react = |_: &Occurrence<f64, [f64; 2]>| {
            events += 1;
            Action::Replace([to, 0.0])
        };
        integrate_with_events(&Ball, (0.0, [5.0, 0.0]), 3.4, &Verner98::tolerance(1e-10), watch, react)
            .expect("finite");
        assert_eq!(events, wanted, "{to}");
    }
}

#[test]
fn an_accumulation_suggests_a_remedy() {
    let (result, ..) = bounce(&Verner98::tolerance(1e-9), 0.0, 0.5);
    let message = std::format!("{}", result.expect_err("Zeno"));
    assert!(message.contains("accumulate") && message.contains("`impact("), "{message}");
}
