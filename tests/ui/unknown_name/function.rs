lagrange::system! {
    struct Pendulum;

    param m = 1.0, amplitude = 1.0;
    coord theta;
    kinetic = 1/2 * m * dot(theta)^2;
    potential = m * sine(theta) + bessel(theta) + m(theta + 1) + amplitude(2);
    potential = theta.tann();
}

fn main() {}
