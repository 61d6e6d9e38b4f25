lagrange::system! {
    #[derive(Clone, PartialEq, Eq, Hash)]
    struct Exact;
    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}

lagrange::system! {
    struct Singular;
    param m = 1.0;
    coord x, y;
    kinetic = 1/2 * m * (dot(x) + dot(y))^2;
}

fn main() {
    let _ = Exact::default() == Exact::default();
}
