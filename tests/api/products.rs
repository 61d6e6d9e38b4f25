//! Products that are requested, omitted, or implied by the form of the energies.

use lagrange::system::{CanonicalSystem, EnergyFunction, MechanicalSystem, OdeSystem};

use crate::assert_close;

lagrange::system! {
    struct Asked;

    param m = 2.0, g = 9.81, c = 0.5;
    coord x, theta;
    kinetic = 1/2 * m * (dot(x)^2 + x^2 * dot(theta)^2);
    potential = m * g * x * cos(theta);
    dissipation = 1/2 * c * dot(x)^2;
    emit { bias, latex, no inverse_dynamics }
}

lagrange::system! {
    struct Silent;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    emit { no energy, no kinetic_energy, no momenta, jacobian }
}

lagrange::system! {
    /// Names that are not generated remain available.
    struct Particle<S>;

    param m = 1.0, c = 2.0;
    coord x;
    lagrangian = -m * c^2 * sqrt(1 - dot(x)^2 / c^2);
}

/// An omitted method does not exist, so that the method of a trait is found instead.
trait Fallback {
    fn inverse_dynamics(&self) -> &'static str {
        "left out"
    }
    fn energy(&self) -> &'static str {
        "left out"
    }
    fn kinetic_energy(&self) -> &'static str {
        "left out"
    }
}

impl Fallback for Asked {}
impl Fallback for Silent {}
impl Fallback for Particle<f64> {}

lagrange::system! {
    /// The force is undefined in a branch that is not always taken.
    struct Valve;

    param m = 2.0, k = 3.0;
    input push = 0.5;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    force x = push + if x > 0 { k * sqrt(x) * dot(x) } else { 0 };
    emit { momentum_rates, jacobian }
}

#[test]
fn jacobians_are_those_of_the_branch_that_is_taken() {
    let valve = Valve::default();
    assert_eq!(valve.jacobian(0.0, &[-1.0, 0.5]), [[0.0, 1.0], [0.0, 0.0]]);
    let [first, [slope, resistance]] = valve.jacobian(0.0, &[4.0, 0.5]);
    assert_eq!(first, [0.0, 1.0]);
    assert_close(slope, 3.0 * 0.25 * 0.5 / 2.0);
    assert_close(resistance, 3.0 * 2.0 / 2.0);
    assert!(valve.jacobian(0.0, &[f64::NAN, 0.5])[1].iter().all(|entry| entry.is_nan()));
    assert_eq!(OdeSystem::jacobian(&valve, 0.0, &[4.0, 0.5]), Some(valve.jacobian(0.0, &[4.0, 0.5])));
    assert_eq!(OdeSystem::jacobian(&Asked::default(), 0.0, &[1.0; 4]), None);
}

#[test]
fn parameters_are_differentiated_by_in_their_order_before_inputs() {
    assert_eq!(Valve::PARAMETERS, ["m", "k", "push"]);
    let [first, [m, k, push]] = Valve::default().parameter_jacobian(0.0, &[4.0, 0.5]);
    assert_eq!(first, [0.0; 3]);
    assert_close(m, -(0.5 + 3.0) / 4.0);
    assert_close(k, 2.0 * 0.5 / 2.0);
    assert_close(push, 0.5);
    assert_eq!(Silent.parameter_jacobian(0.0, &[1.0; 2]), [[0.0_f64; 0]; 2]);
    assert!(Silent::PARAMETERS.is_empty());
}

#[test]
fn momentum_rates_are_forces_where_the_mass_is_constant() {
    let (q, v) = ([4.0], [0.5]);
    let [rate] = CanonicalSystem::momentum_rates(&Valve::default(), 0.0, &q, &v);
    assert_eq!([rate], Valve::default().momentum_rates(0.0, &q, &v));
    assert_close(rate, 3.5);
}

#[test]
fn bias_is_the_inverse_dynamics_at_rest_without_applied_forces() {
    let [radial, angular] = Asked::default().bias(0.0, &[1.5, 0.3], &[0.4, 0.7]);
    let Asked { m, g, .. } = Asked::default();
    assert_close(radial, -m * 1.5 * 0.49 + m * g * 0.3_f64.cos());
    assert_close(angular, 2.0 * m * 1.5 * 0.4 * 0.7 - m * g * 1.5 * 0.3_f64.sin());
}

#[test]
fn equations_are_printed_one_line_for_each_coordinate() {
    let lines = Asked::EQUATIONS_LATEX.lines().collect::<Vec<_>>();
    assert_eq!(lines.len(), 2);
    assert!(lines[0].starts_with(r"m \ddot{x} = "), "{}", lines[0]);
    assert!(lines[1].contains(r"\ddot{\theta}"), "{}", lines[1]);
}

#[test]
fn omitted_products_do_not_exist() {
    assert_eq!(Asked::default().inverse_dynamics(), "left out");
    assert_eq!([Silent.energy(), Silent.kinetic_energy()], ["left out"; 2]);
    assert_eq!(Particle::<f64>::default().kinetic_energy(), "left out");
    assert_eq!(Silent.acceleration(0.0, &[0.0], &[1.0]), [0.0]);
    assert_eq!(Silent::COORDINATES, ["x"]);
}

#[test]
fn a_mass_matrix_that_depends_on_velocities_takes_them() {
    type Vector = [f64; 1];
    let particle = Particle::<f64>::default();
    let mass: fn(&Particle<f64>, f64, &Vector, &Vector) -> [Vector; 1] = Particle::mass_matrix;
    let gamma = 1.0 / (1.0 - 0.36_f64).sqrt();
    assert_close(mass(&particle, 0.0, &[0.0], &[1.2])[0][0], gamma.powi(3));
    assert_close(particle.momenta(0.0, &[0.0], &[1.2])[0], gamma * 1.2);
    assert_close(EnergyFunction::energy(&particle, 0.0, &[0.0], &[1.2]), gamma * 4.0);
}
