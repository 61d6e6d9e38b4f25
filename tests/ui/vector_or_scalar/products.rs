lagrange::system! {
    struct Point;

    coord x, y;
    let p = (x, y);
    kinetic = 1/2 * dot(p) * dot(p);
    potential = x / p;
}

fn main() {}
