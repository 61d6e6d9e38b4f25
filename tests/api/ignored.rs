//! Reduced types with ignored coordinates, beside the whole systems and textbooks.

use crate::assert_close;
use lagrange::Simulate;
use lagrange::integrate::Taylor;
use lagrange::system::{Equations, LanesSystem, OutputSystem};

lagrange::system! {
    /// A spherical pendulum in Cartesian coordinates, with a wind that turns.
    #[derive(Clone, Debug, PartialEq)]
    pub struct Spherical<S>;

    param m = 1.3, l = 0.7, g = 9.81, c = 0.1;
    input push;
    coord theta, phi;
    let bob = l * (sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta));
    kinetic = kinetic_energy(m, dot(bob));
    potential = gravitational_energy(m, g, bob.z);
    dissipation = 1/2 * c * dot(theta)^2;
    force theta = push * cos(t);
    force (0, 0, 1/5 * dot(phi)) at bob;
    output bob_at = bob;
    output pull = ddot(bob);
    emit { conserved, jacobian, lanes, prepared, system_matrix, taylor, power, parameter_jacobian }
    /// The pendulum around its vertical axis.
    reduce Turning { ignore phi; }
}

lagrange::system! {
    #[scalar(f32)]
    #[derive(Debug)]
    struct Single;

    param m = 1, l = 1, g = 9.81, tilt = 0.4;
    coord theta, phi;
    kinetic = 1/2 * m * l^2 * (dot(theta)^2 + sin(theta)^2 * dot(phi)^2);
    potential = -m * g * l * cos(theta);
    reduce SingleTurning { ignore phi; }
    reduce Conical { ignore phi; small theta = tilt; }
}

lagrange::system! {
    /// A heavy symmetric top in Euler angles.
    #[derive(Clone, Debug, PartialEq)]
    struct Top;

    param a = 0.12, c = 0.05, w = 2.7;
    coord phi = 0.1, theta = 0.6, psi;
    start dot(psi) = 40;
    kinetic = 1/2 * a * (dot(theta)^2 + sin(theta)^2 * dot(phi)^2) + 1/2 * c * (dot(psi) + dot(phi) * cos(theta))^2;
    potential = w * cos(theta);
    emit { momentum_rates }
    reduce Nutating { ignore psi, phi; }
    reduce Spinning { ignore psi; }
}

lagrange::system! {
    /// A charge on a frame in a magnetic field, which a motor drives.
    #[derive(Clone, Debug, PartialEq)]
    struct Charge;

    param m = 0.8, b = 1.7, k = 5, j = 0.3, height = 0.2;
    coord x, y, z[2];
    state heat;
    lagrangian = 1/2 * m * (dot(x)^2 + dot(y)^2 + dot(z[0])^2 + 2*dot(z[1])^2) + b * x * dot(y) * (1 + sin(t)/3)
        + j * dot(z[0]) * dot(x) * cos(x) + j * dot(z[0]) * dot(z[1]) - 1/2 * k * x^2;
    dot(heat) = dot(y)^2 - heat;
    force x = -heat * dot(x) + dot(z[1]);
    emit { jacobian }
    reduce Along { ignore y; }
    reduce AlongAll { ignore y, z; }
    reduce Held { ignore y; freeze z[0] = height; }
}

/// Returns generic states, neither special nor small.
fn numbers<const N: usize>() -> impl Iterator<Item = [f64; N]> {
    (0..100)
        .map(f64::from)
        .map(|i| std::array::from_fn(|k| ((1.7 + k as f64) * i + 0.3 * k as f64).sin() * 1.5 + 0.2))
}

fn close_to(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(1.0, |a: f64, b| a.max(b.abs()));
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * largest, "{found:?} are not {expected:?}");
    }
}

#[test]
fn accelerations_are_those_of_the_whole_system() {
    let whole = Spherical { push: 0.3, ..Spherical::<f64>::default() };
    for y in numbers::<4>().filter(|y| y[0].sin().abs() > 0.2) {
        let [theta, phi, v, w] = y;
        let t = v;
        let turning = Turning::from_state(&whole, t, y.into());
        assert_close(turning.phi_momentum, 1.3 * 0.49 * theta.sin().powi(2) * w);
        let state = TurningState::from(SphericalState::from(y));
        assert_eq!(state, TurningState { theta, phi, theta_dot: v });
        let all = whole.acceleration(t, &[theta, phi], &[v, w]);
        close_to(&turning.acceleration(t, &[theta, phi], &[v]), &all[..1], 1e-12);
        let [back] = [turning.expand(t, state)];
        close_to(&<[f64; 4]>::from(back), &y, 1e-13);
        close_to(&turning.pull(t, &[theta, phi], &[v]), &whole.pull(t, &[theta, phi], &[v, w]), 1e-12);
        close_to(&turning.bob_at(t, &[theta, phi], &[v]), &whole.bob_at(t, &[theta, phi], &[v, w]), 1e-15);
        let energies = [turning.energy(t, &[theta, phi], &[v]), whole.energy(t, &[theta, phi], &[v, w])];
        assert_close(energies[0], energies[1]);
        let parts =
            turning.kinetic_energy(t, &[theta, phi], &[v]) + turning.potential_energy(t, &[theta, phi]);
        assert_close(parts, energies[1]);
    }
}

