//! The pair on hand-written systems with known solutions.

mod pulses;
mod rounding;

use std::string::ToString;
use std::vec::Vec;

use super::stage::Stage;
use super::{Verner98, interpolant, tableau as table};
use crate::integrate::{Method, Stepper};
use crate::run::integrate;
use crate::scalar::Scalar;
use crate::system::{OdeSystem, StepFailure, Undefined};

/// ẍ = −x with solution (cos t, −sin t) from (1, 0).
struct Oscillator;

impl OdeSystem for Oscillator {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [x, v]: &[f64; 2]) -> [f64; 2] {
        [*v, -x]
    }
}

/// The equation ẏ = f(t, y).
struct Equation<S>(fn(S, S) -> S);

impl<S: Scalar> OdeSystem for Equation<S> {
    type Scalar = S;
    type State = [S; 1];

    fn rhs(&self, t: S, y: &[S; 1]) -> [S; 1] {
        [(self.0)(t, y[0])]
    }
}

/// Creates a method whose steps all have length `h`.
fn fixed(h: f64) -> Verner98<f64> {
    Verner98 { first_step: Some(h), longest_step: Some(h), ..Verner98::tolerance(1e6) }
}

fn solve<M: OdeSystem<Scalar = f64>>(system: &M, y: M::State, end: f64, tolerance: f64) -> M::State {
    integrate(system, 0.0, y, end, &Verner98::tolerance(tolerance), |_, _| {}).expect("finite")
}

/// Returns the largest difference from the cosine at a fraction of a step of length h.
fn dense_error(h: f64, part: f64) -> f64 {
    let mut stepper = fixed(h).start(&Oscillator, 0.0, &[1.0, 0.0], 9.0).expect("starts");
    stepper.step(&Oscillator, 9.0).expect("finite");
    let [x, v] = stepper.interpolate(&Oscillator, part * h);
    (x - (part * h).cos()).hypot(v + (part * h).sin())
}

/// ẏ₀ = 0, ẏₖ = yₖ₋₁ with solution tᵏ/k!: a step of length one from (1, 0, …) yields the
/// coefficients of the stability function.
struct Powers;

impl OdeSystem for Powers {
    type Scalar = f64;
    type State = [f64; 12];

    fn rhs(&self, _t: f64, y: &[f64; 12]) -> [f64; 12] {
        core::array::from_fn(|k| if k == 0 { 0.0 } else { y[k - 1] })
    }
}

#[test]
fn the_stability_function_is_the_exponential_to_the_ninth_power() {
    let mut start = [0.0; 12];
    start[0] = 1.0;
    let mut stepper = fixed(1.0).start(&Powers, 0.0, &start, 1.0).expect("starts");
    stepper.step(&Powers, 1.0).expect("finite");
    let mut factorial = 1.0;
    for (power, coefficient) in stepper.state().iter().enumerate() {
        factorial *= if power == 0 { 1.0 } else { power as f64 };
        let off = (coefficient * factorial - 1.0).abs();
        assert_eq!(off < 1e-9, power <= 9, "{off} at power {power}");
    }
}

/// The coefficient of the ninth power is so small that higher powers dominate until rounding does.
#[test]
fn the_error_falls_with_the_ninth_power_of_the_step() {
    // ẏ = y cos t, with the solution exp(sin t).
    let system = Equation(|t: f64, y: f64| y * t.cos());
    let error = |steps: u32| {
        let [y] =
            integrate(&system, 0.0, [1.0], 5.0, &fixed(5.0 / f64::from(steps)), |_, _| {}).expect("finite");
        (y - 5.0_f64.sin().exp()).abs()
    };
    for steps in [8, 12] {
        let order = (error(steps) / error(2 * steps)).log2();
        assert!(order > 8.9 && order < 10.5, "{order} at {steps} steps");
    }
}

#[test]
fn the_interpolant_has_order_nine_in_every_part_of_a_step() {
    for part in [0.1, 0.3, 0.5, 0.7, 0.95] {
        let order = (dense_error(0.8, part) / dense_error(0.4, part)).log2();
        // The error of a single step decreases with one additional power.
        assert!(order > 9.5, "{order} at {part}");
    }
}

