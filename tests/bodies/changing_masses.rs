//! Declared bodies whose mass and inertia change.

use lagrange::Simulate;
use lagrange::laws;
use lagrange::system::LagrangianSystem;

lagrange::system! {
    /// A rocket in the plane, with the thrust of its exhaust.
    struct Rocket;
    param g: m/s^2 = 9.81, c: m/s = 2500, empty: kg = 20;
    input throttle: kg/s = 0.5;
    gravity = (0, -g);
    coord x: m, z: m;
    state fuel: kg = 40;
    dot(fuel) = -throttle;
    body hull { mass: empty + fuel; center: (x, z); }
    force z = throttle * c;
    emit { power, jacobian, motion, momentum_rates, inverse_dynamics, tests }
}

lagrange::system! {
    /// A rocket in space that turns about its axis; thrust acts along it.
    struct Spinner;
    param g = 9.81, c = 2500, empty = 20;
    gravity = (0, 0, -g);
    state fuel = 40;
    dot(fuel) = -0.5;
    body hull { mass: empty + fuel; inertia: (2 + fuel, 2 + fuel, 1 + fuel/2); }
    free hull;
    force hull.vector(0, 0, 0.5 * c) at hull;
    emit { power, motion, momentum_rates, inverse_dynamics, centroidal_momentum, tests }
}

lagrange::system! {
    /// A wheel that wears off under a constant torque.
    struct Wheel;
    param r = 0.5, torque_on = 2;
    coord x, y, phi;
    body wheel { mass: 3 - 0.1 * t; center: (x, y); angle: phi; shape: disk(r); }
    torque torque_on on wheel;
    emit { power, tests }
}

lagrange::system! {
    /// A cart under a constant force that loses sand through its floor and drops a crate.
    struct Cart;
    param push = 6;
    coord x;
    state sand = 8;
    discrete crate_mass = 2;
    dot(sand) = -0.5;
    body cart { mass: 1 + crate_mass + sand; center: (x, 0); }
    force x = push;
    every 1.0 => { crate_mass = if t > 0.5 { 0 } else { crate_mass }; }
    emit { power, centroidal_momentum, tests }
}

macro_rules! arm {
    ($Name:ident, $($sand:tt)*) => {
        lagrange::system! {
            /// A ball on an arm of three links, the second of which leaks.
            struct $Name;
            param g = 9.81;
            gravity = (0, 0, -g);
            $($sand)*
            body upper { mass: 3; inertia: (0.02, 0.25, 0.25); centroid: (0.5, 0, 0); }
            revolute a = ground to upper { axis: (0, 1, 0); }
            body lower { mass: 1 + sand; inertia: (0.02, 0.1 + sand/10, 0.1 + sand/10, 0, 0.01, 0); centroid: (0.5, 0, 0.1); }
            ball b = upper to lower { at: (1, 0, 0); }
            body tip { mass: 0.5; shape: solid_sphere(0.1); }
            revolute d = lower to tip { at: (1, 0, 0); axis: (0, 1, 0); }
            emit { power, tests }
        }
    };
}

arm!(Leaking, state sand = 2; dot(sand) = -0.1 * sand * (1 + t^2););
arm!(Closed, param sand = 2;);

lagrange::system! {
    /// A shaft by Euler angles, by hand, that loses a wheel's rim.
    struct Shaft;
    coord x, y, z, a, b, c;
    state rim = 1;
    dot(rim) = -0.2 * rim;
    body shaft {
        mass: 2 + rim; inertia: (0.3 + rim, 0.2 + rim, 0.4 + 2 * rim); centroid: (0, 0, 0.3);
        origin: (x, y, z); angles: (a, b, c); sequence: zxz;
    }
    emit { power, tests }
}

fn close_to(found: &[f64], wanted: &[f64], tolerance: f64) {
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance * wanted.abs().max(1.0), "{found} {wanted}");
    }
}

/// Checks the laws, including the balance of power, at a state that is not the start.
fn check<M: LagrangianSystem<Scalar = f64>>(system: &M, y: &M::State) {
    let report = laws::check(system, 0.4, y);
    assert!(report.holds(), "{report}");
}

/// Returns height and velocity of a rocket by Tsiolkovsky's formula.
fn tsiolkovsky(t: f64) -> [f64; 2] {
    let (c, ratio) = (2500.0, 60.0 / (60.0 - 0.5 * t));
    let height = c * (t - (60.0 - 0.5 * t) / 0.5 * f64::ln(ratio)) - 4.905 * t * t;
    [height, c * ratio.ln() - 9.81 * t]
}

