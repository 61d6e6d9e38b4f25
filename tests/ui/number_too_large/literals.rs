lagrange::system! {
    #[scalar(f32)]
    struct Single;

    param m = 1e39, n = 1e20 * 1e20;
    coord x;
    kinetic = 1/2 * m * n * dot(x)^2;
}

lagrange::system! {
    struct Double;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1e400 * cos(x) + 1e309 * x;
}

lagrange::system! {
    struct Product;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1e300 * 1e300 * cos(x);
}

fn main() {}