#[test]
fn the_interpolant_is_good_to_rounding_in_short_steps() {
    for part in 1..20 {
        let error = dense_error(0.05, f64::from(part) / 20.0);
        assert!(error < 3e-16, "{error} at {part}/20");
    }
}

#[test]
fn the_interpolant_meets_both_ends() {
    let mut stepper = fixed(0.5).start(&Oscillator, 0.0, &[1.0, 0.0], 9.0).expect("starts");
    stepper.step(&Oscillator, 9.0).expect("finite");
    let end = *stepper.state();
    assert_eq!(stepper.interpolate(&Oscillator, 0.0), [1.0, 0.0]);
    assert_eq!(stepper.interpolate(&Oscillator, 0.5), end);
    let nearly = stepper.interpolate(&Oscillator, 0.5 - 1e-14);
    assert!((nearly[0] - end[0]).abs() < 1e-13 && (nearly[1] - end[1]).abs() < 1e-13);
}

/// Rates that are polynomials in time yield the exact integral: the conditions of quadrature.
#[test]
fn weights_integrate_powers_of_time() {
    for power in 0..9 {
        let system = Equation::<f64>(match power {
            0 => |_, _| 1.0,
            1 => |t, _| 2.0 * t,
            2 => |t, _| 3.0 * t.powi(2),
            3 => |t, _| 4.0 * t.powi(3),
            4 => |t, _| 5.0 * t.powi(4),
            5 => |t, _| 6.0 * t.powi(5),
            6 => |t, _| 7.0 * t.powi(6),
            7 => |t, _| 8.0 * t.powi(7),
            _ => |t, _| 9.0 * t.powi(8),
        });
        let mut stepper = fixed(1.0).start(&system, 0.0, &[0.0], 1.0).expect("starts");
        stepper.step(&system, 1.0).expect("finite");
        assert!((stepper.state()[0] - 1.0).abs() < 1e-15);
        let halfway = stepper.interpolate(&system, 0.5)[0];
        assert!((halfway - 0.5_f64.powi(power + 1)).abs() < 1e-14, "{halfway} for power {power}");
    }
}

#[test]
fn weights_of_a_stage_add_up_to_its_node() {
    fn off<const N: usize>(stage: &Stage<N>) -> f64 {
        (stage.weights.iter().map(|(_, weight)| weight).sum::<f64>() - stage.node).abs()
    }
    let stages = [
        off(&table::STAGE_1),
        off(&table::STAGE_2),
        off(&table::STAGE_3),
        off(&table::STAGE_4),
        off(&table::STAGE_5),
        off(&table::STAGE_6),
        off(&table::STAGE_7),
        off(&table::STAGE_8),
        off(&table::STAGE_9),
        off(&table::STAGE_10),
        off(&table::STAGE_11),
        off(&table::STAGE_12),
        off(&table::STAGE_13),
        off(&table::STAGE_14),
        off(&table::STAGE_15),
        off(&interpolant::STAGE_17),
        off(&interpolant::STAGE_18),
        off(&interpolant::STAGE_19),
        off(&interpolant::STAGE_20),
        off(&interpolant::STAGE_21),
        off(&interpolant::STAGE_22),
        off(&interpolant::STAGE_23),
        off(&interpolant::STAGE_24),
        off(&interpolant::STAGE_25),
        off(&table::ADVANCE),
    ];
    assert!(stages.iter().all(|off| *off < 2e-14), "{stages:?}");
    assert!(table::ERROR.weights.iter().map(|(_, weight)| weight).sum::<f64>().abs() < 1e-14);
}

#[test]
fn the_error_follows_the_tolerance() {
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
        let [x, v] = solve(&Oscillator, [1.0, 0.0], 20.0, tolerance);
        let error = (x - 20.0_f64.cos()).hypot(v + 20.0_f64.sin());
        assert!(error < 100.0 * tolerance && error > 1e-3 * tolerance, "{error} at {tolerance}");
    }
}

