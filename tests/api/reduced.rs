//! Reduced types: their equations against textbooks, and their conversions.

use crate::assert_close;
use lagrange::system::{EnergyFunction, MechanicalSystem, SeparableSystem};

lagrange::system! {
    /// A cart that carries a pendulum.
    #[derive(Clone, Debug, PartialEq)]
    pub struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, c = 0.02, g = 9.81;
    coord x, theta;
    input u;

    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;
    force x = u;
    output tip = (px, py);
    output lift = ddot(py);

    reduce Parked { freeze x = 2 * l; }
    reduce Hanging { small theta; }
    /// The cart with its pole nearly upright.
    reduce Upright { small theta = pi; }
    reduce Swinging { freeze x = 0; small theta; }
}

lagrange::system! {
    struct Pendulum;

    param mp = 0.1, l = 0.5, c = 0.02, g = 9.81;
    coord theta;
    let (px, py) = (l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;
}

lagrange::system! {
    struct Double<S>;

    param m = 0.7, l = 0.3, g = 9.81;
    coord a, b;
    let p = (l * sin(a), -l * cos(a));
    let q = p + (l * sin(b), -l * cos(b));
    kinetic = kinetic_energy(m, dot(p)) + kinetic_energy(m, dot(q));
    potential = gravitational_energy(m, g, p.y) + gravitational_energy(m, g, q.y);
    reduce Nearby { small a, b; }
    reduce Locked { freeze a = pi / 6; }
}

lagrange::system! {
    /// A symmetric top on its point: tilts a, b and spin.
    struct Top;

    param i1 = 0.12, i3 = 0.05, w = 2.7;
    coord a, b, spin;
    kinetic = 1/2 * i1 * (dot(a)^2 * cos(b)^2 + dot(b)^2) + 1/2 * i3 * (dot(spin) + dot(a) * sin(b))^2;
    potential = w * cos(a) * cos(b);
    emit { bias, jacobian, momentum_rates }
    reduce Sleeping { small a, b; }
}

lagrange::system! {
    #[scalar(f32)]
    #[accuracy(strict)]
    struct Drag;

    param c = 0.5;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    force -c * norm(dot((x, y))) * dot((x, y)) at (x, y);
    reduce Still { small x, y; }
    reduce Drifting { small y; }
}

/// Returns generic states, neither special nor small.
fn states() -> impl Iterator<Item = [f64; 2]> {
    (0..100).map(f64::from).map(|i| [(1.7 * i).sin() * 4.0, (2.3 * i + 0.4).cos() * 9.0])
}

#[test]
fn a_parked_cart_is_a_pendulum_to_the_last_bit() {
    let (parked, pendulum) = (Parked::from(&CartPole::default()), Pendulum::default());
    for [theta, theta_dot] in states() {
        let [found] = parked.acceleration(0.0, &[theta], &[theta_dot]);
        let [expected] = pendulum.acceleration(0.0, &[theta], &[theta_dot]);
        assert_eq!(found.to_bits(), expected.to_bits());
        let energies =
            [parked.energy(0.0, &[theta], &[theta_dot]), pendulum.energy(0.0, &[theta], &[theta_dot])];
        assert_eq!(energies[0].to_bits(), energies[1].to_bits());
    }
}

#[test]
fn small_swings_are_harmonic() {
    let swinging = Swinging { c: 0.0, ..Swinging::default() };
    for [theta, theta_dot] in states() {
        let [found] = swinging.acceleration(0.0, &[theta], &[theta_dot]);
        assert_close(found, -9.81 / 0.5 * theta);
        let energy = swinging.energy(0.0, &[theta], &[theta_dot]);
        let (square, rate) = (theta * theta, theta_dot * theta_dot);
        assert_close(energy, 0.1 * (0.125 * rate + 9.81 * 0.5 * (0.5 * square - 1.0)));
    }
}

/// (mc + mp) ẍ + mp l θ̈ = u and ẍ + l θ̈ = −g θ. Upright, measured by the tilt, θ̈ and g have the
/// opposite sign (Ogata, *Modern Control Engineering*, chapter 3).
#[test]
fn the_linearised_cart_is_that_of_the_textbook() {
    let cart = CartPole { u: 0.8, c: 0.0, ..CartPole::default() };
    let (hanging, upright) = (Hanging::from(&cart), Upright::from(&cart));
    let CartPole { mc, mp, l, g, u, .. } = cart;
    for [theta, theta_dot] in states() {
        let [x, pole] = hanging.acceleration(0.0, &[7.0, theta], &[-2.0, theta_dot]);
        assert_close(x, (u + mp * g * theta) / mc);
        assert_close(pole, -((mc + mp) * g * theta + u) / (mc * l));
        let tilt = theta - std::f64::consts::PI;
        let [x, pole] = upright.acceleration(0.0, &[7.0, theta], &[-2.0, theta_dot]);
        assert_close(x, (u + mp * g * tilt) / mc);
        assert_close(pole, ((mc + mp) * g * tilt + u) / (mc * l));
    }
}

#[test]
fn two_equal_pendulums_have_the_normal_modes_of_the_textbook() {
    let (near, root) = (Nearby::<f64>::default(), 2.0_f64.sqrt());
    let (m, l, g) = (near.m, near.l, near.g);
    let [[m00, m01], [m10, m11]] = near.mass_matrix(0.0, &[0.3, -0.2]);
    let inertia = m * l * l;
    for (found, expected) in [(m00, 2.0), (m01, 1.0), (m10, 1.0), (m11, 1.0)] {
        assert_close(found, expected * inertia);
    }
    for (shape, square) in [(root, 2.0 - root), (-root, 2.0 + root)] {
        let [a, b] = near.acceleration(0.0, &[1e-3, 1e-3 * shape], &[0.0, 0.0]);
        assert_close(a * 1e3, -square * g / l);
        assert_close(b * 1e3, -square * g / l * shape);
    }
}

/// C d/dt(ψ̇ + ȧ b) = 0, A ä + C d/dt(ψ̇ b) = w a, A b̈ − C ψ̇ ȧ = w b
#[test]
fn a_sleeping_top_keeps_its_gyroscopic_forces() {
    let top = Sleeping::default();
    let Sleeping { i1, i3, w } = top;
    for [r, s] in states() {
        let (q, v, a) = ([0.1 * r, 0.03 * s, 2.0], [0.2 * s, -0.4 * r, 50.0 + s], [r + s, r - s, 0.5 * s]);
        let expected = [
            i1 * a[0] + i3 * (a[2] * q[1] + v[2] * v[1]) - w * q[0],
            i1 * a[1] - i3 * v[2] * v[0] - w * q[1],
            i3 * (a[2] + a[0] * q[1] + v[0] * v[1]),
        ];
        let found = top.inverse_dynamics(0.0, &q, &v, &a);
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found - expected).abs() <= 1e-13 * (1.0 + s.abs() * v[2]), "{found} is not {expected}");
        }
    }
    // Upright with spin only: A ä = w a − C ψ̇ ḃ and A b̈ = w b + C ψ̇ ȧ.
    let jacobian = top.jacobian(0.0, &[0.0, 0.0, 0.0, 0.0, 0.0, 50.0]);
    for (row, column, expected) in [(3, 0, w), (4, 1, w), (3, 4, -i3 * 50.0), (4, 3, i3 * 50.0), (3, 1, 0.0)]
    {
        assert_close(jacobian[row][column], expected / i1);
    }
}

