//! Base parameters and estimates from forces.

use crate::noise::Noise;
use lagrange::identification::{IdentificationError, Identifies};
use lagrange::system::ControlledSystem;

lagrange::system! {
    /// Two rods in a vertical plane, with a spring and friction.
    #[derive(Clone, Debug)]
    struct Arm;
    param m[2] = 2, c[2] = 0.2, k = 3, l = 1.5;
    gravity = (0, -10);
    body upper { mass: m[0]; inertia: 0.1; centroid: (0.5, 0); }
    revolute a = ground to upper { damping: c[0]; }
    body lower { mass: m[1]; inertia: 0.2; centroid: (0.4, 0.1); }
    revolute b = upper to lower { at: (l, 0); damping: c[1]; }
    potential = 1/2 * k * b^2;
    emit { regressor }
}

type State = ([f64; 2], [f64; 2], [f64; 2]);

fn state(step: usize) -> State {
    let t = 0.17 * step as f64;
    let q = [t.sin() + 0.3 * (3.0 * t).cos(), (2.0 * t).cos()];
    let v = [t.cos() - 0.9 * (3.0 * t).sin(), -2.0 * (2.0 * t).sin()];
    (q, v, [-t.sin() - 2.7 * (3.0 * t).cos(), -4.0 * (2.0 * t).cos()])
}

#[test]
fn the_mass_of_a_body_acts_at_the_joint_that_carries_it() {
    let base = Arm::default().base_parameters().expect("finite");
    let names = base.parameters().iter().map(ToString::to_string).collect::<Vec<_>>();
    let moved = ["upper.mx + 1.5 lower.mass", "upper.my", "upper.zz + 2.25 lower.mass"];
    assert_eq!(names[..3], moved);
    assert_eq!(names[3..], ["lower.mx", "lower.my", "lower.zz", "c[0]", "c[1]", "k"]);
    assert!(base.without_effect().is_empty());
    let known = base.parameters()[2].value(&Arm::default().regressor_parameters());
    assert!((known - (0.1 + 2.0 * 0.25 + 2.0 * 2.25)).abs() < 1e-12);
}

#[test]
fn forces_without_noise_give_the_values_that_made_them() {
    let (arm, made_of) = (Arm::default(), Arm { m: [2.5, 1.5], c: [0.1, 0.4], k: 5.0, ..Arm::default() });
    let mut regression = arm.regression();
    for step in 0..40 {
        let (q, v, a) = state(step);
        regression.add(0.0, &q, &v, &a, &made_of.inverse_dynamics(0.0, &q, &v, &a));
    }
    let estimate = regression.estimate().expect("enough states");
    let wanted = made_of.regressor_parameters();
    for value in estimate.values() {
        let wanted = value.parameter.value(&wanted);
        assert!((value.value - wanted).abs() < 1e-12, "{} {wanted} of {}", value.value, value.parameter);
        assert!(value.standard_error < 1e-12);
    }
    // Y times all parameters equals the forces, also away from the measurements.
    let (q, v, a) = ([2.0, -1.0], [0.3, 0.5], [1.0, 2.0]);
    let rows = arm.regressor(0.0, &q, &v, &a);
    for (row, force) in rows.iter().zip(made_of.inverse_dynamics(0.0, &q, &v, &a)) {
        let product = row.iter().zip(estimate.parameters()).map(|(y, p)| y * p).sum::<f64>();
        assert!((product - force).abs() < 1e-11, "{product} {force}");
    }
}

/// Over many repetitions, deviations in standard errors have a variance of about one.
#[test]
fn standard_errors_are_honest_for_joints_of_different_noise() {
    let (arm, levels) = (Arm::default(), [0.5, 0.01]);
    let (mut squares, mut count, mut noise) = (0.0, 0, Noise(3));
    for _ in 0..60 {
        let mut regression = arm.regression();
        for step in 0..100 {
            let (q, v, a) = state(step);
            let mut forces = arm.inverse_dynamics(0.0, &q, &v, &a);
            for (joint, force) in forces.iter_mut().enumerate() {
                *force += levels[joint] * noise.normal();
            }
            regression.add(0.0, &q, &v, &a, &forces);
        }
        let estimate = regression.estimate().expect("enough states");
        for (level, found) in levels.iter().zip(estimate.noise()) {
            assert!((found / level - 1.0).abs() < 0.35, "{found} for {level}");
        }
        for value in estimate.values() {
            squares += ((value.value - value.known) / value.standard_error).powi(2);
            count += 1;
        }
    }
    let variance = squares / f64::from(count);
    assert!((variance - 1.0).abs() < 0.25, "{variance}");
}

#[test]
fn missing_and_infinite_data_are_reported() {
    let arm = Arm::default();
    let mut regression = arm.regression();
    let too_few = |forces, combinations| IdentificationError::TooFew { forces, combinations };
    assert_eq!(regression.estimate().map(drop), Err(too_few(0, 0)));
    let (q, v, a) = state(1);
    regression.add(0.0, &q, &v, &a, &[1.0, 2.0]);
    assert_eq!(regression.estimate().map(drop), Err(too_few(2, 2)));
    regression.add(0.0, &q, &v, &a, &[1.0, f64::NAN]);
    assert_eq!(regression.estimate().map(drop), Err(IdentificationError::NotFinite { state: 1 }));
    let broken = Arm { l: f64::INFINITY, ..arm };
    assert_eq!(broken.base_parameters().map(drop), Err(IdentificationError::Undefined { reach: 3.0 }));
    let broken = Arm { k: f64::NAN, ..arm };
    let named = IdentificationError::UndefinedParameter { name: "k" };
    assert_eq!(broken.base_parameters().map(drop), Err(named));
}

