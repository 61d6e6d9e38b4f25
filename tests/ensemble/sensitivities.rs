//! Derivatives of every motion, beside those of single runs.

use super::{DoublePendulum, start};
use lagrange::ensemble::{EnsembleError, Moments, Random};
use lagrange::event::{Action, Direction};
use lagrange::integrate::{RungeKutta4, StepFailure, Verner98};
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

lagrange::system! {
    /// Two masses on springs, one of them nonlinear, with a force that depends on time.
    #[derive(Clone)]
    struct Masses<S>;
    param m = 1.0, k = 4.0, c = 0.1;
    coord x in -1e3..=1e3, y;
    input pull;
    kinetic = 1/2 * m * dot(x)^2 + 1/2 * dot(y)^2;
    potential = 1/2 * k * x^2 + 1/2 * (y - x)^2 + 1/4 * y^4;
    dissipation = 1/2 * c * dot(y)^2;
    force x = pull * sin(3 * t);
    emit { jacobian, lanes }
}

/// Compares each column at the ends of motions in lanes with single runs.
macro_rules! check_lanes {
    ($method:expr, $tolerance:expr) => {
        let masses = Masses::<f64> { pull: 0.7, ..Masses::default() };
        let vary = |i: usize, masses: &mut Masses<f64>| masses.m = 0.5 + 0.1 * i as f64;
        let start = |i: usize, _: &mut Random| [0.1 * (i % 7) as f64, 0.3, -0.2, 0.05 * i as f64];
        for motions in [1, 13] {
            let ensemble = || {
                let ensemble = masses.ensemble(motions).start(start).parameters(vary).until(2.5);
                ensemble.method($method).sensitivities(["m", "y_dot", "pull", "x"])
            };
            assert!(ensemble().is_in_lanes());
            let (lanes, alone) = (ensemble().run().unwrap(), ensemble().one_by_one().run().unwrap());
            assert_eq!(lanes.names(), alone.names());
            for name in lanes.names() {
                let pairs = lanes.column(name).unwrap().iter().zip(alone.column(name).unwrap());
                for (i, (here, there)) in pairs.enumerate() {
                    assert!((here - there).abs() < $tolerance, "{name} of motion {i}: {here} {there}");
                }
            }
        }
    };
}

#[test]
fn derivatives_in_lanes_are_those_of_single_runs() {
    check_lanes!(Verner98::tolerance(1e-11), 1e-8);
    check_lanes!(RungeKutta4 { step: 0.01 }, 1e-12);
}

#[test]
fn derivatives_in_lanes_are_kept_in_every_way() {
    let masses = Masses::<f64> { pull: 0.7, ..Masses::default() };
    let starts: Vec<_> = (0..20).map(|i| [0.1 * f64::from(i), 0.3, 0.0, 0.0]).collect();
    let ensemble = || masses.ensemble(starts.clone()).until(2.0).sensitivities(["k", "x"]);
    let single = |i: usize| masses.simulate(starts[i]).until(2.0).sensitivities(["k", "x"]);
    let samples = ensemble().every(0.5).run().unwrap();
    let motion = samples.motion(7).unwrap().unwrap();
    let wanted = single(7).every(0.5).run().unwrap();
    assert_eq!(motion.times(), wanted.times());
    for sample in 0..5 {
        let pairs = motion.sensitivities(sample).unwrap();
        assert_eq!(pairs.len(), 2);
        let pairs = pairs.iter().flatten().zip(wanted.sensitivities(sample).unwrap().into_iter().flatten());
        pairs.for_each(|(here, there)| assert!((here - there).abs() < 1e-8, "{here} {there}"));
    }
    let by_k = |motion: &lagrange::ensemble::Motion<'_, Masses<f64>>| {
        *motion.trajectory().column("d(y)/d(k)").unwrap().last().unwrap()
    };
    let mean = ensemble().reduce(Moments::new(), |moments, motion| moments.add(by_k(motion))).unwrap();
    let wanted = (0..20).map(|i| *single(i).run().unwrap().column("d(y)/d(k)").unwrap().last().unwrap());
    assert!((mean.mean() - wanted.sum::<f64>() / 20.0).abs() < 1e-8);
    // Observed columns come beside derivatives.
    let observed = ensemble().energy().run().unwrap();
    let wanted = single(3).energy().run().unwrap();
    for name in ["energy", "d(x)/d(start.x)"] {
        let wanted = wanted.column(name).unwrap().last().unwrap();
        assert!((observed.column(name).unwrap()[3] - wanted).abs() < 1e-8, "{name}");
    }
}

