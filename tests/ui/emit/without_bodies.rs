lagrange::system! {
    struct Pendulum;

    param m = 1.0, l = 2.0, g = 9.81;
    coord theta;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = -m * g * l * cos(theta);
    emit { motion, drawing }
}

fn main() {}
