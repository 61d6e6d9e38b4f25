//! Events of a declaration, in the loops without heap.

use std::string::ToString;
use std::vec::Vec;

use crate::event::Occurrence;
use crate::integrate::RungeKutta4;
use crate::run::{integrate, integrate_with_events};
use crate::system::{
    Action, DeclaredEvent, Direction, EventSource, OdeSystem, Reacted, Response, StepFailure,
};

/// ẏ = 1 with four events: one is recorded, one moves the state, one ends the motion, and one is
/// NaN later.
#[derive(Clone, Copy)]
struct Marks {
    /// Displacement of the state by the second event.
    jump: f64,
    /// The state beyond which the last function is NaN.
    edge: f64,
}

impl OdeSystem for Marks {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [1.0]
    }

    const EVENTS: &'static [DeclaredEvent] = &[
        DeclaredEvent::new("one", Direction::Rising),
        DeclaredEvent::new("two", Direction::Rising),
        DeclaredEvent::new("five", Direction::Rising),
        DeclaredEvent::new("edge", Direction::Crossing),
    ];

    fn event_values(&self, t: f64, y: &[f64; 1], values: &mut [f64]) {
        values.copy_from_slice(&[y[0] - 1.0, y[0] - 2.0, y[0] - 5.0, (self.edge - t).sqrt() + 1.0]);
    }

    fn react(&self, event: usize, _t: f64, _elapsed: f64, y: &[f64; 1]) -> Reacted<Self> {
        Ok(Response::new(match event {
            1 => Action::Replace([y[0] + self.jump]),
            2 => Action::Stop,
            _ => Action::Continue,
        }))
    }
}

const MARKS: Marks = Marks { jump: 0.5, edge: 1e9 };

#[test]
fn declared_events_are_detected_by_default() {
    let method = RungeKutta4 { step: 0.3 };
    let mut seen = Vec::new();
    let end = integrate(&MARKS, 0.0, [0.0], 9.0, &method, |t, y| seen.push((t, y[0]))).expect("stops");
    assert!((end[0] - 5.0).abs() < 1e-12);
    let jump = seen.windows(2).find(|pair| pair[0].0 == pair[1].0).expect("both sides of the jump are shown");
    assert!((jump[0].1 - 2.0).abs() < 1e-12 && (jump[1].1 - 2.5).abs() < 1e-12, "{jump:?}");
    assert!((seen[seen.len() - 1].0 - 4.5).abs() < 1e-12, "it ends where it stops");
}

#[test]
fn given_events_come_between_declared_ones() {
    let mut times = Vec::new();
    let watch = ([Direction::Rising; 2], |t: f64, _: &[f64; 1]| [t - 1.5, t - 3.5]);
    let react = |event: &Occurrence<f64, [f64; 1]>| {
        times.push(event.state[0]);
        Action::Continue
    };
    let method = RungeKutta4 { step: 2.0 };
    let (t, _) = integrate_with_events(&MARKS, (0.0, [0.0]), 9.0, &method, watch, react).expect("stops");
    assert!((t - 4.5).abs() < 1e-12);
    assert!((times[0] - 1.5).abs() < 1e-12 && (times[1] - 4.0).abs() < 1e-12, "after the jump: {times:?}");
}

#[test]
fn nan_is_reported_by_name_or_index() {
    let go_on = |_: &Occurrence<f64, [f64; 1]>| Action::Continue;
    let run = |system: Marks, bad: f64| {
        let watch = ([Direction::Rising; 2], move |t: f64, _: &[f64; 1]| [-1.0, (bad - t).sqrt()]);
        let method = RungeKutta4 { step: 0.1 };
        integrate_with_events(&system, (0.0, [0.0]), 4.0, &method, watch, go_on).expect_err("NaN")
    };
    let declared = run(Marks { edge: 0.55, ..MARKS }, 1e9);
    assert_eq!(declared.cause, StepFailure::EventNotFinite { event: EventSource::Declared("edge") });
    assert!(declared.state[0].is_finite());
    assert!(
        declared.to_string().starts_with("the function of event `edge` is NaN or infinite (at time 0.5"),
        "{declared}"
    );
    assert_eq!(run(MARKS, 0.55).cause, StepFailure::EventNotFinite { event: EventSource::Given(1) });
}

#[test]
fn zero_exactly_at_the_end_happens_in_the_run_that_ends_there() {
    let method = RungeKutta4 { step: 0.25 };
    let run = |from: f64, y: f64, end: f64| {
        integrate(&MARKS, from, [y], end, &method, |_, _| {}).expect("finite")[0]
    };
    assert_eq!(run(0.0, 0.0, 2.0), 2.5, "it jumps");
    assert_eq!(run(2.0, 2.0, 3.0), 3.0, "zero at the start does not fire");
}
