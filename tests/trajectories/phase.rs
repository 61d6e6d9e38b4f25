//! The phase error of a single pendulum over a million seconds.
//!
//! Its period is 4 K(sin(θ₀/2))/ω₀ = 2 π/(ω₀ M(1, cos(θ₀/2))) with the complete elliptic integral K
//! and the arithmetic–geometric mean M. Source: Landau, Lifshitz, *Mechanics*, §11.

use std::f64::consts::TAU;

use lagrange::integrate::{BlanesMoan4, Method, StormerVerlet, integrate};

use crate::systems::Pendulum;

const AMPLITUDE: f64 = 1.0;

fn mean(mut a: f64, mut b: f64) -> f64 {
    // The number of correct digits doubles each time.
    for _ in 0..8 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

/// Returns the lead of the pendulum in seconds after about `seconds`.
fn lead<K: Method<Pendulum>>(method: &K, seconds: f64) -> f64 {
    let pendulum = Pendulum::default();
    let frequency = (pendulum.g / pendulum.l).sqrt();
    let period = TAU / (frequency * mean(1.0, (AMPLITUDE / 2.0).cos()));
    // A quarter period after a turning point it passes the lowest point at full speed, backwards.
    let end = ((seconds / period).round() + 0.25) * period;
    let [theta, rate] =
        integrate(&pendulum, 0.0, [AMPLITUDE, 0.0], end, method, |_, _| {}).expect("a finite motion");
    assert!(rate < 0.0, "{rate}");
    println!("{}: {:e} s early after {end} s", method.name(), theta / rate);
    theta / rate
}

#[test]
fn the_phase_error_after_a_million_seconds_is_stated() {
    let early = lead(&BlanesMoan4 { step: 0.02 }, 1e6);
    assert!(early.abs() < 2e-4, "{early:e}");
}

#[test]
fn the_phase_error_grows_in_proportion_to_time() {
    let method = StormerVerlet { step: 1e-3 };
    let [short, long] = [1e3, 1e5].map(|seconds| lead(&method, seconds));
    assert!((long / short / 100.0 - 1.0).abs() < 0.02, "{short:e} {long:e}");
}