/// At rest only weights and the spring act.
#[test]
fn a_motion_determines_the_parameters_it_excites() {
    let arm = Arm::default();
    let mut regression = arm.regression();
    for step in 0..20 {
        let (q, ..) = state(step);
        regression.add(0.0, &q, &[0.0; 2], &[0.0; 2], &arm.inverse_dynamics(0.0, &q, &[0.0; 2], &[0.0; 2]));
    }
    let base = regression.base_parameters().expect("finite");
    let names = base.parameters().iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(names, ["upper.mx + 1.5 lower.mass", "upper.my", "lower.mx", "lower.my", "k"]);
    assert_eq!(base.without_effect(), ["upper.zz", "lower.zz", "c[0]", "c[1]"]);
    assert!(base.to_string().ends_with("without effect: upper.zz, lower.zz, c[0], c[1]\n"));
}

mod oscillator {
    lagrange::system! {
        /// A resonator in SI units, whose quantities are all small.
        #[derive(Clone, Debug)]
        pub struct Resonator;
        param m: kg = 1e-12, c: N*s/m = 1e-8, k: N/m = 3948;
        coord x: m;
        kinetic = 1/2 * m * dot(x)^2;
        potential = 1/2 * k * x^2;
        dissipation = 1/2 * c * dot(x)^2;
        emit { regressor }
    }
}
use oscillator::Resonator;

/// Columns of the regressor are 1e-9 m, 6e-2 m/s and 4e6 m/s².
#[test]
fn units_do_not_decide_what_has_an_effect() {
    let resonator = Resonator::default();
    let w = (resonator.k / resonator.m).sqrt();
    let mut regression = resonator.regression();
    for step in 0..50 {
        let phase = 0.37 * f64::from(step);
        let [x, v, a] =
            [phase.cos(), -w * phase.sin(), -w * w * phase.cos() * (1.0 + 0.3 * (2.0 * phase).sin())];
        let [x, v, a] = [x, v, a].map(|entry| [1e-9 * entry]);
        regression.add(0.0, &x, &v, &a, &resonator.inverse_dynamics(0.0, &x, &v, &a));
    }
    let estimate = regression.estimate().expect("enough states");
    for (name, wanted) in [("m", 1e-12), ("c", 1e-8), ("k", 3948.0)] {
        let found = estimate.value(name).unwrap_or_else(|| panic!("{name} has an effect"));
        assert!((found / wanted - 1.0).abs() < 1e-9, "{name} {found:e}");
    }
    let shown = estimate.to_string();
    assert!(shown.contains("(1e-12)  m\n") && shown.contains("(3948.0)  k\n"), "{shown}");
}

mod driven {
    lagrange::system! {
        /// A mass pushed by a force of time and an input.
        #[derive(Clone, Debug)]
        pub struct Driven;
        param m = 2, c = 0.1, amp = 3, k = 5;
        input u = 0;
        coord x;
        kinetic = 1/2 * m * dot(x)^2;
        force x = -c * dot(x) + amp * sin(2*t) + k * u;
        emit { regressor }
    }
    lagrange::system! {
        /// A bead that is only defined between two walls.
        #[derive(Clone, Debug)]
        pub struct Walled;
        param m = 2, k = 5;
        coord x, y, z;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2 + dot(z)^2);
        potential = k * (sqrt(1 - x^2) + sqrt(1 - y^2) + ln(z));
        emit { regressor }
    }
}
use driven::{Driven, DrivenInputs, Walled};

#[test]
fn times_and_present_inputs_show_what_they_multiply() {
    let base = Driven::default().base_parameters().expect("finite");
    assert_eq!(base.without_effect(), ["k"]);
    let pushed = Driven::default().with_inputs(DrivenInputs { u: 1.0 });
    assert_eq!(pushed.base_parameters().expect("finite").to_string(), "m\nc\namp\nk\n");
}

#[test]
fn states_in_which_a_system_is_not_defined_are_left_out() {
    let base = Walled::default().base_parameters().expect("defined somewhere");
    assert_eq!(base.to_string(), "m\nk\n");
}

/// At rest at x = 0, only the input pushes.
#[test]
fn forces_that_are_met_exactly_have_no_errors() {
    let driven = Driven { k: 0.0, ..Driven::default() }.with_inputs(DrivenInputs { u: 1.0 });
    let mut regression = driven.regression();
    for _ in 0..4 {
        regression.add(0.0, &[0.0], &[0.0], &[0.0], &[0.0]);
    }
    let estimate = regression.estimate().expect("enough states");
    assert_eq!((estimate.value("k"), estimate.noise()), (Some(0.0), [0.0].as_slice()));
    assert_eq!((estimate.values()[0].standard_error, estimate.covariance()[(0, 0)]), (0.0, 0.0));
}
