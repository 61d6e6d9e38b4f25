//! A pendulum, declared twice: in the coordinates x and y of its mass, which a constraint keeps on
//! a circle, and in an angle.
//!
//! Both describe the same motion. For a release from rest at x = l it is known in closed form
//! (Landau, Lifshitz, *Mechanics*, §11). The period is 4 K(1/√2) sqrt(l/g), and with m = l = 1 the
//! state at t = 100 s follows from Jacobi's elliptic functions. The multiplier of the constraint is
//! the force of the rod: −m (g cos θ + l θ̇²). It is 0 at the start and −3 m g at the bottom,
//! negative because the rod pulls inwards, against the gradient of the distance.
//!
//! Look for the errors after 42 swings, which are as small with the constraint as without.

mod common;

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use common::compare;
use lagrange::Simulate;
use lagrange::event::Direction;

lagrange::system! {
    /// A point mass on a circle.
    #[derive(Clone, Debug)]
    pub struct Bound;

    param m: kg = 1.0, l: m = 1.0, g: m/s^2 = 9.81;
    coord x: m, y: m;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint rod = hypot(x, y) - l;
}

lagrange::system! {
    /// The pendulum in terms of the angle from the lowest position.
    #[derive(Clone, Debug)]
    pub struct Pendulum;

    param m: kg = 1.0, l: m = 1.0, g: m/s^2 = 9.81;
    coord theta: rad;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = -m * g * l * cos(theta);
}

const END: f64 = 100.0;
/// Angle and its rate at the end.
const LAST: [f64; 2] = [0.182_525_148_495_773_56, -4.392_502_929_327_91];

fn main() -> Result<(), Box<dyn Error>> {
    let [x, y, x_dot, y_dot] =
        Bound::default().simulate([1.0, 0.0, 0.0, 0.0]).until(END).tolerance(1e-14).ends_only().run()?.last();
    let free =
        Pendulum::default().simulate([FRAC_PI_2, 0.0]).until(END).tolerance(1e-14).ends_only().run()?.last();
    let rows = [("theta", x.atan2(-y), LAST[0]), ("theta_dot", x * y_dot - y * x_dot, LAST[1])];
    compare("x and y with a constraint, t = 100 s", 1e-11, &rows);
    compare("an angle, t = 100 s", 1e-11, &[("theta", free[0], LAST[0]), ("theta_dot", free[1], LAST[1])]);
    compare("length of the rod", 1e-15, &[("l", x.hypot(y), 1.0), ("its rate", x * x_dot + y * y_dot, 0.0)]);
    rod_force()
}

/// Compares the force of the rod in the first swing.
fn rod_force() -> Result<(), Box<dyn Error>> {
    let pendulum = Bound::default();
    let swing = pendulum
        .simulate([1.0, 0.0, 0.0, 0.0])
        .until(1.0)
        .tolerance(1e-13)
        .event("bottom", Direction::Falling, |_, _, [x, ..]| *x)
        .run()?;
    let bottom = swing.events().first().ok_or("the pendulum never hangs down")?;
    let force = |t, state: [f64; 4]| {
        let state = BoundState::from(state);
        let [force] = pendulum.multipliers(t, &state.coordinates(), &state.velocities());
        force
    };
    let weight = pendulum.m * pendulum.g;
    let rows = [
        ("at the start", force(0.0, swing.first()), 0.0),
        ("at the bottom", force(bottom.time, bottom.state), -3.0 * weight),
        ("quarter period", bottom.time, 2.367_841_947_576_237_4 / 4.0),
    ];
    compare("force of the rod, N; time, s", 1e-11, &rows);
    Ok(())
}
