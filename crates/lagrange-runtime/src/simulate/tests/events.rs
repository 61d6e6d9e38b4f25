//! Events between samples.

use std::f64::consts::PI;
use std::string::ToString;
use std::vec::Vec;

use super::{Oscillator, START, exact};
use crate::simulate::{Ending, Simulate};
use crate::system::{Action, Direction, EventSource, StepFailure};

#[test]
fn events_are_recorded_by_name_and_in_order() {
    let simulation = Oscillator.simulate(START).until(7.0).tolerance(1e-12).ends_only();
    let trajectory = simulation
        .event("at rest", Direction::Crossing, |_, _, [_, v]| *v)
        .event("through", Direction::Falling, |_, _, [x, _]| *x)
        .run()
        .expect("runs");
    let found: Vec<_> = trajectory.events().iter().map(|event| (event.name.as_str(), event.time)).collect();
    assert_eq!(found.iter().map(|(name, _)| *name).collect::<Vec<_>>(), ["through", "at rest", "at rest"]);
    for ((_, time), expected) in found.iter().zip([PI / 2.0, PI, 2.0 * PI]) {
        assert!((time - expected).abs() < 1e-10, "{time}");
    }
    assert_eq!((trajectory.len(), trajectory.ending()), (2, Ending::Reached));
}

#[test]
fn a_run_stops_at_an_event() {
    let simulation = || {
        let simulation = Oscillator.simulate(START).until(10.0).tolerance(1e-12).dense();
        simulation.stop_at("through", Direction::Falling, |_, _, [x, _]| *x)
    };
    for trajectory in [simulation().run(), simulation().every(0.5).run(), simulation().ends_only().run()] {
        let trajectory = trajectory.expect("stopping is no failure");
        assert_eq!(trajectory.ending(), Ending::Stopped);
        assert!((trajectory.end_time() - PI / 2.0).abs() < 1e-10);
        assert!(trajectory.last()[0].abs() < 1e-10);
        assert_eq!(trajectory.iter().last(), Some((trajectory.end_time(), trajectory.last())));
        assert!(trajectory.times().windows(2).all(|pair| pair[0] < pair[1]));
        assert!(trajectory.at(1.6).is_err());
        let ([x, v], [x0, v0]) = (trajectory.at(1.5).expect("before the event"), exact(1.5));
        assert!((x - x0).abs() < 1e-10 && (v - v0).abs() < 1e-10);
    }
}

/// With a wall at 0 the oscillator moves as without it, but mirrored.
#[test]
fn a_run_continues_from_another_state() {
    let simulation = || {
        let simulation = Oscillator.simulate(START).until(7.0).tolerance(1e-12).dense();
        let bounce = |_: &Oscillator, [x, v]: [f64; 2]| Action::Replace([x, -v]);
        simulation.event_with(
            "bounce",
            Direction::Falling,
            |_, _, [x, _]| *x,
            move |system, event| bounce(system, event.state),
        )
    };
    let steps = simulation().run().expect("runs");
    assert_eq!(steps.events().len(), 2);
    let jumps = steps.times().windows(2).filter(|pair| pair[0] == pair[1]).count();
    assert_eq!(jumps, 2, "both sides of a jump are samples");
    let grid = simulation().every(0.25).run().expect("runs");
    assert_eq!(grid.len(), 29);
    for trajectory in [&steps, &grid] {
        for (t, [x, _]) in trajectory.iter() {
            assert!((x - t.cos().abs()).abs() < 1e-10, "at {t}");
        }
        let [_, v] = trajectory.at(trajectory.events()[0].time).expect("within");
        assert!((v - 1.0).abs() < 1e-10, "the state after the jump");
        let [x, v] = trajectory.at(2.0).expect("within");
        assert!((x + 2.0_f64.cos()).abs() < 1e-10 && (v - 2.0_f64.sin()).abs() < 1e-10);
    }
}

#[test]
fn an_event_function_that_is_not_a_number_is_an_error_that_names_it() {
    let error = Oscillator
        .simulate(START)
        .until(10.0)
        .event("fine", Direction::Rising, |_, _, [x, _]| *x)
        .event("broken", Direction::Rising, |_, t, _| if t > 3.0 { f64::NAN } else { 1.0 })
        .run()
        .expect_err("fails");
    assert_eq!(error.cause, StepFailure::EventNotFinite { event: EventSource::Given(1) });
    assert_eq!(error.name.as_deref(), Some("broken"));
    assert!(
        error.to_string().starts_with("the function of event `broken` is NaN or infinite (at time "),
        "{error}"
    );
    assert!(error.time() <= 3.0 && error.trajectory.len() > 1);
}
