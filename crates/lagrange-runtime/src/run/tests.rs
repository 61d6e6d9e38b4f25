//! Methods on systems with constraints: projection must enforce them without losing accuracy.

use std::vec::Vec;

use crate::constraint::Unprojected;
use crate::constraint::doubles::{Bead, Parallelogram, Pendulum, Skate, Spherical, System};
use crate::integrate::{
    GaussLegendre4, GaussLegendre6, ImplicitMidpoint, Method, RungeKutta4, Stepper, Verner98,
};
use crate::run::{integrate, integrate_with_events};
use crate::system::{
    Action, DeclaredEvent, Direction, OdeSystem, Reacted, Response, StepFailure, Violated, Violation,
};

const PENDULUM: System<Pendulum, 2, 1> = System(Pendulum);
const SKATE: System<Skate, 3, 1> = System(Skate);
const BEAD: System<Bead, 2, 1> = System(Bead { rate: 1.0 });
const LOOP: System<Parallelogram, 6, 6> = System(Parallelogram);
const SPHERICAL: System<Spherical, 3, 1> = System(Spherical);

/// Calls a generic function with each method, at a suitable step or tolerance.
macro_rules! each_method {
    ($step:expr, $call:expr) => {
        let (step, call) = ($step, $call);
        call.with(&RungeKutta4 { step });
        call.with(&ImplicitMidpoint { step });
        call.with(&GaussLegendre4 { step });
        call.with(&GaussLegendre6 { step });
        call.with(&ImplicitMidpoint { step }.plain());
        call.with(&GaussLegendre4 { step }.plain());
        call.with(&GaussLegendre6 { step }.plain());
        call.with(&Verner98::tolerance(1e-9));
    };
}

/// A motion during which residuals stay small.
struct Follow<'a, M: OdeSystem> {
    system: &'a M,
    start: M::State,
    residual: fn(f64, &M::State) -> f64,
    bound: f64,
}

impl<M: OdeSystem<Scalar = f64>> Follow<'_, M> {
    fn with(&self, method: &impl Method<M>) {
        let mut largest = 0.0_f64;
        let mut stepper = method.start(self.system, 0.0, &self.start, 2.0).expect("an admissible start");
        while stepper.time() < 2.0 {
            stepper.step(self.system, 2.0).unwrap_or_else(|cause| panic!("{}: {cause}", method.name()));
            let (from, to) = (stepper.last_time(), stepper.time());
            for part in [0.0, 0.3, 0.8, 1.0] {
                let t = from + part * (to - from);
                let y = stepper.interpolate(self.system, t);
                largest = largest.max((self.residual)(t, &y));
            }
        }
        assert!(largest <= self.bound, "{}: {largest}", method.name());
    }
}

#[test]
fn every_method_stays_on_positions_and_velocities_at_and_within_steps() {
    let start = [0.6, -0.8 + 1e-8, 0.8, 0.6];
    each_method!(
        0.02,
        Follow { system: &PENDULUM, start, residual: |t, y| PENDULUM.residual(t, y), bound: 1e-14 }
    );
}

#[test]
fn every_method_stays_on_constraints_that_move() {
    let start = [1.0, 0.0, 0.0, 1.0];
    each_method!(0.02, Follow { system: &BEAD, start, residual: |t, y| BEAD.residual(t, y), bound: 5e-15 });
}

#[test]
fn every_method_stays_on_constraints_of_velocities() {
    let start = [0.0, 0.0, 0.3, 2.0 * 0.3_f64.cos(), 2.0 * 0.3_f64.sin(), 1.5];
    each_method!(0.05, Follow { system: &SKATE, start, residual: |t, y| SKATE.residual(t, y), bound: 2e-15 });
}

#[test]
fn every_method_stays_on_constraints_that_depend_on_each_other() {
    let start = Parallelogram::state(-1.2, 0.5);
    each_method!(0.02, Follow { system: &LOOP, start, residual: |t, y| LOOP.residual(t, y), bound: 1e-13 });
}

/// Returns the final errors of a method with different numbers of steps.
fn errors<M: OdeSystem<Scalar = f64>, K: Method<M>>(
    system: &M,
    start: M::State,
    end: &M::State,
    method: impl Fn(f64) -> K,
    steps: [u32; 2],
) -> (f64, f64) {
    let errors = steps.map(|steps| {
        let found =
            integrate(system, 0.0, start, 1.0, &method(1.0 / f64::from(steps)), |_, _| {}).expect("finite");
        let parts = found.as_ref().iter().zip(end.as_ref()).map(|(found, end)| (found - end).abs());
        parts.fold(0.0, f64::max)
    });
    (errors[0], (errors[0] / errors[1]).log2())
}

