//! Mechanisms over many turns: constraints hold to rounding and energy stays bounded, for any
//! method.

use std::f64::consts::{FRAC_PI_2, TAU};

use lagrange::constraint::ConstrainedSystem;
use lagrange::integrate::{Method, PlainGaussLegendre, RungeKutta4, Variational, Verner98, integrate};
use lagrange::system::{EnergyFunction, split};

use crate::four_bar::{FourBar, START};
use crate::n_four_bar::{self, Windows};
use crate::references::{Numbers, state};

lagrange::system! {
    /// A point mass on a circle, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    struct Pendulum;

    param m = 1.0, l = 1.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint rod = hypot(x, y) - l;
    emit { momentum_rates }
}

/// Observations along a motion.
#[derive(Default, Debug)]
pub(crate) struct Seen {
    /// Largest residual of positions, in the units of the constraints.
    position: f64,
    /// Largest residual of velocities.
    velocity: f64,
    /// Largest change of the energy, relative to its first value if that exceeds 1 J.
    energy: f64,
    /// Number of steps.
    pub(crate) steps: usize,
}

impl Seen {
    #[track_caller]
    pub(crate) fn assert(&self, position: f64, velocity: f64, energy: f64) {
        let is_small = self.position <= position && self.velocity <= velocity && self.energy <= energy;
        assert!(is_small, "{self:?}, not {position:e}, {velocity:e}, {energy:e}");
    }
}

fn largest(vector: &impl AsRef<[f64]>) -> f64 {
    vector.as_ref().iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// Integrates, and inspects every state.
pub(crate) fn run<M>(system: &M, start: M::State, end: f64, method: &impl Method<M>) -> (M::State, Seen)
where
    M: ConstrainedSystem<Scalar = f64> + EnergyFunction,
{
    let energy = |t, y: &M::State| {
        let (q, v) = split::<M>(y);
        system.energy(t, &q, &v)
    };
    let (first, mut seen) = (energy(0.0, &start), Seen::default());
    let last = integrate(system, 0.0, start, end, method, |t, y| {
        let (q, v) = split::<M>(y);
        seen.steps += 1;
        seen.position = seen.position.max(largest(&system.position_residuals(t, &q)));
        seen.velocity = seen.velocity.max(largest(&system.velocity_residuals(t, &q, &v)));
        seen.energy = seen.energy.max((energy(t, y) - first).abs() / first.abs().max(1.0));
    });
    let last = last.unwrap_or_else(|error| panic!("{}: {error}", method.name()));
    println!("{}: {seen:?}", method.name());
    (last, seen)
}

/// Duration of a thousand turns of the four-bar linkage, in s.
const THOUSAND_TURNS: f64 = 173.358_935_930_585_8;

#[track_caller]
pub(crate) fn assert_near<const N: usize>(found: &[f64; N], expected: &[f64; N], tolerance: f64) {
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off <= tolerance, "{found:?} is off by {off:e}");
}

#[test]
fn a_four_bar_linkage_is_back_after_a_thousand_turns() {
    let expected = state("four_bar", Numbers::Binary, THOUSAND_TURNS);
    let mut back = START;
    back[0] += 1000.0 * TAU;
    assert_near(&expected, &back, 1e-9);
    let (end, seen) = run(&FourBar::default(), START, THOUSAND_TURNS, &Verner98::tolerance(1e-13));
    assert_near(&end, &expected, 2e-7);
    seen.assert(1e-13, 1e-14, 1e-11);
}

#[test]
fn steps_of_equal_length_keep_a_four_bar_linkage_closed_for_a_thousand_turns() {
    let linkage = FourBar::default();
    let (_, seen) = run(&linkage, START, THOUSAND_TURNS, &RungeKutta4 { step: 1e-3 });
    seen.assert(1e-13, 1e-14, 1e-4);
    let (_, seen) = run(&linkage, START, THOUSAND_TURNS, &PlainGaussLegendre::<f64, 3> { step: 1e-3 });
    seen.assert(1e-13, 1e-14, 1e-8);
}

#[test]
fn the_variational_method_keeps_the_energy_of_a_four_bar_linkage_for_a_thousand_turns() {
    let (_, seen) = run(&FourBar::default(), START, THOUSAND_TURNS, &Variational { step: 1e-3 });
    seen.assert(1e-12, 1e-11, 1e-6);
}

#[test]
fn a_pendulum_in_cartesian_coordinates_is_where_it_is_in_an_angle() {
    let [theta, rate] = state("pendulum", Numbers::Binary, 100.0);
    let expected = [theta.sin(), -theta.cos(), rate * theta.cos(), rate * theta.sin()];
    let pendulum = Pendulum::default();
    let (end, seen) = run(&pendulum, [1.0, 0.0, 0.0, 0.0], 100.0, &Verner98::tolerance(1e-14));
    assert_near(&end, &expected, 1e-11);
    seen.assert(1e-15, 1e-14, 1e-11);
}

/// The cranks pass the line of their joints ten times in ten seconds. Rounding is amplified there,
/// more so the closer to the line a step ends. Corrections ignore components that they would only
/// amplify.
#[test]
fn forty_windows_pass_the_line_where_their_constraints_depend_on_each_other() {
    let (windows, start) = (Windows::default(), n_four_bar::state(FRAC_PI_2, -1.0));
    let [crank, rate] = state("n_four_bar", Numbers::Binary, 10.0);
    let expected = n_four_bar::state(crank, rate);
    let (end, seen) = run(&windows, start, 10.0, &RungeKutta4 { step: 1e-3 });
    assert_near(&end, &expected, 1e-6);
    seen.assert(1e-8, 1e-13, 1e-7);
    let (end, seen) = run(&windows, start, 10.0, &Verner98::tolerance(1e-9));
    assert_near(&end, &expected, 1e-6);
    seen.assert(1e-8, 1e-13, 1e-7);
}
