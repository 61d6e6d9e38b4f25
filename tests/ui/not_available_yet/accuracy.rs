lagrange::system! {
    #[accuracy(fast)]
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    #[accuracy(strict)]
    struct Pole;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
