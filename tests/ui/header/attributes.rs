lagrange::system! {
    #[scalar(f16)]
    #[scalar]
    #![allow(unused)]
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    #[scalar(f32)]
    struct Both<S>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    # struct Pound;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    #[derive *]
    pub(crate crate) struct Malformed;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
