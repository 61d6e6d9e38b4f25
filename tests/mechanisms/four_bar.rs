//! A crank, a coupler and a rocker.

lagrange::system! {
    /// Four bars, one of which is the ground: uniform, 10 kg/m, with gravity downwards. Angles are
    /// measured from the line between the two fixed joints.
    #[derive(Clone, Debug)]
    pub(crate) struct FourBar;

    param a: m = 0.1, b: m = 0.3, c: m = 0.3, d: m = 0.4;
    param m1: kg = 1.0, m2: kg = 3.0, m3: kg = 3.0, g: m/s^2 = 9.81;
    coord crank: rad, coupler: rad, rocker: rad;

    let (x1, y1) = (a * cos(crank), a * sin(crank));
    let (x2, y2) = (x1 + b/2 * cos(coupler), y1 + b/2 * sin(coupler));
    kinetic = 1/6 * m1 * a^2 * dot(crank)^2;
    kinetic = 1/2 * m2 * (dot(x2)^2 + dot(y2)^2) + 1/24 * m2 * b^2 * dot(coupler)^2;
    kinetic = 1/6 * m3 * c^2 * dot(rocker)^2;
    potential = m1 * g * y1 / 2 + m2 * g * y2 + m3 * g * c/2 * sin(rocker);
    constraint closed_x = x1 + b * cos(coupler) - c * cos(rocker) - d;
    constraint closed_y = y1 + b * sin(coupler) - c * sin(rocker);
    emit { momentum_rates }
}

/// The crank on the line of the fixed joints at 30 rad/s, where coupler and rocker form an
/// equilateral triangle.
pub(crate) const START: [f64; 6] =
    [0.0, std::f64::consts::FRAC_PI_3, 2.0 * std::f64::consts::FRAC_PI_3, 30.0, -10.0, -10.0];
