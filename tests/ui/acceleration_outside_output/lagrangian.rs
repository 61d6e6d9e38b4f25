lagrange::system! {
    struct Cart;

    coord x;
    lagrangian = 1/2 * dot(x)^2 - x * ddot(x);
}

fn main() {}
