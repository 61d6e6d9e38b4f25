//! Searches and linearisations without a result, and their messages.

use lagrange::linear::{Equation, EquilibriumCause, LinearisationError, Linearise};
use lagrange::system::Component;

use super::equilibria::{DoublePendulum, Rotor};

lagrange::system! {
    /// A pendulum turned by a torque.
    #[derive(Debug)]
    struct Turned;

    param load = 1.2;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
    force theta = load;
    emit { system_matrix }
}

lagrange::system! {
    /// A pushed point that nothing holds, next to one on a spring.
    #[derive(Debug)]
    struct Pushed;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = y^2 / 2;
    force x = 2;
    emit { system_matrix }
}

lagrange::system! {
    /// A point that falls from a moving rail.
    #[derive(Debug)]
    struct Moved;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * (x^2 + y^2);
    constraint rail = y - 0.5 * t;
    emit { system_matrix }
}

lagrange::system! {
    /// A point with dry friction in closed form, drag, a stop, and a force with a kink.
    #[derive(Clone, Debug)]
    struct Kinks;

    param mu = 0, drag = 0, stop = 0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * x^2;
    force x = -mu * sign(dot(x)) - drag * dot(x) * abs(dot(x)) - stop * max(x, 0);
    emit { system_matrix }
}

lagrange::system! {
    /// A force whose slope is infinite at zero.
    #[derive(Debug)]
    struct Root;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = sqrt(x);
    emit { system_matrix }
}

#[test]
fn a_torque_beyond_the_largest_moment_leaves_an_acceleration() {
    let error = Turned::default().equilibrium([0.3, 0.0]).solve().expect_err("nothing holds it");
    let EquilibriumCause::Left { equation, residual, is_changed } = error.cause else { panic!("{error:?}") };
    assert_eq!(equation, Equation::Acceleration(Component::Velocity("theta")));
    // Newton's method ends at the largest moment.
    assert!((residual - 0.2).abs() < 1e-3 && is_changed, "{error:?}");
    assert!((error.state[0] - std::f64::consts::FRAC_PI_2).abs() < 0.05, "{error:?}");
    let text = error.to_string();
    assert!(text.contains("the acceleration `theta_ddot` remains 0.2"), "{text}");
    assert!(text.contains("Newton's method stopped after") && text.contains("theta = 1.5"), "{text}");
}

#[test]
fn residuals_without_unknowns_are_mentioned() {
    let error = Pushed.equilibrium([0.0, 1.0, 0.0, 0.0]).solve().expect_err("nothing holds it");
    let text = error.to_string();
    assert!(text.contains("`x_ddot` remains 2.0 instead of 0, which no unknown changes there"), "{text}");
    assert!(text.contains("x = 0.0, y = 0.0"), "{text}");
}

#[test]
fn infinite_entries_are_named() {
    let rods = DoublePendulum::<f64>::default();
    let error = rods.equilibrium([f64::NAN, 0.0, 0.0, 0.0]).solve().expect_err("no state");
    assert_eq!(error.to_string(), "`a` of the state is NaN");
    let error = rods.linearise(0.0, [0.0, 0.0, f64::INFINITY, 0.0]).expect_err("no state");
    assert_eq!(error.to_string(), "`a_dot` of the state is inf");
    let heavy = DoublePendulum { m: f64::NAN, ..rods };
    let error = heavy.equilibrium([0.0; 4]).solve().expect_err("no mass");
    assert!(error.to_string().contains("`m` is NaN"), "{error}");
}

#[test]
fn a_motion_that_changes_is_not_steady() {
    // When it passes the lowest point, accelerations vanish for an instant.
    let rods = DoublePendulum::<f64>::default();
    let error = rods.equilibrium([0.0, 0.0, 1.0, 1.0]).solve().expect_err("it swings");
    assert!(error.to_string().contains("is 0 and changes by"), "{error}");
}

#[test]
fn a_constraint_that_moves_has_no_equilibrium() {
    let error = Moved.equilibrium([0.0; 4]).solve().expect_err("it moves");
    assert!(error.to_string().contains("the velocities violate the constraint `rail`"), "{error}");
    // It moves steadily with the rail.
    assert!(Moved.equilibrium([0.1, 0.0, 0.0, 0.5]).solve().is_ok());
    let error = Moved.linearise(1.0, [0.0, 0.7, 0.0, 0.5]).expect_err("it is off the rail");
    assert!(error.to_string().contains("the positions violate the constraint `rail`"), "{error}");
}

#[test]
fn names_that_are_no_unknowns_are_refused_with_those_that_are() {
    let rotor = Rotor::default();
    let error = rotor.equilibrium([0.0; 6]).trim(&["thrust"]).solve().expect_err("no input of this name");
    assert_eq!(error.to_string(), "`thrust` is not among the unknowns: these are `left`, `right`");
    let error = rotor.equilibrium([0.0; 6]).hold(&["z"]).solve().expect_err("no coordinate of this name");
    assert_eq!(error.to_string(), "`z` is not among the unknowns: these are `x`, `y`, `theta`");
}

#[test]
fn there_is_no_linear_model_at_a_jump_or_a_corner() {
    let kinks = Kinks::default();
    for (system, state, is_smooth) in [
        (kinks.clone(), [0.0, 0.0], true),
        (Kinks { mu: 0.1, ..kinks.clone() }, [0.3, 0.0], false),
        (Kinks { mu: 0.1, ..kinks.clone() }, [0.3, 1e-3], true),
        // Quadratic drag has zero slope on both sides.
        (Kinks { drag: 0.1, ..kinks.clone() }, [0.3, 0.0], true),
        (Kinks { stop: 1.0, ..kinks.clone() }, [0.0, 0.2], false),
        (Kinks { stop: 1.0, ..kinks.clone() }, [-1e-12, 0.2], false),
        (Kinks { stop: 1.0, ..kinks.clone() }, [-1e-3, 0.2], true),
    ] {
        let found = system.linearise(0.0, state);
        assert_eq!(found.is_ok(), is_smooth, "{system:?} {state:?} {found:?}");
        if let Err(error) = found {
            assert!(matches!(error, LinearisationError::Corner { .. }), "{error}");
            assert!(error.to_string().contains("the equations have a corner or jump there"), "{error}");
        }
    }
}

#[test]
fn a_derivative_that_is_not_finite_is_named() {
    let error = Root.linearise(0.0, [0.0, 0.0]).expect_err("a root at 0");
    assert!(
        error.to_string().contains("the derivative of the rate of `x_dot` by `x` is not finite"),
        "{error}"
    );
}