#[track_caller]
fn assert_order((error, order): (f64, f64), wanted: f64) {
    assert!((order - wanted).abs() < 0.1 + 0.05 * wanted, "{order} instead of {wanted}, errors from {error}");
}

/// Returns the state of a skate that turns at the rate w and moves at the speed s.
fn glide(t: f64, (s, w): (f64, f64)) -> [f64; 6] {
    let (sine, cosine) = (w * t).sin_cos();
    [s / w * sine, s / w * (1.0 - cosine), w * t, s * cosine, s * sine, w]
}

#[test]
fn projection_leaves_the_order_of_each_method() {
    let (start, end) = (glide(0.0, (2.0, 3.0)), glide(1.0, (2.0, 3.0)));
    assert_order(errors(&SKATE, start, &end, |step| RungeKutta4 { step }, [16, 32]), 4.0);
    assert_order(errors(&SKATE, start, &end, |step| ImplicitMidpoint { step }.plain(), [16, 32]), 2.0);
    let (start, end) = ([1.0, 0.0, 0.0, 1.0], {
        let ((sine, cosine), (r, rate)) = (1.0_f64.sin_cos(), (1.0_f64.cosh(), 1.0_f64.sinh()));
        [r * cosine, r * sine, rate * cosine - r * sine, rate * sine + r * cosine]
    });
    assert_order(errors(&BEAD, start, &end, |step| RungeKutta4 { step }, [8, 16]), 4.0);
    assert_order(errors(&BEAD, start, &end, |step| ImplicitMidpoint { step }, [8, 16]), 2.0);
    assert_order(errors(&BEAD, start, &end, |step| GaussLegendre4 { step }, [4, 8]), 4.0);
    assert_order(errors(&BEAD, start, &end, |step| GaussLegendre6 { step }, [2, 4]), 6.0);
    assert_order(errors(&BEAD, start, &end, |step| GaussLegendre4 { step }.plain(), [4, 8]), 4.0);
    assert_order(errors(&BEAD, start, &end, |step| GaussLegendre6 { step }.plain(), [2, 4]), 6.0);
    let tolerances =
        |step: f64| Verner98 { longest_step: Some(step), first_step: Some(step), ..Verner98::tolerance(1.0) };
    assert_order(errors(&BEAD, start, &end, tolerances, [1, 2]), 9.0);
}

/// θ̈ = −g sin θ
struct Angle;

impl OdeSystem for Angle {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [angle, rate]: &[f64; 2]) -> [f64; 2] {
        [*rate, -9.81 * angle.sin()]
    }
}

#[test]
fn a_pendulum_in_the_plane_moves_as_its_angle_does() {
    let tight = Verner98::tolerance(1e-14);
    let [angle, rate] = integrate(&Angle, 0.0, [2.0, 0.0], 10.0, &tight, |_, _| {}).expect("finite");
    let start = [2.0_f64.sin(), -2.0_f64.cos(), 0.0, 0.0];
    let found = integrate(&PENDULUM, 0.0, start, 10.0, &tight, |_, _| {}).expect("finite");
    let wanted = [angle.sin(), -angle.cos(), rate * angle.cos(), rate * angle.sin()];
    for (found, wanted) in found.into_iter().zip(wanted) {
        assert!((found - wanted).abs() < 1e-12, "{found} for {wanted}");
    }
}

#[test]
fn a_loop_with_a_crank_too_many_turns_through_its_flat_positions() {
    let inertia = 3.0 * Parallelogram::CRANK + Parallelogram::COUPLER;
    let gravity = 9.81 * Parallelogram::COUPLER / inertia;
    let swing = Swing(gravity);
    let tight = Verner98::tolerance(1e-12);
    let [angle, rate] = integrate(&swing, 0.0, [0.4, 7.0], 3.0, &tight, |_, _| {}).expect("finite");
    assert!(angle > 8.0, "{angle}: turns all around");
    for (tolerance, most) in [(1e-9, 200), (1e-12, 2000)] {
        let method = Verner98 { max_steps: most, ..Verner98::tolerance(tolerance) };
        let start = Parallelogram::state(0.4, 7.0);
        let found = integrate(&LOOP, 0.0, start, 3.0, &method, |_, _| {}).expect("passes");
        for (found, wanted) in found.into_iter().zip(Parallelogram::state(angle, rate)) {
            assert!((found - wanted).abs() < 1e-7, "{tolerance}: {found} for {wanted}");
        }
    }
}

