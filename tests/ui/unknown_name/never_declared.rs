lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * M * dot(theta)^2;
    potential = cos(2 * x) + sin(alpha);
    force y = 1;
}

fn main() {}
