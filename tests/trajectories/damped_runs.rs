//! Runs of stiff systems by Radau's method: samples, events, controllers, contacts, orientations.

use lagrange::Simulate;
use lagrange::event::Direction;
use lagrange::integrate::{Radau5, Verner98, integrate};

use crate::damped::{ElasticPendulum, TOLERANCES};

#[test]
fn states_within_steps_keep_the_tolerance() {
    let (pendulum, start) = (ElasticPendulum::<f64>::default(), [1.0, 1.0, 0.0, 0.0]);
    let fine = pendulum
        .simulate(start)
        .until(4.0)
        .every(0.01)
        .method(Radau5::tolerance(1e-12))
        .run()
        .expect("goes on");
    for tolerance in TOLERANCES {
        let run = pendulum.simulate(start).until(4.0).every(0.01).method(Radau5::tolerance(tolerance)).run();
        let run = run.expect("goes on");
        let columns = [(run.theta(), fine.theta()), (run.theta_dot(), fine.theta_dot()), (run.r(), fine.r())];
        for (found, expected) in columns {
            assert_eq!(found.len(), 401);
            for (found, expected) in found.iter().zip(expected) {
                let error = (found - expected).abs() / (1.0 + expected.abs());
                assert!(error < 10.0 * tolerance, "{tolerance}: {found} {expected}");
            }
        }
    }
}

#[test]
fn events_are_found_where_they_are() {
    let (pendulum, start) = (ElasticPendulum::<f64>::default(), [1.0, 1.0, 0.0, 0.0]);
    let passages = |tolerance: f64| {
        let run = pendulum.simulate(start).until(10.0).method(Radau5::tolerance(tolerance));
        let run = run.event("below", Direction::Crossing, |_, _, y| y[1]).run().expect("goes on");
        run.events().iter().map(|event| event.time).collect::<Vec<_>>()
    };
    let expected = passages(1e-12);
    assert_eq!(expected.len(), 9);
    for tolerance in TOLERANCES {
        let found = passages(tolerance);
        assert_eq!(found.len(), expected.len());
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 30.0 * tolerance, "{tolerance}: {found} {expected}");
        }
    }
}

lagrange::system! {
    /// A motor with a tiny inductance that turns an arm by a law or a sampled controller.
    #[derive(Clone, Debug)]
    struct Motor;

    param inductance = 1e-6, resistance = 1.0, constant = 0.5;
    input voltage;
    coord phi;
    state current;
    dot(current) = (voltage - resistance * current - constant * dot(phi)) / inductance;
    kinetic = 1/2 * dot(phi)^2;
    potential = -2 * cos(phi);
    force phi = constant * current - 1/10 * dot(phi);
}

#[test]
fn laws_and_sampled_controllers_drive_stiff_systems() {
    let (motor, start) = (Motor::default(), [0.3, 0.0, 0.0]);
    let law = |_: &Motor, t: f64, state: MotorState| MotorInputs { voltage: t.sin() - 3.0 * state.phi };
    let explicit = Verner98 { refuses_stiff: false, ..Verner98::tolerance(1e-10) };
    let run = || motor.simulate(start).until(0.2).ends_only();
    let expected = [
        run().drive(law).method(explicit).run().expect("goes on").last(),
        run().sampled(0.02, law).method(explicit).run().expect("goes on").last(),
    ];
    for tolerance in TOLERANCES {
        let implicit = Radau5::tolerance(tolerance);
        let found = [
            run().drive(law).method(implicit).run().expect("goes on").last(),
            run().sampled(0.02, law).method(implicit).run().expect("goes on").last(),
        ];
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 10.0 * tolerance, "{tolerance}: {found} {expected}");
        }
    }
}

lagrange::system! {
    /// A mass above the ground on a stiffly suspended foot that hits the ground.
    #[derive(Clone, Debug)]
    struct Hopper;

    param k = 1e6, c = 2e3, g = 9.81;
    coord foot, head;
    kinetic = 1/2 * (dot(foot)^2 + 5 * dot(head)^2);
    potential = g * (foot + 5 * head) + 1/2 * k * (head - foot - 1)^2;
    dissipation = 1/2 * c * (dot(head) - dot(foot))^2;
    event ground = foot, falling => impact(0.2);
}

#[test]
fn contacts_of_stiff_systems_close_and_open() {
    let (hopper, start) = (Hopper::default(), [0.3, 1.3, 0.0, 0.0]);
    let run = || hopper.simulate(start).until(1.5);
    let explicit = run().tolerance(1e-12).run().expect("goes on");
    let implicit = run().method(Radau5::tolerance(1e-9)).run().expect("goes on");
    assert_eq!(explicit.events().len(), implicit.events().len());
    for (found, expected) in implicit.events().iter().zip(explicit.events()) {
        assert!((found.time - expected.time).abs() < 1e-7, "{} {}", found.time, expected.time);
    }
    for (found, expected) in implicit.last().iter().zip(explicit.last()) {
        assert!((found - expected).abs() < 1e-7, "{found} {expected}");
    }
}

lagrange::system! {
    /// A body in a viscous medium, turned by moments about its axes.
    #[derive(Clone, Debug)]
    struct Gimbal;

    param drag = 1e5;
    gravity = (0, 0, 0);
    body rotor { mass: 1; inertia: (1, 2, 3); }
    free rotor;
    let (wx, wy, wz) = angular_velocity(rotor);
    torque (1e5 - drag * wx, -drag * wy, 2e5 * cos(t) - drag * wz) on rotor;
    emit { jacobian }
}

/// With such drag, the body rotates at the torque over the drag coefficient.
#[test]
fn quaternions_of_damped_bodies_keep_their_length_and_tolerance() {
    let mut start = [0.0; 13];
    start[3] = 1.0;
    let expected = {
        let explicit = Verner98 { refuses_stiff: false, ..Verner98::tolerance(1e-11) };
        integrate(&Gimbal::default(), 0.0, start, 0.5, &explicit, |_, _| {}).expect("goes on")
    };
    for tolerance in TOLERANCES {
        let end = integrate(&Gimbal::default(), 0.0, start, 0.5, &Radau5::tolerance(tolerance), |_, _| {});
        let end = end.expect("goes on");
        let length = end[3..7].iter().map(|entry| entry * entry).sum::<f64>();
        assert!((length - 1.0).abs() < 1e-15, "{length}");
        for (found, expected) in end.as_ref().iter().zip(expected) {
            assert!((found - expected).abs() < 10.0 * tolerance, "{tolerance}: {found} {expected}");
        }
    }
}

#[test]
fn the_default_method_names_the_line_to_write() {
    let said = |error: String| {
        assert!(error.contains("use `.method(Radau5::tolerance(1e-6))`"), "{error}");
        error.contains("emit { jacobian }")
    };
    let known =
        ElasticPendulum::<f64>::default().simulate([1.0, 1.0, 0.0, 0.0]).until(10.0).tolerance(1e-6).run();
    assert!(!said(known.expect_err("stiff").to_string()));
    let unknown = Motor::default().simulate([0.3, 0.0, 0.0]).until(10.0).tolerance(1e-6).run();
    assert!(said(unknown.expect_err("stiff").to_string()));
}
