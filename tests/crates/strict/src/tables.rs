//! Functions of the crate and tables.

/// Returns the force of a rubber spring.
fn rubber(x: f64) -> f64 {
    x.mul_add(x * x, x)
}

/// Returns its stiffness.
fn stiffness(x: f64) -> f64 {
    (3.0 * x).mul_add(x, 1.0)
}

lagrange::system! {
    /// A wheel with a rubber tyre on a road, driven by a motor.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Driven;

    function rubber(x) { derivative: stiffness; }
    table road(s) = [(0, 3.14159), (3, 2.71828), (8, 0.1), (14, -0.2), (20, 0)], interpolation: natural, outside: extend;
    table Motor(v) = [(0, 1), (1, 3), (2, 2)], interpolation: monotone, outside: error;
    table map(x, v) = [(0, 0, 1), (0, 2, 1.5), (1, 0, 3), (1, 2, 2)], interpolation: linear, outside: clamp;
    param m = 1.5;
    coord x, s;
    kinetic = kinetic_energy(m, dot((s, road(s) + x)));
    potential = road(s);
    force x = -rubber(x);
    force s = Motor(dot(s)) + map(s, dot(x));
    emit { jacobian }
}
