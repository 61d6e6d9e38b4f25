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

lagrange::system! {
    /// Two equal point masses on massless rods, with absolute angles.
    #[derive(Clone, Debug)]
    pub(crate) struct DoublePendulum;

    param m = 1.0, l = 1.0, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l * sin(theta1), -l * cos(theta1));
    let (x2, y2) = (x1 + l * sin(theta2), y1 - l * cos(theta2));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2);
    potential = m * g * (y1 + y2);
}

lagrange::system! {
    /// A symmetric top with a fixed point, in Euler angles.
    #[derive(Clone, Debug)]
    pub(crate) struct Top;

    param i1 = 1.0, i3 = 0.5, mgl = 1.0;
    coord phi, theta, psi;
    kinetic = 1/2 * i1 * (dot(theta)^2 + (dot(phi) * sin(theta))^2) + 1/2 * i3 * (dot(psi) + dot(phi) * cos(theta))^2;
    potential = mgl * cos(theta);
}
