lagrange::system! {
    struct Point;

    coord x, y;
    let p = (x, y);
    kinetic = kinetic_energy(1, dot(p));
    potential = p.z + p.w + x.x;
}

fn main() {}