#[test]
fn ten_thousand_radians_cost_little_more_than_rounding() {
    let end = 1e4;
    let [x, v] = solve(&Oscillator, [1.0, 0.0], end, 1e-15);
    let error = (x - end.cos()).hypot(v + end.sin());
    assert!(error < 2e-12, "{error}");
}

#[test]
fn backward_time_returns_to_the_start() {
    let method = Verner98::tolerance(1e-13);
    let there = integrate(&Oscillator, 1.0, [0.3, -1.2], 7.0, &method, |_, _| {}).expect("finite");
    let back = integrate(&Oscillator, 7.0, there, 1.0, &method, |_, _| {}).expect("finite");
    assert!((back[0] - 0.3).abs() < 1e-12 && (back[1] + 1.2).abs() < 1e-12, "{back:?}");
}

#[test]
fn rounded_times_do_not_matter() {
    let (t0, method) = (1e9, Verner98::tolerance(1e-13));
    let there = integrate(&Oscillator, t0, [1.0, 0.0], t0 + 10.0, &method, |_, _| {}).expect("finite");
    assert!((there[0] - 10.0_f64.cos()).abs() < 1e-12 && (there[1] + 10.0_f64.sin()).abs() < 1e-12);
}

#[test]
fn no_time_is_no_step() {
    let mut seen = Vec::new();
    let end = integrate(&Oscillator, 2.0, [1.0, 0.0], 2.0, &Verner98::tolerance(1e-6), |t, _| seen.push(t));
    assert_eq!((end, seen), (Ok([1.0, 0.0]), [2.0].to_vec()));
}

#[test]
fn single_precision_reaches_its_own_rounding() {
    let growth = Equation(|_: f32, y: f32| y);
    let [e] = integrate(&growth, 0.0, [1.0], 1.0, &Verner98::tolerance(1e-6), |_, _| {}).expect("finite");
    assert!((e - core::f32::consts::E).abs() < 1e-6, "{e}");
}

#[test]
fn a_pole_is_an_underflow_of_the_step() {
    let blow_up = Equation(|_: f64, y: f64| y * y);
    let error =
        integrate(&blow_up, 0.0, [1.0], 2.0, &Verner98::tolerance(1e-9), |_, _| {}).expect_err("a pole");
    assert!(matches!(error.cause, StepFailure::StepUnderflow { .. } | StepFailure::NotFinite), "{error:?}");
    assert!((error.time - 1.0).abs() < 1e-6 && error.state[0].is_finite());
}

#[test]
fn nan_stops_at_the_last_good_state() {
    let root = Equation(|t: f64, _: f64| (1.0 - t).sqrt());
    let mut last = (0.0, [0.0]);
    let run = integrate(&root, 0.0, [0.0], 2.0, &Verner98::tolerance(1e-6), |t, y| last = (t, *y));
    let error = run.expect_err("NaN");
    assert!(
        matches!(error.cause, StepFailure::Undefined(Undefined::Rate { time, .. }) if time > 1.0),
        "{error}"
    );
    assert_eq!((error.time, error.state), last);
    assert!(error.time <= 1.0 + f64::EPSILON && error.time > 0.99, "{}", error.time);
}

#[test]
fn settings_that_make_no_sense_are_refused() {
    let good = Verner98::tolerance(1e-6);
    let settings = [
        Verner98::tolerance(0.0),
        Verner98::tolerance(-1.0),
        Verner98::tolerance(f64::NAN),
        Verner98 { first_step: Some(0.0), ..good },
        Verner98 { longest_step: Some(f64::NAN), ..good },
    ];
    for method in settings {
        let refused = integrate(&Oscillator, 0.0, [1.0, 0.0], 1.0, &method, |_, _| {});
        assert!(matches!(refused.expect_err("no sense").cause, StepFailure::Setting(_)), "{method:?}");
    }
    for end in [f64::NAN, f64::INFINITY] {
        let refused = integrate(&Oscillator, 0.0, [1.0, 0.0], end, &good, |_, _| {});
        let refused = refused.expect_err("no end");
        assert_eq!(refused.to_string(), std::format!("the time of the end is {end:?} (at time 0.0)"));
    }
}

