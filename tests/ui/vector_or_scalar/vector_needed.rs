lagrange::system! {
    struct Point;

    coord x, y;
    let p = (x, y);
    kinetic = kinetic_energy(1, dot(p));
    potential = norm(x) + inner(p, x) + cross(y, p);
    force x at p;
    force p at x;
}

fn main() {}
