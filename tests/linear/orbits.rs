//! Periodic orbits and Lyapunov exponents against closed forms and published values.

use std::f64::consts::{PI, TAU};

use lagrange::linear::Linearise;
use lagrange::orbits::{OrbitError, Orbits};

/// A driven oscillator.
mod driven {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Driven;
        param c = 0.2, k = 4, f = 1;
        coord x;
        kinetic = 1/2 * dot(x)^2;
        potential = 1/2 * k * x^2;
        dissipation = 1/2 * c * dot(x)^2;
        force x = f * cos(t);
        emit { jacobian }
    }
}
use driven::Driven;

/// A pendulum.
mod pendulum {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Pendulum;
        param g = 1;
        coord theta;
        kinetic = 1/2 * dot(theta)^2;
        potential = -g * cos(theta);
        emit { jacobian }
    }
}
use pendulum::Pendulum;

/// Van der Pol's oscillator.
mod van_der_pol {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct VanDerPol;
        param mu = 1;
        coord x;
        kinetic = 1/2 * dot(x)^2;
        potential = 1/2 * x^2;
        force x = mu * (1 - x^2) * dot(x);
    }
}
use van_der_pol::VanDerPol;

/// A ball that bounces without loss.
mod bouncing {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Bouncing;
        param g = 10, e = 1;
        coord h;
        kinetic = 1/2 * dot(h)^2;
        potential = g * h;
        event floor = h, falling => impact(e);
    }
}
use bouncing::Bouncing;

/// Lorenz' equations.
mod lorenz {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Lorenz;
        param sigma = 10, rho = 28, beta = 8/3;
        state x, y, z;
        dot(x) = sigma * (y - x);
        dot(y) = x * (rho - z) - y;
        dot(z) = x * y - beta * z;
        emit { jacobian }
    }
}
use lorenz::Lorenz;

/// Two coupled oscillators: the Hénon–Heiles system.
mod henon_heiles {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct HenonHeiles;
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 1/2 * (x^2 + y^2) + x^2 * y - 1/3 * y^3;
        emit { jacobian }
    }
}
use henon_heiles::HenonHeiles;

/// The response of a driven oscillator: x = Re [f e^{it}/(k − 1 + i c)].
#[test]
fn a_driven_oscillator_responds_as_in_closed_form() {
    let orbit = Driven::default().orbit([3.0, -2.0], TAU).solve().expect("it responds");
    let size = 3.0 * 3.0 + 0.2 * 0.2;
    assert!((orbit.state[0] - 3.0 / size).abs() < 1e-11, "{orbit:?}");
    assert!((orbit.state[1] - 0.2 / size).abs() < 1e-11, "{orbit:?}");
    // e^{λ T} with λ = −c/2 ± i √(k − c²/4).
    let (growth, angle) = ((-0.1 * TAU).exp(), TAU * (4.0_f64 - 0.01).sqrt());
    let [(re, im), other] = orbit.multipliers[..] else { panic!("two") };
    assert!((re - growth * angle.cos()).abs() < 1e-10 && (im - (growth * angle.sin()).abs()).abs() < 1e-10);
    assert_eq!(other, (re, -im));
    assert!(orbit.is_stable() && orbit.distance < 1e-10);
    // From another time in the period.
    let later = Driven::default().orbit([0.0, 0.0], TAU).from(1.0).solve().expect("it responds");
    let x = (3.0 * 1.0_f64.cos() + 0.2 * 1.0_f64.sin()) / size;
    assert!((later.state[0] - x).abs() < 1e-11, "{later:?}");
}

/// Returns the arithmetic–geometric mean.
fn agm(mut a: f64, mut b: f64) -> f64 {
    for _ in 0..40 {
        (a, b) = (0.5 * (a + b), (a * b).sqrt());
    }
    a
}

#[test]
fn the_period_of_a_pendulum_is_an_elliptic_integral() {
    let orbit = Pendulum::default().orbit([2.0, 0.3], 8.0).free_period().solve().expect("it swings");
    let [theta, omega] = orbit.state;
    let turning = (theta.cos() - 0.5 * omega * omega).acos();
    assert!((orbit.period - TAU / agm(1.0, (0.5 * turning).cos())).abs() < 1e-8, "{orbit:?}");
    // Two multipliers of one: along the orbit, and along the family of orbits.
    assert!(orbit.multipliers.iter().all(|(re, im)| (re - 1.0).abs() + im.abs() < 1e-3), "{orbit:?}");
    assert!((orbit.monodromy[(0, 0)] + orbit.monodromy[(1, 1)] - 2.0).abs() < 1e-8);
}

