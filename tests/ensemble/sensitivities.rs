//! Derivatives of every motion, beside those of single runs.

use super::{DoublePendulum, start};
use lagrange::ensemble::{EnsembleError, Moments, Random};
use lagrange::event::{Action, Direction};
use lagrange::integrate::{RungeKutta4, StepFailure};
use lagrange::{Ensembles, Simulate};

lagrange::system! {
    /// A mass on a spring.
    #[derive(Clone)]
    struct Oscillator;
    param k = 4.0;
    input pull;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    force x = pull;
    emit { jacobian, lanes }
}

#[test]
fn each_motion_has_the_derivatives_of_its_own_run() {
    let pendulum = DoublePendulum::default();
    let heavier = |i: usize, pendulum: &mut DoublePendulum| pendulum.m2 = 1.0 + i as f64;
    let ensemble = || pendulum.ensemble(5).start(start).parameters(heavier).until(2.0).seed(3);
    for threads in [1, 2] {
        let ends = ensemble().sensitivities(["m2", "theta1"]).threads(threads).run().unwrap();
        for i in 0..5 {
            let mut pendulum = pendulum.clone();
            heavier(i, &mut pendulum);
            let start = start(i, &mut Random::start(3, i));
            let single = pendulum.simulate(start).until(2.0).sensitivities(["m2", "theta1"]).run().unwrap();
            for name in ["theta2", "d(theta2)/d(m2)", "d(theta1_dot)/d(start.theta1)"] {
                let here = ends.column(name).unwrap()[i];
                let there = *single.column(name).unwrap().last().unwrap();
                assert_eq!(here.to_bits(), there.to_bits(), "{name} of motion {i} on {threads} threads");
            }
        }
    }
}

#[test]
fn derivatives_agree_with_their_closed_form_by_every_way_to_keep_them() {
    // x = a cos(√k t): the derivatives are −a t sin(√k t)/(2 √k) and cos(√k t).
    let oscillator = Oscillator::default();
    let ensemble = || {
        let starts: Vec<_> = (0..100).map(|i| [0.1 * f64::from(i), 0.0]).collect();
        oscillator.ensemble(starts).until(3.0)
    };
    let slopes = [-0.75 * 6.0_f64.sin(), 6.0_f64.cos()];
    let ends = ensemble().sensitivities(["k", "x"]).run().unwrap();
    let fixed = ensemble().method(RungeKutta4 { step: 1e-3 }).sensitivities(["k", "x"]).run().unwrap();
    for (i, by_k) in ends.column("d(x)/d(k)").unwrap().iter().enumerate() {
        let expected = 0.1 * i as f64 * slopes[0];
        assert!((by_k - expected).abs() < 1e-8, "{by_k} is not {expected}");
        assert!((fixed.column("d(x)/d(k)").unwrap()[i] - expected).abs() < 1e-8);
        assert!((ends.column("d(x)/d(start.x)").unwrap()[i] - slopes[1]).abs() < 1e-8);
    }
    let samples = ensemble().sensitivities_alongside(["k"]).every(1.0).run().unwrap();
    let motion = samples.motion(50).unwrap().unwrap();
    assert_eq!(motion.column("d(x)/d(k)").unwrap().len(), 4);
    assert!((motion.sensitivities(3).unwrap()[0][0] - 5.0 * slopes[0]).abs() < 1e-6);
    let mean = ensemble().sensitivities(["k"]).reduce(Moments::new(), |moments, motion| {
        moments.add(motion.trajectory().column("d(x)/d(k)").unwrap()[1]);
    });
    assert!((mean.unwrap().mean() - 4.95 * slopes[0]).abs() < 1e-8);
}

#[test]
fn lanes_give_way_to_derivatives_and_to_laws() {
    let oscillator = Oscillator::default();
    let ensemble = || oscillator.ensemble(200).start(|i, _| [i as f64, 0.0]).until(1.0);
    assert!(ensemble().is_in_lanes());
    assert!(!ensemble().sensitivities(["k"]).is_in_lanes());
    let driven = ensemble().drive(|_, _, y| OscillatorInputs { pull: -y.x_dot }).sensitivities(["k"]);
    assert!(!driven.is_in_lanes());
    let by_law = driven.run().unwrap();
    let single = oscillator.simulate([7.0, 0.0]).until(1.0);
    let single = single.drive(|_, _, y| OscillatorInputs { pull: -y.x_dot }).sensitivities(["k"]);
    let single = single.run().unwrap();
    assert_eq!(by_law.column("d(x)/d(k)").unwrap()[7], *single.column("d(x)/d(k)").unwrap().last().unwrap());
}

#[test]
fn names_that_are_unknown_or_repeated_are_refused_before_the_first_motion() {
    let oscillator = Oscillator::default();
    let ensemble = || oscillator.ensemble(2).start(|_, _| [1.0, 0.0]).until(1.0);
    let refusals = [
        (ensemble().sensitivities(["mass"]).run(), "mass"),
        (ensemble().sensitivities(["k", "k"]).run(), "d(x)/d(k)"),
        (
            ensemble()
                .sampled(0.1, |_| |_: &_, _, _| OscillatorInputs { pull: 0.0 })
                .sensitivities(["k"])
                .run(),
            "sampled",
        ),
    ];
    for (refusal, name) in refusals {
        let Err(EnsembleError::Setting(text)) = refusal else { panic!("{name} is accepted") };
        assert!(text.contains(name), "{text}");
    }
}

#[test]
fn impacts_change_derivatives_and_a_motion_without_them_fails_alone() {
    lagrange::system! {
        /// A ball over a floor.
        struct Ball;
        param g = 10.0;
        coord h;
        kinetic = 1/2 * dot(h)^2;
        potential = g * h;
        event floor = h, falling => impact(0.5);
    }
    // The function passes zero at the height 4 with zero slope, and only the first ball falls that
    // far.
    let ball = Ball::default();
    let flat = |_: &Ball, _, y: &[f64; 2]| (y[0] - 4.0).powi(3);
    let ensemble = ball.ensemble(vec![[5.0, 0.0], [3.2, 0.0]]).until(1.5);
    let ends = ensemble.event_with("flat", Direction::Falling, flat, |_, _| Action::Replace([4.0, 0.0]));
    let ends = ends.sensitivities(["h"]).run().unwrap();
    let [failure] = ends.failures() else { panic!("{:?}", ends.failures()) };
    assert!(failure.index == 0 && matches!(failure.cause, StepFailure::NotDifferentiable { .. }));
    // From the height s the ball meets the floor at T = √(2 s/g) with the speed g T. Afterwards it
    // is at g T (t − T)/2 − g (t − T)²/2. So dh/ds = (3 t/2 − 2 T) g dT/ds, with dT/ds = 1/(g T).
    let fall = 0.8;
    let expected = (1.5 * 1.5 - 2.0 * fall) / fall;
    let slope = ends.column("d(h)/d(start.h)").unwrap()[1];
    assert!((slope - expected).abs() < 1e-8, "{slope} is not {expected}");
}