#[test]
fn quadratic_drag_vanishes_to_first_order_and_acts_on_what_drifts() {
    let still = Still { c: 0.5 };
    assert_eq!(still.acceleration(0.0, &[0.0, 0.0], &[3.0, 4.0]), [0.0, 0.0]);
    // F = −c |v| v with v = (ẋ, ε): −c ẋ (ẋ + ½ ε²/ẋ) and −c ẋ ε
    let [x, y] = Drifting { c: 0.5, ..Drifting::default() }.acceleration(0.0, &[0.0, 0.0], &[2.0, 0.1]);
    assert!((x + 0.5 * (4.0 + 0.005)).abs() < 1e-6 && (y + 0.1).abs() < 1e-6, "{x} {y}");
}

/// The difference decreases with the square of the amplitude, and faster if the whole system is
/// symmetric.
#[test]
fn reduced_accelerations_approach_those_of_the_whole_system() {
    let (double, near) = (Double::<f64>::default(), Nearby::<f64>::default());
    let difference = |amplitude: f64| {
        let (q, v) = ([amplitude, -0.7 * amplitude], [2.0 * amplitude, 3.0 * amplitude]);
        let (whole, reduced) = (double.acceleration(0.0, &q, &v), near.acceleration(0.0, &q, &v));
        (whole[0] - reduced[0]).hypot(whole[1] - reduced[1])
    };
    let order = (difference(1e-2) / difference(5e-3)).log2();
    assert!((order - 3.0).abs() < 0.01, "{order}");
}

