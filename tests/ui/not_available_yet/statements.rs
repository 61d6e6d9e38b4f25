lagrange::system! {
    struct Cart;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    body rod { mass: 1; inertia: 2; center: (x, y); angle: 0; }
    gravity = (0, -9.81);
    output height = y;
}

fn main() {}