#[test]
fn derivatives_in_lanes_take_other_numbers_ranges_and_failures() {
    let small = Masses::<f32>::default();
    let starts: Vec<_> = (0..10u8).map(|i| [0.1 * f32::from(i), 0.3, 0.0, 0.0]).collect();
    let ensemble = || small.ensemble(starts.clone()).until(1.0).sensitivities_alongside(["c"]);
    assert!(ensemble().is_in_lanes());
    let (lanes, alone) = (ensemble().run().unwrap(), ensemble().one_by_one().run().unwrap());
    for (here, there) in lanes.column("d(y)/d(c)").unwrap().iter().zip(alone.column("d(y)/d(c)").unwrap()) {
        assert!((here - there).abs() < 1e-4, "{here} {there}");
    }
    // The second motion starts out of its range, and the third is no number.
    let masses = Masses::<f64>::default();
    let starts = vec![[0.1, 0.0, 0.0, 0.0], [2e3, 0.0, 0.0, 0.0], [f64::NAN, 0.0, 0.0, 0.0]];
    let ends = masses.ensemble(starts).until(1.0).sensitivities(["k"]).run().unwrap();
    assert_eq!(ends.failures().iter().map(|failure| failure.index).collect::<Vec<_>>(), [1, 2]);
    let single = masses.simulate([0.1, 0.0, 0.0, 0.0]).until(1.0).sensitivities(["k"]).run().unwrap();
    let wanted = single.column("d(x)/d(k)").unwrap().last().unwrap();
    assert!((ends.column("d(x)/d(k)").unwrap()[0] - wanted).abs() < 1e-9);
}

#[test]
fn lanes_give_way_to_laws_and_to_long_states() {
    let oscillator = Oscillator::default();
    let ensemble = || oscillator.ensemble(200).start(|i, _| [i as f64, 0.0]).until(1.0);
    assert!(ensemble().is_in_lanes() && ensemble().sensitivities(["k"]).is_in_lanes());
    let driven = ensemble().drive(|_, _, y| OscillatorInputs { pull: -y.x_dot }).sensitivities(["k"]);
    assert!(!driven.is_in_lanes());
    let by_law = driven.run().unwrap();
    let single = oscillator.simulate([7.0, 0.0]).until(1.0);
    let single = single.drive(|_, _, y| OscillatorInputs { pull: -y.x_dot }).sensitivities(["k"]);
    let single = single.run().unwrap();
    assert_eq!(by_law.column("d(x)/d(k)").unwrap()[7], *single.column("d(x)/d(k)").unwrap().last().unwrap());
    lagrange::system! {
        /// A row of masses on springs.
        #[derive(Clone)]
        struct Row;
        const N = 9;
        param k[N] = 4.0, g = 1.0;
        coord x[N];
        kinetic = 1/2 * sum(i in 0..N, dot(x[i])^2);
        potential = 1/2 * sum(i in 0..N, k[i] * x[i]^2) + 1/4 * sum(i in 1..N, (x[i] - x[i-1])^4) + g * x[0];
        emit { jacobian, lanes }
    }
    let row = Row::default();
    // As many numbers as fit: 18 × 5, of a system with 18 × 28 derivatives.
    let ensemble = || row.ensemble(3).start(|i, _| [0.1 * i as f64; 18]).until(1.0);
    let widest = || ensemble().sensitivities(["x[0]", "k[0]", "x_dot[8]", "g"]);
    assert!(widest().is_in_lanes());
    let alone = widest().one_by_one().run().unwrap();
    for threads in [1, 2] {
        let lanes = widest().threads(threads).run().unwrap();
        for name in ["d(x[0])/d(k[0])", "d(x[7])/d(start.x_dot[8])", "d(x[1])/d(g)", "x[3]"] {
            let pairs = lanes.column(name).unwrap().iter().zip(alone.column(name).unwrap());
            pairs.for_each(|(here, there)| assert!((here - there).abs() < 1e-8, "{name}: {here} {there}"));
        }
    }
    let wider = ensemble().sensitivities(["x[0]", "k[0]", "x_dot[8]", "g", "x[1]"]);
    assert!(!wider.is_in_lanes() && wider.run().unwrap().failures().is_empty());
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