#[test]
fn the_number_of_steps_is_limited() {
    let method = Verner98 { max_steps: 7, ..Verner98::tolerance(1e-12) };
    let mut steps = 0;
    let error =
        integrate(&Oscillator, 0.0, [1.0, 0.0], 100.0, &method, |_, _| steps += 1).expect_err("too many");
    assert_eq!(error.cause, StepFailure::TooManySteps { limit: 7 });
    assert!(steps <= 8 && error.time > 0.0);
}

#[test]
fn stiff_systems_are_refused_with_the_stable_step() {
    // Relaxation with a rate of 1e6 to a slow motion.
    let relaxation = Equation(|t: f64, y: f64| -1e6 * (y - t.cos()));
    let method = Verner98::tolerance(1e-6);
    let error = integrate(&relaxation, 0.0, [1.0], 10.0, &method, |_, _| {}).expect_err("stiff");
    let StepFailure::Stiff { limit, .. } = error.cause else { panic!("{error:?}") };
    assert!(limit > 1e-6 && limit < 1e-5, "{limit}");
    assert!(error.time < 0.1);
    let patient = Verner98 { refuses_stiff: false, ..method };
    assert!(integrate(&relaxation, 0.0, [1.0], 0.1, &patient, |_, _| {}).is_ok());
}

/// θ̈ = −9.81 sin θ
struct Pendulum;

impl OdeSystem for Pendulum {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [theta, omega]: &[f64; 2]) -> [f64; 2] {
        [*omega, -9.81 * theta.sin()]
    }
}

#[test]
fn oscillations_are_not_taken_for_stiffness() {
    for tolerance in [1e-2, 1e-3, 1e-6] {
        for amplitude in [1.0, 0.1, 0.01] {
            let end =
                integrate(&Pendulum, 0.0, [amplitude, 0.0], 1e4, &Verner98::tolerance(tolerance), |_, _| {});
            assert!(end.is_ok(), "{tolerance} {amplitude}: {end:?}");
        }
    }
}

#[test]
fn an_overflow_ends_soon() {
    let straight = Equation(|_: f64, _: f64| 1e300);
    let mut steps = 0;
    let end = integrate(&straight, 0.0, [1e308], 1e9, &Verner98::tolerance(1e-9), |_, _| steps += 1);
    assert!(end.expect_err("overflow").state[0].is_finite() && steps < 1000, "{steps}");
}

#[test]
fn single_precision_continues_at_late_times() {
    let growth = Equation(|_: f32, y: f32| 0.0 * y + 0.5);
    let grown = |start: f32, longest_step| {
        let method = Verner98 { longest_step, ..Verner98::tolerance(1e-5_f32) };
        let (mut last, mut advances) = (f32::NEG_INFINITY, true);
        let end = integrate(&growth, start, [0.0], start + 5.0, &method, |t, _| {
            advances &= t > last;
            last = t;
        });
        assert!(advances, "{start}");
        end.map_err(|error| error.cause)
    };
    for (start, longest_step) in [(1e6, None), (1e6, Some(0.5)), (3e4, Some(0.01)), (-3e4, Some(0.01))] {
        let [end] = grown(start, longest_step).expect("finite");
        assert!((end - 2.5).abs() < 1e-5, "{start}: {end}");
    }
    assert_eq!(grown(1e6, Some(0.01)), Err(StepFailure::StepLost { step: 0.01, time: 1e6 }));
}

#[test]
fn the_energy_of_a_long_run_drifts_by_rounding_alone() {
    let mut largest = 0.0_f64;
    integrate(&Oscillator, 0.0, [1.0, 0.0], 2e3, &Verner98::tolerance(1e-15), |_, [x, v]| {
        largest = largest.max((x * x + v * v - 1.0).abs());
    })
    .expect("finite");
    assert!(largest < 1e-13, "{largest}");
}

#[test]
fn nothing_that_moves_and_zero_absolute_tolerance_agree() {
    let rest = Equation(|_: f64, _: f64| 0.0);
    let method = Verner98 { absolute: 0.0, ..Verner98::tolerance(1e-9) };
    assert_eq!(integrate(&rest, 0.0, [0.0], 1e3, &method, |_, _| {}), Ok([0.0]));
}
