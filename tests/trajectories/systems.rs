//! Systems that several modules integrate.

lagrange::system! {
    /// A point mass on a massless rod.
    #[derive(Clone, Debug)]
    pub(crate) struct Pendulum;

    param l = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * (l * dot(theta))^2;
    potential = -g * l * cos(theta);
}

lagrange::system! {
    /// A planet around a fixed sun, in Cartesian coordinates.
    #[derive(Clone, Debug)]
    pub(crate) struct Planet;

    param mu = 1.0;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = -mu / hypot(x, y);
}

lagrange::system! {
    /// A star in the potential of Hénon and Heiles.
    #[derive(Clone, Debug)]
    pub(crate) struct Star;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 1/2 * (x^2 + y^2) + x^2 * y - y^3 / 3;
}
