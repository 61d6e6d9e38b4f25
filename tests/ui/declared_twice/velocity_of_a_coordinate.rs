lagrange::system! {
    struct Cart;

    coord x, x_dot;
    kinetic = 1/2 * (dot(x)^2 + dot(x_dot)^2);
}

fn main() {}
