//! The adaptive pair on motions with known answers.

use lagrange::event::{Action, Direction, Occurrence, integrate_with_events};
use lagrange::integrate::{RungeKutta4, StepFailure, Verner98, integrate};
use lagrange::system::OdeSystem;

use super::references::{Numbers, state};
use super::systems::{DoublePendulum, Pendulum, Top};

lagrange::system! {
    /// A planet around a fixed sun, in polar coordinates.
    #[derive(Clone, Debug)]
    struct Kepler;

    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + (r * dot(phi))^2);
    potential = -1 / r;
}

lagrange::system! {
    /// A pendulum whose pivot vibrates; theta is measured from the upright position.
    #[derive(Clone, Debug)]
    struct Kapitza;

    param l = 1.0, g = 9.81, amplitude = 0.002, frequency = 1000.0;
    coord theta;
    let (x, y) = (l * sin(theta), l * cos(theta) + amplitude * cos(2 * pi * frequency * t));
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
}

lagrange::system! {
    /// A point mass on a spring.
    #[derive(Clone, Debug)]
    struct Elastic;

    param m = 1.0, l = 1.0, k = 1e9, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * m * (dot(r)^2 + (r * dot(theta))^2);
    potential = 1/2 * k * (r - l)^2 - m * g * r * cos(theta);
}

fn tight() -> Verner98<f64> {
    Verner98::tolerance(1e-15)
}

fn end<M: OdeSystem<Scalar = f64>>(system: &M, start: M::State, t: f64, method: &Verner98<f64>) -> M::State {
    integrate(system, 0.0, start, t, method, |_, _| {}).expect("reaches the end")
}

fn error<const N: usize>(found: [f64; N], wanted: [f64; N]) -> f64 {
    found.iter().zip(wanted).fold(0.0, |largest, (found, wanted)| (found - wanted).abs().max(largest))
}

#[test]
fn the_double_pendulum_is_right_to_rounding() {
    let start = state::<4>("double_pendulum", Numbers::Binary, 0.0);
    let found = end(&DoublePendulum::default(), start, 10.0, &tight());
    let error = error(found, state("double_pendulum", Numbers::Binary, 10.0));
    assert!(error < 1e-13, "{error}");
}

#[test]
fn a_hundred_orbits_lose_as_much_as_rounding_makes_of_the_period() {
    let start = state::<4>("kepler", Numbers::Binary, 0.0);
    let found = end(&Kepler, start, 100.0, &tight());
    let early = error(found, state("kepler", Numbers::Binary, 100.0));
    assert!(early < 2e-12, "{early}");
    let round = 628.318_530_717_958_6;
    let late = error(end(&Kepler, start, round, &tight()), state("kepler", Numbers::Binary, round));
    assert!(late < 5e-10, "{late}");
}

/// Periods 4 √(l/g) K(sin(θ₀/2)).
#[test]
fn periods_of_the_pendulum_are_right_at_every_amplitude() {
    let known = [
        (0.001, 2.006_066_806_089_822),
        (1.0, 2.139_137_600_558_689),
        (3.0, 5.158_066_754_267_866),
        (314_159.0 / 1e5, 19.053_129_937_206_39),
    ];
    for (amplitude, period) in known {
        let watch = ([Direction::Falling], |_: f64, [theta, _]: &[f64; 2]| [*theta]);
        let stop = |_: &Occurrence<f64, [f64; 2]>| Action::Stop;
        let start = (0.0, [amplitude, 0.0]);
        let fall = integrate_with_events(&Pendulum::default(), start, period, &tight(), watch, stop);
        let found = 4.0 * fall.expect("falls").0;
        // The angle is only known to rounding, whose effect near the top grows with the time of the
        // fall.
        let bound = if amplitude > 3.1 { 1e-9 } else { 4e-14 };
        assert!((found / period - 1.0).abs() < bound, "{amplitude}: {found}");
    }
}

/// From π − 1e-9 the bottom is reached at √(l/g) ln(4/k′), k′ = sin(½ · 1e-9), up to terms of order
/// k′².
#[test]
fn a_fall_from_the_top_takes_as_long_as_it_should() {
    let start = core::f64::consts::PI - 1e-9;
    // The difference between π and its nearest number.
    let offset = (core::f64::consts::PI - start) + 1.224_646_799_147_353_2e-16;
    let quarter = (1.0_f64 / 9.81).sqrt() * (4.0 / (0.5 * offset).sin()).ln();
    let watch = ([Direction::Falling], |_: f64, [theta, _]: &[f64; 2]| [*theta]);
    let stop = |_: &Occurrence<f64, [f64; 2]>| Action::Stop;
    let (time, _) =
        integrate_with_events(&Pendulum::default(), (0.0, [start, 0.0]), 20.0, &tight(), watch, stop)
            .expect("falls");
    // Near π the spacing of θ is 4e-7 of its distance from π.
    assert!((time - quarter).abs() < 1e-6, "{time} for {quarter}");
}