/// θ̈ = −k cos θ
struct Swing(f64);

impl OdeSystem for Swing {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [angle, rate]: &[f64; 2]) -> [f64; 2] {
        [*rate, -self.0 * angle.cos()]
    }
}

#[test]
fn projection_keeps_what_symmetries_conserve() {
    let start = [0.6, 0.0, -0.8, 0.0, 1.7, 0.0];
    let momentum = Spherical::angular_momentum(&start);
    let (mut drift, mut energy) = (0.0_f64, 0.0_f64);
    integrate(&SPHERICAL, 0.0, start, 20.0, &Verner98::tolerance(1e-14), |_, y| {
        drift = drift.max((Spherical::angular_momentum(y) - momentum).abs());
        energy = energy.max((SPHERICAL.energy_of(y) - SPHERICAL.energy_of(&start)).abs());
    })
    .expect("finite");
    assert!(drift < 3e-14, "{drift}");
    assert!(energy < 2e-13, "{energy}");
}

#[test]
fn projected_gauss_steps_disturb_symmetries_no_more_than_their_order_allows() {
    let start = [0.6, 0.0, -0.8, 0.0, 1.7, 0.0];
    let drifts = [0.04, 0.02].map(|step| {
        let mut drift = 0.0_f64;
        integrate(&SPHERICAL, 0.0, start, 10.0, &GaussLegendre4 { step }, |_, y| {
            drift = drift.max((Spherical::angular_momentum(y) - Spherical::angular_momentum(&start)).abs());
        })
        .expect("finite");
        drift
    });
    assert!(drifts[0] < 1e-6 && drifts[1] < drifts[0] / 16.0, "{drifts:?}");
}

#[test]
fn without_projection_the_constraints_are_left_behind() {
    let start = [0.6, -0.8, 0.8, 0.6];
    let method = RungeKutta4 { step: 0.05 };
    let end = integrate(&Unprojected(PENDULUM), 0.0, start, 10.0, &method, |_, _| {}).expect("finite");
    let left = PENDULUM.residual(10.0, &end);
    assert!(left > 1e-4, "{left}");
    let end = integrate(&PENDULUM, 0.0, start, 10.0, &method, |_, _| {}).expect("finite");
    assert!(PENDULUM.residual(10.0, &end) < 1e-14);
}

#[test]
fn starts_off_the_constraints_are_refused_by_name() {
    struct Refuse;
    impl Refuse {
        fn with(&self, method: &impl Method<System<Pendulum, 2, 1>>) {
            let start = [0.6, -0.9, 0.8, 0.6];
            let failed =
                integrate(&PENDULUM, 0.0, start, 1.0, method, |_, _| panic!("starts")).expect_err("refused");
            assert!(
                matches!(failed.cause, StepFailure::Violated(Violation { constraint: "rod", .. })),
                "{failed}"
            );
            assert_eq!((failed.time, failed.state), (0.0, start));
            let mut stepper = method.start(&PENDULUM, 0.0, &[0.6, -0.8, 0.8, 0.6], 1.0).expect("starts");
            stepper.step(&PENDULUM, 1.0).expect("goes on");
            let (time, state) = (stepper.time(), *stepper.state());
            let jump = stepper.restart(&PENDULUM, time, &[0.6, -0.8, 1.8, 0.6]);
            let Err(StepFailure::Violated(violation)) = jump else { panic!("{jump:?}") };
            assert!(
                violation.of == Violated::Velocities && (violation.residual - 1.2).abs() < 1e-14,
                "{violation}"
            );
            assert_eq!((stepper.time(), *stepper.state()), (time, state));
        }
    }
    each_method!(0.02, Refuse);
}

/// ẏ = 1 on a constraint that cannot be satisfied beyond y = 1.
struct Cliff;

impl OdeSystem for Cliff {
    type Scalar = f64;
    type State = [f64; 1];

    const IS_CONSTRAINED: bool = true;

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [1.0]
    }

    fn correct(&self, _t: f64, [y]: &mut [f64; 1]) -> Result<(), StepFailure<f64>> {
        let violation = Violation { constraint: "cliff", residual: *y - 1.0, of: Violated::Positions };
        if *y <= 1.0 { Ok(()) } else { Err(StepFailure::Violated(violation)) }
    }
}

