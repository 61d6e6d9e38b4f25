lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    force (1, 0);
    force x;
    force (1, 0) = x;
    torque 1;
    torque 1 at x;
}

fn main() {}
