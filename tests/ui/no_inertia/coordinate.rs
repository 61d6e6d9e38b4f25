lagrange::system! {
    struct Cart;

    param m = 1.0;
    coord x, y, z;
    kinetic = 1/2 * m * dot(x)^2 + y;
    potential = z^2;
}

fn main() {}
