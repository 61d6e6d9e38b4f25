lagrange::system! {
    struct Spring;

    kinetic = 1/2 * mass * dot(elongation)^2;
    param mass = 1.0;
    force elongation = 1 - k;
    let k = k * 2;
    coord elongation;
}

fn main() {}
