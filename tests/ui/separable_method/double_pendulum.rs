//! A mass matrix that depends on the angles.

use lagrange::integrate::{StormerVerlet, integrate};

lagrange::system! {
    pub struct DoublePendulum;

    param g = 9.81;
    coord a, b;
    let (xa, ya) = (sin(a), -cos(a));
    let (xb, yb) = (xa + sin(b), ya - cos(b));
    kinetic = 1/2 * (dot(xa)^2 + dot(ya)^2 + dot(xb)^2 + dot(yb)^2);
    potential = g * (ya + yb);
}

fn main() {
    let method = StormerVerlet { step: 1e-3 };
    let _ = integrate(&DoublePendulum::default(), 0.0, [1.0, 2.0, 0.0, 0.0], 1.0, &method, |_, _| {});
}
