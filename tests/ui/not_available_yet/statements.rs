lagrange::system! {
    struct Cart;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x^2 + y^2 - 1;
    event hit = x, falling => impact(0.8);
    body rod { mass: 1; inertia: 2; center: (x, y); angle: 0; }
    gravity = (0, -9.81);
    output pull = wall;
}

fn main() {}