#[test]
fn linear_terms_and_states_stay() {
    let whole = Charge::default();
    for y in numbers::<9>() {
        let [x, y_, z0, z1, heat, vx, vy, v0, v1] = y;
        let (t, state) = (x, ChargeState::from(y));
        let (q, v) = (state.coordinates(), state.velocities());
        let all = whole.acceleration(t, &q, &v);
        let along = Along::from_state(&whole, t, state);
        assert_close(along.y_momentum, 0.8 * vy + 1.7 * x * (1.0 + t.sin() / 3.0));
        let own = AlongState::from(state);
        assert_eq!(own, AlongState { x, z: [z0, z1], heat, y: y_, x_dot: vx, z_dot: [v0, v1] });
        let found = along.acceleration(t, &own.coordinates(), &own.velocities());
        close_to(&found, &[all[0], all[2], all[3]], 1e-12);
        let rates = along.position_rates(t, &own.coordinates(), &own.velocities());
        close_to(&rates, &[vx, v0, v1, vy * vy - heat, vy], 1e-12);
        let only = AlongAll::from_state(&whole, t, state);
        let own = AlongAllState::from(state);
        close_to(&only.acceleration(t, &own.coordinates(), &own.velocities()), &all[..1], 1e-11);
        close_to(&<[f64; 9]>::from(only.expand(t, own)), &y, 1e-12);
    }
}

#[test]
fn momenta_are_those_of_a_state_in_which_what_is_frozen_rests() {
    let whole = Charge::default();
    let state =
        ChargeState { x: 0.3, y: 0.1, z: [7.0, 0.2], heat: 0.1, x_dot: 0.4, y_dot: 0.5, z_dot: [3.0, 0.6] };
    let held = Held::from_state(&whole, 0.0, state);
    assert_eq!(Charge::from(&held), whole);
    let rest = ChargeState { z: [0.2, 0.2], z_dot: [0.0, 0.6], ..state };
    assert_eq!(held, Held::from_state(&whole, 0.0, rest));
    let own = HeldState::from(state);
    close_to(&<[f64; 9]>::from(held.expand(0.0, own)), &<[f64; 9]>::from(rest), 1e-15);
    let other = ChargeState { y_dot: 0.75, ..state };
    let deviation = held.deviation(0.0, other);
    let expected =
        ChargeState { z: [6.8, 0.0], z_dot: [3.0, 0.0], y_dot: 0.25, ..ChargeState::from([0.0; 9]) };
    close_to(&<[f64; 9]>::from(deviation), &<[f64; 9]>::from(expected), 1e-14);
}

/// a θ̈ = w sin θ − ∂/∂θ (p − s cos θ)²/(2 a sin² θ) (Goldstein, Poole and Safko, *Classical
/// Mechanics*, 3rd ed., §5.7)
#[test]
fn a_top_moves_in_its_effective_potential() {
    let whole = Top::default();
    let Top { a, c, w } = whole;
    let nutating = Nutating::from_state(&whole, 0.0, whole.start());
    assert_eq!(nutating, Nutating::default());
    assert_close(nutating.psi_momentum, c * 40.0);
    assert_eq!(<[f64; 4]>::from(nutating.start()), [0.6, 0.1, 0.0, 0.0]);
    for [theta, p, s, v] in numbers::<4>().filter(|y| y[0].sin().abs() > 0.2) {
        let top = Nutating { phi_momentum: p, psi_momentum: s, ..nutating.clone() };
        let (sine, cosine) = theta.sin_cos();
        let rest = p - s * cosine;
        let expected = w * sine - rest * s / (a * sine) + rest * rest * cosine / (a * sine.powi(3));
        close_to(&top.acceleration(0.0, &[theta, 0.0, 0.0], &[v]), &[expected / a], 1e-12);
        let [_, phi, psi] = top.position_rates(0.0, &[theta, 0.0, 0.0], &[v]);
        close_to(&[phi, psi], &[rest / (a * sine * sine), s / c - phi * cosine], 1e-12);
    }
}

