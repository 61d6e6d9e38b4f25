lagrange::system! {
    struct Self;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    struct match;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
