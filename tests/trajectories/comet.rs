//! An orbit of eccentricity 0.99, two hundred times as fast at the nearest point as at the
//! farthest.

use std::f64::consts::TAU;

use lagrange::integrate::{BlanesMoan4, Method, RungeKutta4, StormerVerlet, integrate};

use crate::systems::Planet;

const ECCENTRICITY: f64 = 0.99;

/// Returns errors after some periods: distance from the start, largest change of the angular
/// momentum, energy.
fn errors<K: Method<Planet>>(method: &K, periods: f64) -> [f64; 3] {
    let planet = Planet::default();
    let far = 1.0 + ECCENTRICITY;
    let start = [-far, 0.0, 0.0, -((1.0 - ECCENTRICITY) / far).sqrt()];
    let momentum = |[x, y, u, v]: &[f64; 4]| x * v - y * u;
    let mut turned = 0.0_f64;
    let watch = |_, y: &[f64; 4]| turned = turned.max((momentum(y) - momentum(&start)).abs());
    let end = integrate(&planet, 0.0, start, periods * TAU, method, watch).expect("a finite motion");
    let distance = (end[0] - start[0]).hypot(end[1] - start[1]);
    let energy = planet.energy(0.0, &[end[0], end[1]], &[end[2], end[3]]) + 0.5;
    println!("{}: {distance:e} {turned:e} {energy:e}", method.name());
    [distance, turned, energy.abs()]
}

#[test]
fn the_comet_comes_back() {
    let step = TAU / 200_000.0;
    let [distance, turned, energy] = errors(&BlanesMoan4 { step }, 1.0);
    assert!(distance < 1e-9 && turned < 1e-15 && energy < 1e-13, "{distance:e} {turned:e} {energy:e}");
    let [distance, turned, _] = errors(&StormerVerlet { step }, 1.0);
    assert!(distance < 1e-3 && turned < 1e-15, "{distance:e} {turned:e}");
}

#[test]
fn a_hundred_passages_leave_the_energy_as_it_was() {
    let step = TAU / 50_000.0;
    let [distance, turned, energy] = errors(&BlanesMoan4 { step }, 100.0);
    assert!(distance < 1e-6 && turned < 1e-14 && energy < 1e-12, "{distance:e} {turned:e} {energy:e}");
    let [_, _, lost] = errors(&RungeKutta4 { step }, 100.0);
    assert!(lost > 1e3 * energy, "the test sees energy that is lost at each passage: {lost:e}");
}