#[test]
fn motions_are_those_of_the_whole_system_with_the_ignored_angle() {
    let whole = Top::default();
    let start = TopState { theta_dot: 0.3, ..whole.start() };
    let (top, spinning) =
        (Nutating::from_state(&whole, 0.0, start), Spinning::from_state(&whole, 0.0, start));
    let all = whole.simulate(start).until(5.0).every(0.5).tolerance(1e-13).run().unwrap();
    let own = top.simulate(NutatingState::from(start)).until(5.0).every(0.5).tolerance(1e-13).run().unwrap();
    let other = spinning.simulate(SpinningState::from(start)).until(5.0).every(0.5).tolerance(1e-13);
    let other = other.run().unwrap();
    for (found, expected) in [
        (own.theta(), all.theta()),
        (own.phi(), all.phi()),
        (own.psi(), all.psi()),
        (other.phi(), all.phi()),
        (other.psi(), all.psi()),
    ] {
        close_to(found, expected, 1e-9);
    }
    let before = whole.energy(0.0, &start.coordinates(), &start.velocities());
    for [theta, phi, psi, rate] in own.states() {
        let energy = top.energy(0.0, &[theta, phi, psi], &[rate]);
        assert!((energy / before - 1.0).abs() < 1e-11, "{energy} is not {before}");
    }
}

/// A conical pendulum turns at Ω² = g/(l cos θ). About this motion it swings at ω² = g (1 + 3 cos²
/// θ)/(l cos θ), from the effective potential (Landau and Lifshitz, *Mechanics*, §14, problem 1).
#[test]
fn small_swings_about_a_steady_motion_have_the_frequency_of_the_textbook() {
    let whole = Single::default();
    let (tilt, cosine) = (whole.tilt, whole.tilt.cos());
    let state = SingleState { theta: tilt, phi: 0.0, theta_dot: 0.0, phi_dot: (9.81 / cosine).sqrt() };
    let conical = Conical::from_state(&whole, 0.0, state);
    let square = 9.81 * (1.0 + 3.0 * cosine * cosine) / cosine;
    let [acceleration] = conical.acceleration(0.0, &[tilt + 0.1, 0.0], &[0.0]);
    assert!((acceleration + square * 0.1).abs() < 1e-4, "{acceleration}");
}

#[test]
fn single_precision_agrees_with_the_whole_system() {
    let whole = Single::default();
    let start = SingleState { theta: 1.0, phi: 0.0, theta_dot: 0.0, phi_dot: 2.0 };
    let turning = SingleTurning::from_state(&whole, 0.0, start);
    let run = |end: f32| whole.simulate(start).until(end).every(0.1).tolerance(1e-6).run().unwrap();
    let all = run(2.0);
    let own = turning.simulate(SingleTurningState::from(start)).until(2.0).every(0.1).tolerance(1e-6);
    let own = own.run().unwrap();
    for (found, expected) in [(own.theta(), all.theta()), (own.phi(), all.phi())] {
        let largest = found.iter().zip(expected).fold(0.0, |largest: f32, (a, b)| largest.max((a - b).abs()));
        assert!(largest < 1e-4, "{largest}");
    }
}

#[test]
fn products_are_those_of_any_system() {
    let whole = Spherical { push: 0.3, ..Spherical::<f64>::default() };
    let state = SphericalState { theta: 0.8, phi: 0.3, theta_dot: 0.4, phi_dot: 2.0 };
    let turning = Turning::from_state(&whole, 0.1, state);
    let y = <[f64; 3]>::from(TurningState::from(state));
    let (rates, narrow) = (turning.rhs(0.1, &y), turning.prepared().rhs(0.1, &y));
    close_to(&turning.lanes(|parameter| parameter).rhs(0.1, &y), &rates, 1e-14);
    close_to(&narrow, &rates, 1e-14);
    let jacobian = turning.jacobian(0.1, &y);
    for (column, step) in [(0, 1e-6), (1, 1e-6), (2, 1e-6)] {
        let at =
            |by: f64| turning.rhs(0.1, &std::array::from_fn(|i| y[i] + if i == column { by } else { 0.0 }));
        let [above, below] = [at(step), at(-step)];
        for row in 0..3 {
            assert!((jacobian[row][column] - (above[row] - below[row]) / (2.0 * step)).abs() < 1e-7);
        }
    }
    let run = || turning.simulate(y).until(1.0).tolerance(1e-12);
    let taylor = run().method(Taylor::tolerance(1e-12)).run().unwrap();
    close_to(&taylor.last(), &run().run().unwrap().last(), 1e-10);
    let power = turning.outputs(0.1, &[y[0], y[1]], &[y[2]]);
    assert_eq!(power.len(), whole.outputs(0.1, &state.coordinates(), &state.velocities()).len() - 1);
}

#[test]
fn there_is_no_motion_where_a_momentum_has_no_inertia() {
    let turning = Turning { phi_momentum: 0.0, ..Turning::<f64>::default() };
    assert!(turning.acceleration(0.0, &[0.0, 0.3], &[0.2])[0].is_nan());
    let turning = Turning { phi_momentum: 0.1, ..turning };
    assert!(!turning.acceleration(0.0, &[0.0, 0.3], &[0.2])[0].is_finite());
    let top = Nutating { phi_momentum: 2.0, psi_momentum: 2.0, ..Nutating::default() };
    assert!(top.acceleration(0.0, &[0.0; 3], &[0.1])[0].is_nan());
}