#[test]
fn rockets_follow_tsiolkovsky() {
    let [height, speed] = tsiolkovsky(40.0);
    let start = RocketState { x: 0.0, z: 0.0, fuel: 40.0, x_dot: 3.0, z_dot: 0.0 };
    let run = Rocket::default().simulate(start).until(40.0).tolerance(1e-12).run().expect("climbs");
    // What leaves has the horizontal velocity of the hull, which stays the same.
    close_to(&run.last(), &[120.0, height, 20.0, 3.0, speed], 1e-11);

    let spinner = Spinner::default();
    let turning = SpinnerState { hull_wz: 0.7, ..spinner.start() };
    let run = spinner.simulate(turning).until(40.0).tolerance(1e-12).run().expect("climbs");
    let end = SpinnerState::from(run.last());
    close_to(&[end.hull_z, end.hull_vz, end.hull_wz], &[height, speed, 0.7], 1e-11);
}

#[test]
fn a_wheel_that_wears_off_accelerates_by_its_inertia_at_each_instant() {
    let wheel = Wheel::default();
    let start = WheelState { x: 0.0, y: 0.0, phi: 0.0, x_dot: 2.0, y_dot: 0.0, phi_dot: 1.5 };
    let run = wheel.simulate(start).until(20.0).tolerance(1e-12).run().expect("turns");
    let end = WheelState::from(run.last());
    // J = (3 − t/10) r²/2, so that ω = ω₀ + (M/k) ln(J₀/J) with k = r²/20.
    let spin = 1.5 + 2.0 / (0.25 / 20.0) * f64::ln(3.0);
    close_to(&[end.phi_dot, end.x_dot, end.x], &[spin, 2.0, 40.0], 1e-10);
}

#[test]
fn a_cart_keeps_its_velocity_as_it_loses_mass() {
    let cart = Cart::default();
    let run = cart.simulate(cart.start()).until(2.0).tolerance(1e-12).run().expect("moves");
    // v = (F/k) ln(m₀/m) with k = 1/2, before and after the crate of 2 kg drops.
    let speed = 12.0 * (f64::ln(11.0 / 10.5) + f64::ln(8.5 / 8.0));
    let end = CartState::from(run.last());
    close_to(&[end.x_dot, end.crate_mass, end.sand], &[speed, 0.0, 7.0], 1e-11);
    let y = [end.x, end.sand, end.crate_mass];
    let [_, along, _] = cart.centroidal_momentum(2.0, &y, &[end.x_dot]);
    close_to(&[along], &[8.0 * speed], 1e-11);
}

#[test]
fn a_leaking_arm_accelerates_like_a_closed_one_of_its_mass() {
    let (q, v) = ([0.3, 0.5, 0.1, -0.7, 0.5, -0.4], [0.6, -0.8, 0.5, 0.3, 1.1]);
    let closed = Closed { sand: 1.7, ..Closed::default() };
    let wanted = closed.acceleration(0.0, &q, &v);
    let [a, qw, qx, qy, qz, d] = q;
    let found = Leaking::default().acceleration(0.0, &[a, qw, qx, qy, qz, d, 1.7], &v);
    close_to(&found, &wanted, 1e-11);
}

#[test]
fn power_and_momenta_balance() {
    check(&Rocket::default(), &[3.0, 5.0, 30.0, 7.0, -2.0]);
    let pose = [0.1, 0.2, 0.3, 0.5, 0.1, -0.7, 0.5];
    let mut y = [0.0; 14];
    y[..7].copy_from_slice(&pose);
    y[7..].copy_from_slice(&[25.0, 0.3, 0.4, -0.3, 0.9, 1.2, -0.5]);
    check(&Spinner::default(), &y);
    check(&Wheel::default(), &[0.3, 0.7, 0.9, 2.1, 0.4, -0.6]);
    check(&Cart::default(), &[0.3, 5.0, 2.0, 0.7]);
    check(&Leaking::default(), &[0.3, 0.5, 0.1, -0.7, 0.5, -0.4, 1.7, 0.6, -0.8, 0.5, 0.3, 1.1]);
    check(&Shaft, &[0.1, 0.2, 0.3, 0.4, 0.9, 0.5, 0.8, 1.1, -0.4, 0.6, 0.2, 0.9, -1.3]);
}