#[test]
fn states_are_restricted_and_expanded_without_error() {
    let cart = CartPole { l: 0.3, ..CartPole::default() };
    let parked = Parked::from(&cart);
    assert_eq!(CartPole::from(&parked), cart);
    let state = CartPoleState { x: 9.0, theta: 0.1, x_dot: -1.0, theta_dot: 0.7 };
    let reduced = ParkedState::from(state);
    assert_eq!(reduced, ParkedState { theta: 0.1, theta_dot: 0.7 });
    let expanded = parked.expand(reduced);
    assert_eq!(expanded, CartPoleState { x: 0.6, x_dot: 0.0, ..state });
    assert_eq!(ParkedState::from(expanded), reduced);
    // Returns a type without frozen coordinates keeps them all.
    let upright = Upright::from(&cart);
    assert_eq!(upright.expand(UprightState::from(state)), state);
    let locked = Locked::<f64>::default().expand(LockedState { b: 1.0, b_dot: 2.0 });
    assert_eq!((locked.a, locked.a_dot, locked.b, locked.b_dot), (std::f64::consts::PI / 6.0, 0.0, 1.0, 2.0));
}

#[test]
fn a_deviation_is_what_a_reduced_state_loses_and_how_small_it_is() {
    let cart = CartPole::default();
    let state = CartPoleState { x: 1.5, theta: 3.0, x_dot: -1.0, theta_dot: 0.7 };
    let lost = Parked::from(&cart).deviation(state);
    assert_eq!(lost, CartPoleState { x: 0.5, theta: 0.0, x_dot: -1.0, theta_dot: 0.0 });
    let small = Upright::from(&cart).deviation(state);
    let tilt = 3.0 - std::f64::consts::PI;
    assert_eq!(small, CartPoleState { x: 0.0, theta: tilt, x_dot: 0.0, theta_dot: 0.7 });
    let parked = Parked::from(&cart);
    let nothing = parked.deviation(parked.expand(ParkedState { theta: 1.0, theta_dot: 2.0 }));
    assert_eq!(<[f64; 4]>::from(nothing), [0.0; 4]);
}

#[test]
fn outputs_stay_exact() {
    let (cart, hanging) = (CartPole::default(), Hanging::default());
    let (q, v) = ([0.2, 1.1], [0.5, -0.4]);
    assert_eq!(hanging.tip(0.0, &q, &v), cart.tip(0.0, &q, &v));
    assert_eq!(Parked::default().tip(0.0, &[1.1], &[0.0]), cart.tip(0.0, &[1.0, 1.1], &[0.0; 2]));
    // Expressions of accelerations take those of the reduced system.
    let [_, a] = hanging.acceleration(0.0, &q, &v);
    let lift = cart.l * (1.1_f64.sin() * a + 1.1_f64.cos() * 0.16);
    assert_close(hanging.lift(0.0, &q, &v), lift);
}

#[test]
fn reduced_types_are_systems_like_any_other() {
    fn describe<M: MechanicalSystem>(_: &M) -> &'static [&'static str] {
        M::COORDINATES
    }
    fn energy_at_rest<M: EnergyFunction<Scalar = f64, Coordinates = [f64; 1], Velocities = [f64; 1]>>(
        system: &M,
    ) -> f64 {
        system.energy(0.0, &[0.0], &[0.0])
    }
    fn is_separable<M: SeparableSystem>(_: &M) {}
    assert_eq!(describe(&Parked::default()), ["theta"]);
    assert_eq!(describe(&Sleeping::default()), ["a", "b", "spin"]);
    assert_close(energy_at_rest(&Swinging::default()), -0.1 * 9.81 * 0.5);
    is_separable(&Nearby::<f64>::default());
}