/// Near the upright position the axis moves as A exp(iλ₁t) + B exp(iλ₂t) with 2 λ I₁ = I₃ω ±
/// √(I₃²ω² − 4 m g l I₁). From rest it reaches (λ₁ + λ₂)/(λ₁ − λ₂) = 5/√21 of its initial
/// deviation.
#[test]
fn a_sleeping_top_stays_asleep() {
    let top = Top::default();
    let start = [0.0, 1e-4, 0.0, 0.0, 0.0, 10.0];
    let split = |y: &[f64; 6]| ([y[0], y[1], y[2]], [y[3], y[4], y[5]]);
    let (q, v) = split(&start);
    let (energy, momenta) = (top.energy(0.0, &q, &v), top.momenta(0.0, &q, &v));
    let (mut widest, mut drift) = (0.0_f64, 0.0_f64);
    integrate(&top, 0.0, start, 100.0, &Verner98::tolerance(1e-13), |t, y| {
        let (q, v) = split(y);
        let found = top.momenta(t, &q, &v);
        widest = widest.max(q[1].abs());
        drift = drift.max((top.energy(t, &q, &v) - energy).abs());
        drift = drift.max((found[0] - momenta[0]).abs()).max((found[2] - momenta[2]).abs());
    })
    .expect("reaches the end");
    assert!((widest / 1e-4 * 21.0_f64.sqrt() / 5.0 - 1.0).abs() < 1e-3, "{widest}");
    assert!(drift < 1e-12, "{drift}");
}

/// The upright pendulum is stable if the pivot moves faster than √(2 g l); it swings with Ω² =
/// (aω)²/(2 l²) − g/l.
#[test]
fn a_pivot_that_vibrates_a_thousand_times_a_second_keeps_the_pendulum_up() {
    let system = Kapitza::default();
    let mut crossings = Vec::new();
    let watch = ([Direction::Falling], |_: f64, [theta, _]: &[f64; 2]| [*theta]);
    integrate_with_events(&system, (0.0, [0.05, 0.0]), 4.0, &Verner98::tolerance(1e-10), watch, |event| {
        crossings.push(event.time);
        Action::Continue
    })
    .expect("reaches the end");
    let speed: f64 = 0.002 * 2.0 * core::f64::consts::PI * 1000.0;
    let slow = 2.0 * core::f64::consts::PI / (speed * speed / 2.0 - 9.81).sqrt();
    let found = (crossings[crossings.len() - 1] - crossings[0]) / (crossings.len() - 1) as f64;
    // Averaging neglects the square of the pivot's amplitude over the length, and the square of the
    // swing's amplitude.
    assert!((found / slow - 1.0).abs() < 5e-3, "{found} for {slow}");
    let fine =
        integrate(&system, 0.0, [0.05, 0.0], 0.5, &RungeKutta4 { step: 2e-6 }, |_, _| {}).expect("finite");
    let both = error(end(&system, [0.05, 0.0], 0.5, &Verner98::tolerance(1e-13)), fine);
    assert!(both < 1e-9, "{both}");
}

#[test]
fn a_stiff_spring_is_refused_with_the_stable_step() {
    let failed = integrate(
        &Elastic::default(),
        0.0,
        [1.0, 0.5, 0.0, 0.0],
        10.0,
        &Verner98::tolerance(1e-6),
        |_, _| {},
    )
    .expect_err("stiff");
    let StepFailure::Stiff { limit, .. } = failed.cause else { panic!("{failed}") };
    // 2.9 over the frequency √(k/m).
    assert!((limit / 9.17e-5 - 1.0).abs() < 0.1, "{limit}");
    assert!(failed.state.iter().all(|component| component.is_finite()));
}

#[test]
fn the_energy_of_a_chaotic_motion_stays_for_a_thousand_seconds() {
    let system = DoublePendulum::default();
    let energy = |y: &[f64; 4]| system.energy(0.0, &[y[0], y[1]], &[y[2], y[3]]);
    let start = [core::f64::consts::FRAC_PI_2, core::f64::consts::FRAC_PI_2, 0.0, 0.0];
    let mut drift = 0.0_f64;
    integrate(&system, 0.0, start, 1000.0, &Verner98::tolerance(3e-15), |_, y| {
        drift = drift.max((energy(y) - energy(&start)).abs());
    })
    .expect("reaches the end");
    // Kinetic and potential energy are up to 40 J each.
    assert!(drift < 1e-11, "{drift}");
}
