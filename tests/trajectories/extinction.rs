//! States that reach zero in a finite time, where their rates have infinite slopes.

use lagrange::Simulate;
use lagrange::integrate::{Method, StepFailure, Taylor, Verner98};
use lagrange::simulate::Trajectory;

lagrange::system! {
    /// The level of a tank with an outlet, by Torricelli's law for p = 1/2.
    #[derive(Clone, Debug)]
    struct Tank<S>;

    param p = 0.5;
    state x = 1;
    dot(x) = -max(x, 0)^p;
    emit { taylor }
}

lagrange::system! {
    /// A tank that drains into another one, and is filled again.
    #[derive(Clone, Debug)]
    struct Cascade;

    param refill = 100;
    state x = 1, y = 0.5;
    dot(x) = (if t < refill { 0 } else { 0.25 }) - sqrt(max(x, 0));
    dot(y) = sqrt(max(x, 0)) - sqrt(max(y, 0));
    emit { taylor }
}

lagrange::system! {
    /// A flow between two tanks, whose direction is the sign of the difference.
    #[derive(Clone, Debug)]
    struct Levelled;

    param p = 0.5;
    state x = 1;
    dot(x) = -abs(x)^p * sign(x);
    emit { taylor }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Dry;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = -sign(dot(x));
    emit { taylor }
}

const TOLERANCES: [f64; 3] = [1e-6, 1e-9, 1e-12];
/// Far more steps than a method needs unless it crawls.
const STEPS: u64 = 3000;

/// Returns the solution of ẋ = −xᵖ from 1.
fn level(p: f64, t: f64) -> f64 {
    (1.0 - (1.0 - p) * t).max(0.0).powf(1.0 / (1.0 - p))
}

fn drained<K: Method<Tank<f64>>>(p: f64, method: K) -> Trajectory<Tank<f64>> {
    let tank = Tank { p, ..Tank::default() };
    tank.simulate(tank.start()).until(20.0).every(0.25).max_steps(STEPS).method(method).run().unwrap()
}

#[test]
fn a_tank_drains_and_remains_empty() {
    for p in [0.1, 0.25, 1.0 / 3.0, 0.5, 0.6, 0.75, 0.9] {
        for tolerance in TOLERANCES {
            let runs = [drained(p, Taylor::tolerance(tolerance)), drained(p, Verner98::tolerance(tolerance))];
            for run in runs {
                for (t, [x]) in run.iter() {
                    let error = (x - level(p, t)).abs();
                    assert!(error < 10.0 * tolerance, "{} of {p} at {t}: {error:e}", run.method());
                }
            }
        }
    }
}

#[test]
fn a_tank_drains_at_time_zero_and_in_single_precision() {
    let tank = Tank::<f64>::default();
    let run = tank.simulate([1.0]).from(-2.0).until(3.0).max_steps(STEPS);
    let end = run.method(Taylor::tolerance(1e-9)).run().unwrap().last();
    assert!(end[0].abs() < 1e-9, "{end:?}");

    let tank = Tank::<f32> { p: 0.4, ..Tank::default() };
    let run = tank.simulate([1.0]).until(5.0).max_steps(STEPS);
    let end = run.method(Taylor::tolerance(1e-5)).run().unwrap().last();
    assert!(end[0].abs() < 1e-5, "{end:?}");
}

/// Both methods are compared with the pair at a much smaller tolerance.
#[test]
fn tanks_in_cascade_drain_and_are_filled_again() {
    for refill in [100.0, 6.0] {
        let tanks = Cascade { refill, ..Cascade::default() };
        let run = |method| {
            let run = tanks.simulate(tanks.start()).until(10.0).every(0.5).max_steps(STEPS);
            run.method(method).run().unwrap()
        };
        let wanted = run(Verner98::tolerance(1e-13));
        for tolerance in TOLERANCES {
            let series = tanks.simulate(tanks.start()).until(10.0).every(0.5).max_steps(STEPS);
            let series = series.method(Taylor::tolerance(tolerance)).run().unwrap();
            for found in [series, run(Verner98::tolerance(tolerance))] {
                for ((t, found_y), wanted_y) in found.iter().zip(wanted.states()) {
                    for (x, wanted) in found_y.iter().zip(wanted_y) {
                        let error = (x - wanted).abs();
                        let method = found.method();
                        assert!(error < 30.0 * tolerance, "{method} {tolerance:e} at {t}: {error:e}");
                    }
                }
            }
        }
    }
}

/// The series rests where the flow vanishes. The pair approaches the surface from both sides: it
/// stays near it in short steps, or refuses.
#[test]
fn a_flow_that_turns_with_the_level_rests_or_names_the_surface() {
    for p in [1.0 / 3.0, 0.5, 0.75] {
        for tolerance in TOLERANCES {
            let tank = Levelled { p, ..Levelled::default() };
            let run = || tank.simulate(tank.start()).until(6.0);
            let series = run().max_steps(STEPS).method(Taylor::tolerance(tolerance));
            let end = series.run().unwrap().last();
            assert!(end[0].abs() < tolerance, "{p}: {end:?}");
            match run().max_steps(30 * STEPS).tolerance(tolerance).run() {
                Ok(run) => assert!(run.last()[0].abs() < tolerance, "{p}: {:?}", run.last()),
                Err(error) => {
                    assert!(matches!(error.cause, StepFailure::Slides { .. }), "{error}");
                    assert!(error.to_string().contains("the sign of `x`"), "{error}");
                }
            }
        }
    }
}

#[test]
fn dry_friction_at_rest_is_refused_by_name() {
    let block = Dry::default();
    let run = || block.simulate([0.0, 1.0]).until(3.0).max_steps(STEPS);
    let series = run().method(Taylor::tolerance(1e-9)).run().unwrap_err();
    for error in [series, run().tolerance(1e-9).run().unwrap_err()] {
        assert!(matches!(error.cause, StepFailure::Slides { .. }), "{error}");
        assert!(error.to_string().contains("the sign of `dot(x)`"), "{error}");
        let end = error.trajectory.end_time();
        assert!((end - 1.0).abs() < 1e-6, "{end}");
    }
}
