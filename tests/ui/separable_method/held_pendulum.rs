//! A composition of several drifts would leave the constraint in between.

use lagrange::integrate::{BlanesMoan4, StormerVerlet, integrate};

lagrange::system! {
    pub struct Held;

    param l = 1.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint rod = x^2 + y^2 - l^2;
}

fn main() {
    let (held, start) = (Held::default(), [1.0, 0.0, 0.0, 0.0]);
    let _ = integrate(&held, 0.0, start, 1.0, &StormerVerlet { step: 1e-3 }, |_, _| {});
    let _ = integrate(&held, 0.0, start, 1.0, &BlanesMoan4 { step: 1e-3 }, |_, _| {});
}
