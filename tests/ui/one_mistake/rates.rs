lagrange::system! {
    struct Quotient;
    coord theta;
    kinetic = 1/2 * d/dt(theta)^2;
}

lagrange::system! {
    struct Abbreviated;
    coord theta;
    kinetic = 1/2 * thetadot^2;
}

lagrange::system! {
    struct OfAParameter;
    param m = 1.0;
    coord theta;
    kinetic = 1/2 * dot(m) * dot(theta)^2;
}

lagrange::system! {
    struct OfACall;
    coord theta;
    kinetic = 1/2 * diff(theta, t)^2;
}

fn main() {}
