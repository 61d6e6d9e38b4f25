//! Inertias that change as states do.

use lagrange::Simulate;
use lagrange::laws;
use lagrange::system::LagrangianSystem;

lagrange::system! {
    /// A rocket that climbs from the ground; gas leaves it with the velocity −c relative to it.
    struct Rocket;
    param g: m/s^2 = 9.81, c: m/s = 2500, empty: kg = 20;
    input throttle: kg/s = 0.5;
    coord z: m;
    state fuel: kg = 40;
    dot(fuel) = -throttle;
    kinetic = 1/2 * (empty + fuel) * dot(z)^2;
    potential = (empty + fuel) * g * z;
    force z = dot(fuel) * (dot(z) - c);
    emit { power, jacobian, taylor, lanes, tests }
}

lagrange::system! {
    /// A load on a rope of changing length below a cart; the load leaks as it swings.
    struct Crane;
    param g = 9.81, m = 2.0, leak = 0.1;
    coord x, theta;
    state load = 1.0, length = 2.0;
    dot(load) = -leak * (1 + sin(dot(theta)));
    dot(length) = 0.3 * cos(t) - 0.01 * length;
    let (px, py) = (x + length * sin(theta), -length * cos(theta));
    kinetic = 1/2 * m * dot(x)^2 + 1/2 * load * (dot(px)^2 + dot(py)^2);
    potential = load * g * py + 3 * x^2;
    emit { inverse_dynamics, power, jacobian, taylor, tests }
}

lagrange::system! {
    /// A top whose moments and product of inertia change with its motion.
    struct Top;
    param h = 0.7;
    quaternion r;
    state fuel = 1.0;
    dot(fuel) = -0.2 * fuel * (1 + r_wx^2);
    kinetic = 1/2 * (1 + fuel) * (r_wx^2 + r_wy^2) + 1/2 * (0.4 + fuel^2) * r_wz^2 + fuel * r_wx * r_wz / 5;
    potential = h * fuel * (1 - 2 * (r_qx^2 + r_qy^2));
    emit { inverse_dynamics, power, jacobian, tests }
}

lagrange::system! {
    /// Momenta of every degree: a bead on a ring whose inertia changes.
    struct Bead;
    param g = 9.81;
    coord x = 2, y;
    state m = 1.0;
    dot(m) = -0.1 * m * dot(x);
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + sin(m) * dot(x) * dot(y) / 5 + m^2 * dot(x) + (1 + x^2 * m) * dot(y)^2;
    potential = m * g * y;
    constraint ring = x^2 + y^2 - 4;
    emit { power, tests }
}

lagrange::system! {
    /// A mass that solves an equation with a state.
    struct Sponge;
    coord x;
    state wet = 1.0;
    dot(wet) = x - wet * dot(x);
    solve y: 0 = y + y^3 - wet;
    kinetic = 1/2 * (2 + y) * dot(x)^2;
    potential = 3 * x^2 + y;
    emit { power, tests, jacobian }
}

lagrange::system! {
    /// A central force on a mass that evaporates.
    struct Comet;
    coord r = 1.3, phi;
    state m = 0.8;
    dot(m) = -0.1 * m * cos(r);
    kinetic = 1/2 * m * (dot(r)^2 + (r * dot(phi))^2);
    potential = m * r^2;
    emit { power, tests }
    reduce Radial { ignore phi; }
}

fn close_to(found: &[f64], wanted: &[f64], tolerance: f64) {
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found - wanted).abs() <= tolerance * wanted.abs().max(1.0), "{found} {wanted}");
    }
}

#[test]
fn a_rocket_follows_tsiolkovsky() {
    let rocket = Rocket::default();
    let start = RocketState { z: 0.0, fuel: 40.0, z_dot: 0.0 };
    let (t, c) = (40.0, 2500.0);
    // z = c t − c (m/ṁ) ln(m₀/m) − g t²/2 with the final mass m.
    let ratio = 60.0_f64 / 40.0;
    let wanted = [c * (t - 40.0 / 0.5 * ratio.ln()) - 4.905 * t * t, 20.0, c * ratio.ln() - 9.81 * t];
    let by_pair = rocket.simulate(start).until(t).tolerance(1e-12).run().expect("climbs");
    let series = lagrange::integrate::Taylor::tolerance(1e-12);
    let by_series = rocket.simulate(start).until(t).method(series).run().expect("climbs");
    close_to(&by_pair.last(), &wanted, 1e-11);
    close_to(&by_series.last(), &wanted, 1e-11);
}

/// Checks the laws at a state that is not the start.
fn check<M: LagrangianSystem<Scalar = f64>>(system: &M, y: &M::State) {
    let report = laws::check(system, 0.4, y);
    assert!(report.holds(), "{report}");
}

#[test]
fn momenta_change_with_their_inertia() {
    check(&Rocket::default(), &[3.0, 30.0, 7.0]);
    check(&Crane::default(), &[0.3, 0.7, 0.9, 2.1, 0.4, -0.6]);
    check(&Top::default(), &[0.5, 0.1, -0.7, 0.5, 1.2, 0.4, -0.3, 0.9]);
    check(&Sponge, &[0.4, 0.7, -0.3]);
    check(&Bead::default(), &[1.2, -1.6, 0.8, 0.4, 0.3]);
}

#[test]
fn the_momentum_of_an_ignored_angle_is_conserved() {
    let comet = Comet;
    let start = CometState { r: 1.3, phi: 0.2, m: 0.8, r_dot: 0.3, phi_dot: 0.9 };
    let whole = comet.simulate(start).until(3.0).tolerance(1e-12).run().expect("moves");
    let radial = Radial::from_state(&comet, 0.0, start);
    let reduced = radial.simulate(RadialState::from(start)).until(3.0).tolerance(1e-12).run().expect("moves");
    let found: [f64; 5] = radial.expand(3.0, reduced.last().into()).into();
    close_to(&found, &whole.last(), 1e-10);
    let end = CometState::from(whole.last());
    assert!((end.m * end.r * end.r * end.phi_dot - 0.8 * 1.3 * 1.3 * 0.9).abs() < 1e-10);
}
