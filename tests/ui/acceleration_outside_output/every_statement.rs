lagrange::system! {
    struct Cart;

    coord x, y;
    let a = ddot(x);
    kinetic = 1/2 * dot(x)^2 + a^2;
    potential = ddot(x) * x;
    dissipation = 1/2 * ddot(x)^2;
    force x = 3 - 2 * a;
    force (1, ddot(y)) at (x, y);
    torque dot(dot(y)) on x;
}

fn main() {}