#[test]
fn a_pendulum_that_turns_over_advances_by_a_turn() {
    let orbit = Pendulum::default().orbit([0.0, 2.5], 3.0).free_period().advancing("theta", TAU).solve();
    let orbit = orbit.expect("it turns over");
    // T = ∫ dθ/√(ω² + 2 (cos θ − 1)) from 0 to 2π, by the trapezoidal rule, exact for smooth
    // periodic integrands.
    let omega = (orbit.state[1].powi(2) - 2.0 * (orbit.state[0].cos() - 1.0)).sqrt();
    let count = 400;
    let rate = |k: i32| (omega * omega + 2.0 * ((TAU * f64::from(k) / f64::from(count)).cos() - 1.0)).sqrt();
    let period = (0..count).map(|k| TAU / f64::from(count) / rate(k)).sum::<f64>();
    assert!((orbit.period - period).abs() < 1e-9, "{orbit:?} {period}");
}

/// The period is known to 12 digits. Source: Andersen, Geer, "Power series expansions for the
/// frequency and period of the limit cycle of the van der Pol equation", *SIAM J. Appl. Math.* 42
/// (1982) 678–693.
#[test]
fn the_limit_cycle_of_van_der_pol_has_its_published_period() {
    let orbit = VanDerPol::default().orbit([2.0, 0.1], 6.0).free_period().solve().expect("a limit cycle");
    assert!((orbit.period - 6.663_286_859_323).abs() < 1e-9, "{}", orbit.period);
    let sizes = orbit.multipliers.iter().map(|(re, im)| re.hypot(*im)).collect::<Vec<_>>();
    assert!(sizes.iter().any(|size| (size - 1.0).abs() < 1e-7) && sizes.iter().any(|size| *size < 1e-2));
    assert!(orbit.is_stable());
}

#[test]
fn orbits_pass_impacts() {
    let orbit = Bouncing::default().orbit([1.1, 0.0], 0.85).free_period().solve().expect("it bounces");
    let [h, v] = orbit.state;
    let top = h + 0.05 * v * v;
    assert!((orbit.period - 2.0 * (0.2 * top).sqrt()).abs() < 1e-8, "{orbit:?}");
    assert!(orbit.multipliers.iter().all(|(re, im)| (re - 1.0).abs() + im.abs() < 1e-3), "{orbit:?}");
}

/// Two masses on three springs: ω² is k and 3 k. Newton's method for a linear system leads to rest
/// unless the period is close to one of its own.
mod coupled {
    lagrange::system! {
        #[derive(Clone, Debug)]
        pub struct Coupled;
        param k = 4;
        coord q[2];
        kinetic = 1/2 * inner(dot(q), dot(q));
        potential = 1/2 * k * (q[0]^2 + (q[0] - q[1])^2 + q[1]^2);
        emit { jacobian }
    }
}
use coupled::Coupled;

#[test]
fn rest_is_no_orbit_of_a_free_period() {
    let coupled = Coupled::default();
    let error = coupled.orbit([1.0, 0.8, 0.0, 0.0], 2.7).free_period().solve().unwrap_err();
    assert_eq!(error, OrbitError::AtRest);
    let orbit = coupled.orbit([1.0, 0.99, 0.0, 0.0], 0.5 * TAU).free_period().solve().expect("a mode");
    assert!((orbit.period - 0.5 * TAU).abs() < 1e-9 && orbit.state[0] > 0.9, "{orbit:?}");
    assert!((orbit.state[0] - orbit.state[1]).abs() < 1e-8, "{orbit:?}");
}

/// Exponents of Sprott, *Chaos and Time-Series Analysis*, 2003, table A.1: 0.9056, 0, −14.5723.
#[test]
fn lorenz_has_its_published_exponents() {
    let exponents = Lorenz::default().lyapunov([1.0, 1.0, 20.0]).transient(20).run(0.5, 1500).expect("chaos");
    let [first, second, third] = exponents[..] else { panic!("three") };
    assert!((first - 0.9056).abs() < 0.03, "{exponents:?}");
    assert!(second.abs() < 0.01 && (third + 14.5723).abs() < 0.03, "{exponents:?}");
    // The divergence of the rates.
    assert!((first + second + third + 10.0 + 1.0 + 8.0 / 3.0).abs() < 1e-7, "{exponents:?}");
}