#[test]
fn steps_that_cannot_be_corrected_are_errors_with_the_last_good_state() {
    let fixed = integrate(&Cliff, 0.0, [0.0], 2.0, &RungeKutta4 { step: 0.3 }, |_, _| {}).expect_err("falls");
    assert!(matches!(fixed.cause, StepFailure::Violated(Violation { constraint: "cliff", .. })), "{fixed}");
    assert!((fixed.time - 0.9).abs() < 1e-15 && (fixed.state[0] - 0.9).abs() < 1e-15, "{fixed}");
    // Shorter steps lead up to the edge.
    let adaptive =
        integrate(&Cliff, 0.0, [0.0], 2.0, &Verner98::tolerance(1e-6), |_, _| {}).expect_err("falls");
    assert!(
        matches!(adaptive.cause, StepFailure::Violated(Violation { constraint: "cliff", .. })),
        "{adaptive}"
    );
    assert!((adaptive.time - 1.0).abs() < 1e-12 && (adaptive.state[0] - 1.0).abs() < 1e-12, "{adaptive}");
}

#[test]
fn events_happen_on_the_constraints() {
    let mut states = Vec::new();
    let watch = ([Direction::Crossing], |_: f64, y: &[f64; 4]| [y[0]]);
    let method = RungeKutta4 { step: 0.05 };
    integrate_with_events(&PENDULUM, (0.0, [0.6, -0.8, 0.8, 0.6]), 3.0, &method, watch, |event| {
        states.push(event.state);
        Action::Continue
    })
    .expect("swings");
    assert!(states.len() >= 2);
    for state in states {
        assert!(PENDULUM.residual(0.0, &state) < 1e-14, "{state:?}");
    }
}

/// Time beside a distance from a constraint that each correction halves; it is 1 after the event.
struct Halving;

impl OdeSystem for Halving {
    type Scalar = f64;
    type State = [f64; 2];

    const IS_CONSTRAINED: bool = true;
    const EVENTS: &'static [DeclaredEvent] = &[DeclaredEvent::new("push", Direction::Rising)];

    fn rhs(&self, _t: f64, _y: &[f64; 2]) -> [f64; 2] {
        [1.0, 0.0]
    }

    fn correct(&self, _t: f64, [_, distance]: &mut [f64; 2]) -> Result<(), StepFailure<f64>> {
        *distance /= 2.0;
        Ok(())
    }

    fn event_values(&self, _t: f64, [time, _]: &[f64; 2], values: &mut [f64]) {
        values[0] = *time - 0.5;
    }

    fn react(&self, _event: usize, _t: f64, _elapsed: f64, [time, _]: &[f64; 2]) -> Reacted<Self> {
        Ok(Response::new(Action::Replace([*time, 1.0])))
    }
}

#[test]
fn motions_continue_from_the_state_observed_after_an_event() {
    let mut seen = Vec::new();
    let method = RungeKutta4 { step: 0.25 };
    integrate(&Halving, 0.0, [0.0, 0.0], 1.0, &method, |_, [_, distance]| seen.push(*distance))
        .expect("ends");
    let replaced = seen.iter().position(|distance| *distance > 0.0).expect("an event");
    assert!(seen.len() > replaced + 2, "{seen:?}");
    assert!(seen[replaced..].windows(2).all(|pair| pair[1] == pair[0] / 2.0), "{seen:?}");
}

mod ranges;
mod simultaneous;

/// A system whose events are known at run time, but whose type reserves no memory for them.
struct Unreserved;

impl OdeSystem for Unreserved {
    type Scalar = f64;
    type State = [f64; 1];

    fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
        [1.0]
    }

    fn events(&self) -> &'static [DeclaredEvent] {
        Halving::EVENTS
    }

    fn event_values(&self, t: f64, _y: &[f64; 1], values: &mut [f64]) {
        values[0] = t - 0.5;
    }
}

#[test]
fn events_without_memory_are_refused() {
    let method = RungeKutta4 { step: 0.25 };
    let error = integrate(&Unreserved, 0.0, [0.0], 1.0, &method, |_, _| {}).expect_err("a refusal");
    assert!(std::format!("{error}").contains("more events than its `MAX_EVENTS`"), "{error}");
}
