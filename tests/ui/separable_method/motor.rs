//! A first-order state beside the coordinates.

use lagrange::integrate::{StormerVerlet, integrate};

lagrange::system! {
    pub struct Motor;

    param r = 1.5;
    coord theta;
    state current;
    kinetic = 1/2 * dot(theta)^2;
    force theta = current;
    dot(current) = -r * current;
}

fn main() {
    let method = StormerVerlet { step: 1e-3 };
    let _ = integrate(&Motor::default(), 0.0, [1.0, 2.0, 0.0], 1.0, &method, |_, _| {});
}
