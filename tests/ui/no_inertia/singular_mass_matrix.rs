lagrange::system! {
    struct Pair;

    param m = 1.0;
    coord x, y;
    kinetic = 1/2 * m * (dot(x) + dot(y))^2;
}

fn main() {}
