//! Energy over ten million steps: the error of symplectic methods does not grow.

use lagrange::integrate::{BlanesMoan4, Method, RungeKutta4, StormerVerlet, SymplecticEuler, integrate};
use lagrange::system::{EnergyFunction, OdeSystem};

use crate::systems::{Pendulum, PendulumState, Planet, PlanetState, Star, StarState};

const STEPS: u32 = 10_000_000;
/// One in this many states is recorded.
const INTERVAL: u32 = 1009;

/// A straight line fitted to errors over time.
#[derive(Debug)]
pub(crate) struct Line {
    slope: f64,
    /// Standard error of the slope.
    noise: f64,
    /// Largest magnitude of the errors.
    largest: f64,
}

pub(crate) fn line(points: &[(f64, f64)]) -> Line {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (time, error) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|(t, _)| (t - time).powi(2)).sum();
    let slope = points.iter().map(|(t, e)| (t - time) * (e - error)).sum::<f64>() / spread;
    let rest: f64 = points.iter().map(|(t, e)| (e - error - slope * (t - time)).powi(2)).sum();
    let noise = (rest / (count - 2.0) / spread).sqrt();
    Line { slope, noise, largest: points.iter().fold(0.0, |largest, (_, e)| largest.max(e.abs())) }
}

/// Returns the energy error of a motion over ten million steps.
fn energy_error<M, K>(
    system: &M,
    start: M::State,
    step: f64,
    method: &K,
    energy: fn(&M, &M::State) -> f64,
) -> Line
where
    M: OdeSystem<Scalar = f64> + EnergyFunction,
    K: Method<M>,
{
    let (first, mut count, mut points) = (energy(system, &start), 0, Vec::new());
    let end = f64::from(STEPS) * step;
    integrate(system, 0.0, start, end, method, |t, y| {
        if count % INTERVAL == 0 {
            points.push((t, energy(system, y) - first));
        }
        count += 1;
    })
    .expect("a finite motion");
    assert_eq!(count, STEPS + 1);
    let line = line(&points);
    println!("{}, h = {step}: {line:?}", method.name());
    line
}

#[track_caller]
pub(crate) fn assert_bounded(line: &Line, bound: f64) {
    assert!(line.slope.abs() < 3.0 * line.noise, "{line:?}");
    assert!(line.largest < bound, "{line:?}");
}

fn pendulum_energy(pendulum: &Pendulum, y: &[f64; 2]) -> f64 {
    let state = PendulumState::from(*y);
    pendulum.energy(0.0, &state.coordinates(), &state.velocities())
}

fn planet_energy(planet: &Planet, y: &[f64; 4]) -> f64 {
    let state = PlanetState::from(*y);
    planet.energy(0.0, &state.coordinates(), &state.velocities())
}

fn star_energy(star: &Star, y: &[f64; 4]) -> f64 {
    let state = StarState::from(*y);
    star.energy(0.0, &state.coordinates(), &state.velocities())
}

#[test]
fn the_energy_of_a_pendulum_does_not_drift() {
    let (pendulum, start, step) = (Pendulum::default(), [1.0, 0.0], 0.01);
    let bounds = [
        energy_error(&pendulum, start, step, &SymplecticEuler { step }, pendulum_energy),
        energy_error(&pendulum, start, step, &StormerVerlet { step }, pendulum_energy),
        energy_error(&pendulum, start, step, &BlanesMoan4 { step }, pendulum_energy),
    ];
    for (line, bound) in bounds.iter().zip([0.1, 2e-3, 1e-10]) {
        assert_bounded(line, bound);
    }
}

#[test]
fn the_energy_of_a_planet_does_not_drift() {
    let (planet, start, step) = (Planet::default(), [0.4, 0.0, 0.0, 2.0], 5e-3);
    assert_bounded(&energy_error(&planet, start, step, &StormerVerlet { step }, planet_energy), 2e-4);
    assert_bounded(&energy_error(&planet, start, step, &BlanesMoan4 { step }, planet_energy), 2e-11);
}

#[test]
fn the_energy_of_a_chaotic_star_does_not_drift() {
    let (star, start, step) = (Star, [0.0, 0.1, 0.5, 0.0], 0.05);
    assert_bounded(&energy_error(&star, start, step, &StormerVerlet { step }, star_energy), 2e-4);
    assert_bounded(&energy_error(&star, start, step, &BlanesMoan4 { step }, star_energy), 2e-11);
}

#[test]
fn drift_is_detected() {
    let (pendulum, start, step) = (Pendulum::default(), [1.0, 0.0], 0.01);
    let line = energy_error(&pendulum, start, step, &RungeKutta4 { step }, pendulum_energy);
    assert!(line.slope.abs() > 10.0 * line.noise, "{line:?}");
}
