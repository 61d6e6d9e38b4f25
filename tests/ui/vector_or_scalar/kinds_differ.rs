lagrange::system! {
    struct Point;

    coord x, y;
    let p = (x, y);
    let q = (x, y, 0);
    let (a, b, c) = p;
    let (d, e) = x;
    kinetic = kinetic_energy(1, dot(p));
    potential = inner(p, q) + inner(p + 1, p) + inner(q - p, q) + cross(p, q);
    force (1, 0, 0) at p;
    output side = if x < y { p } else { x };
}

fn main() {}
