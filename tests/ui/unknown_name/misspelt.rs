lagrange::system! {
    struct Pendulum;

    param mass = 1.0, length = 1.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * mas * (length * dot(theta))^2;
    potential = -mass * g * lenght * cos(thetta);
    force tetha = -g;
}

fn main() {}
