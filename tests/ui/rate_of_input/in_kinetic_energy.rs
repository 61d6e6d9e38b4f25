lagrange::system! {
    struct Crane;

    param m = 1.0;
    input length;
    coord theta;
    kinetic = 1/2 * m * (length * dot(theta))^2;
}

fn main() {}
