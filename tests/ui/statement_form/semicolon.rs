lagrange::system! {
    struct Cart;

    param m = 1.0
    coord x
    kinetic = 1/2 * m * dot(x)^2
    potential = m * x
}

fn main() {}
