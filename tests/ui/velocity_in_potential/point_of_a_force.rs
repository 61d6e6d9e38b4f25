lagrange::system! {
    struct Cart;

    coord x, y;
    let p = (x, dot(y));
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    force (1, 0) at p;
    torque 1 on x + dot(y);
}

fn main() {}