#[test]
fn exponents_of_hamiltonian_motions_are_in_pairs() {
    let system = HenonHeiles;
    // Energies of 1/8, chaotic, and 1/100, regular.
    let chaotic = system.lyapunov([0.0, -0.15, 0.469_107_3, 0.0]).run(5.0, 400).expect("bounded");
    let regular = system.lyapunov([0.0, 0.1, 0.1, 0.0]).run(5.0, 400).expect("bounded");
    for exponents in [&chaotic, &regular] {
        // Volumes are conserved for any time; pairs only emerge in a long one.
        assert!(exponents.iter().sum::<f64>().abs() < 1e-9, "{exponents:?}");
        assert!((exponents[0] + exponents[3]).abs() < 5e-3, "{exponents:?}");
    }
    assert!(chaotic[0] > 0.02 && regular[0] < 0.01, "{chaotic:?} {regular:?}");
}

#[test]
fn missing_orbits_are_reported() {
    let pendulum = Pendulum::default();
    for period in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = pendulum.orbit([1.0, 0.0], period).solve().unwrap_err();
        assert_eq!(error.to_string(), "the period must be positive and finite");
    }
    let unknown = pendulum.orbit([1.0, 0.0], 7.0).advancing("phi", PI).solve().unwrap_err();
    assert_eq!(unknown.to_string(), "there is no coordinate `phi`; coordinates are [\"theta\"]");
    // Without drive, energy is lost in each period.
    let undriven = Driven { f: 0.0, ..Driven::default() };
    let rest = undriven.orbit([0.1, 0.0], TAU).solve().expect("rest is periodic");
    assert!(rest.state.iter().all(|entry| entry.abs() < 1e-10));
    // A ball that loses energy never returns.
    let lossy = Bouncing { e: 0.8, ..Bouncing::default() };
    let error = lossy.orbit([1.0, 0.0], 0.9).solve().unwrap_err();
    assert!(matches!(error, OrbitError::NotFound { .. } | OrbitError::Motion(_)), "{error}");
    assert!(Lorenz::default().lyapunov([1.0; 3]).run(0.5, 0).is_err());
    let error = Lorenz::default().lyapunov([f64::NAN; 3]).run(0.5, 3).unwrap_err();
    assert!(matches!(error, OrbitError::Motion(_)), "{error}");
}

#[test]
fn rest_is_an_orbit_of_a_given_period() {
    // Newton's method approaches it without end, up to rounding.
    let upright = Pendulum::default().orbit([PI, 0.0], 0.7).solve().expect("rests");
    assert!((upright.state[0] - PI).abs() < 1e-15 && upright.distance < 1e-15, "{upright:?}");
    for (multiplier, wanted) in upright.multipliers.iter().zip([0.7_f64.exp(), (-0.7_f64).exp()]) {
        assert!((multiplier.0 - wanted).abs() < 1e-10 && multiplier.1 == 0.0, "{upright:?}");
    }
    assert!(!upright.is_stable());
    let hanging = Pendulum::default().orbit([0.0, 0.0], 0.7).solve().expect("rests");
    assert!(hanging.is_stable() && hanging.state == [0.0; 2], "{hanging:?}");
}

lagrange::system! {
    /// A pendulum in a liquid.
    #[derive(Clone, Debug)]
    struct Shaken;
    coord theta;
    noise w, density: 1;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
    force theta = w;
    emit { jacobian, system_matrix }
}

#[test]
fn noise_has_neither_orbits_nor_exponents_but_a_linear_model_without_it() {
    let error = Shaken.orbit([0.1, 0.0], TAU).solve().map(drop).expect_err("has noise").to_string();
    assert!(error.contains("derivatives do not go through white noise"), "{error}");
    let error = Shaken.lyapunov([0.1, 0.0]).run(1.0, 3).expect_err("has noise").to_string();
    assert!(error.contains("derivatives do not go through white noise"), "{error}");
    assert_eq!(Shaken.linearise(0.0, [0.0; 2]).expect("a model").a()[(1, 0)], -1.0);
}
