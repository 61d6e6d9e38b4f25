lagrange::system! {
    struct Cart;

    coord x;
    lagrangian = 1/2 * dot(x)^2;
    kinetic = 1/2 * dot(x)^2;
    potential = x^2;
}

fn main() {}
