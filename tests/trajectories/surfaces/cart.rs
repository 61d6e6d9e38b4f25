//! A cart with two driven wheels and a caster, which drives a curve.

use lagrange::Simulate;
use lagrange::contact::{Contact, Friction, Stepped};

use crate::assert_near;

lagrange::system! {
    /// A cart on the rims of two wheels and a smooth ball behind them. Its centre of mass is
    /// between the wheels.
    #[derive(Clone, Debug)]
    struct Cart;

    param left_torque = 0.2, right_torque = 0.4;
    gravity = (0, 0, -9.81);
    body chassis { mass: 10; inertia: (0.1, 0.3, 0.35); }
    free chassis;
    body left_wheel { mass: 1; inertia: (0.0026, 0.005, 0.0026); }
    revolute left = chassis to left_wheel { at: (0, 0.2, 0); axis: (0, 1, 0); }
    body right_wheel { mass: 1; inertia: (0.0026, 0.005, 0.0026); }
    revolute right = chassis to right_wheel { at: (0, -0.2, 0); axis: (0, 1, 0); }
    force left = left_torque;
    force right = right_torque;
    contact left_tyre = left_wheel.point(0, 0, 0) on ground { rim: 0.1; axis: (0, 1, 0); friction: 0.8; }
    contact right_tyre = right_wheel.point(0, 0, 0) on ground { rim: 0.1; axis: (0, 1, 0); friction: 0.8; }
    contact caster = chassis.point(-0.3, 0, -0.08) on ground { radius: 0.02; }
}

const UNTIL: f64 = 2.0;

/// Returns place, heading and wheel angles of a cart that does not slip. The speed a t and the
/// angular velocity α t follow from linear and angular momentum. The curve is a circle of radius
/// a/α, since its length and its angle both grow as t².
fn rolled(t: f64, [left, right]: [f64; 2]) -> [f64; 5] {
    let (r, b, j) = (0.1, 0.2, 0.005);
    let a = (left + right) / r / (12.0 + 2.0 * j / (r * r));
    let turning = 0.35 + 2.0 * 0.0026 + 2.0 * b * b * (1.0 + j / (r * r));
    let alpha = b * (right - left) / r / turning;
    let (angle, way) = (0.5 * alpha * t * t, 0.5 * a * t * t);
    let radius = a / alpha;
    [radius * angle.sin(), radius * (1.0 - angle.cos()), angle, (way - b * angle) / r, (way + b * angle) / r]
}

/// Returns the same numbers of a state.
fn pose(state: &[f64; 17]) -> [f64; 5] {
    [state[0], state[1], 2.0 * state[6].atan2(state[3]), state[7], state[8]]
}

fn start() -> [f64; 17] {
    let mut start = [0.0; 17];
    (start[2], start[3]) = (0.1, 1.0);
    start
}

/// Neither wheel slips, all of the torques' work is in the energy, and the caster carries the
/// moment that accelerates the cart.
#[test]
fn a_cart_drives_a_curve() {
    let cart = Cart::default();
    let run = cart.simulate(start()).until(UNTIL).tolerance(1e-11).energy().run().expect("drives");
    assert_near(&pose(&run.last()), &rolled(UNTIL, [0.2, 0.4]), 1e-8);
    let end = run.system_at_end().expect("all touch");
    assert_eq!([end.left_tyre, end.right_tyre, end.caster], [Contact::Closed; 3]);
    assert_eq!([end.left_tyre_friction, end.right_tyre_friction], [Friction::Sticks; 2]);
    let (energy, last) = (run.column("energy").expect("asked for"), run.last());
    let work = 0.2 * last[7] + 0.4 * last[8];
    assert_near(&[energy[energy.len() - 1] - energy[0]], &[work], 1e-8);
}

/// The error of steps is of first order.
#[test]
fn a_cart_drives_a_curve_in_steps() {
    let errors = [4e-3, 2e-3, 1e-3].map(|step| {
        let run = Cart::default().simulate(start()).until(UNTIL).method(Stepped::every(step)).run();
        let (found, wanted) = (pose(&run.expect("drives").last()), rolled(UNTIL, [0.2, 0.4]));
        found.iter().zip(wanted).fold(0.0, |most: f64, (found, wanted)| most.max((found - wanted).abs()))
    });
    println!("a cart in steps: {errors:?}");
    assert!(
        errors[2] < 0.02 && errors.windows(2).all(|pair| (pair[0] / pair[1] - 2.0).abs() < 0.2),
        "{errors:?}"
    );
}
