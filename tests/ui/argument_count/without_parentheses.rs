lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = cos x;
    potential = 2 * cos * x;
}

fn main() {}
