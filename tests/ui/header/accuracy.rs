lagrange::system! {
    #[accuracy(fats)]
    struct Misspelt;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    #[accuracy(best)]
    struct Unlike;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    #[accuracy]
    struct Without;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    #[accuracy(fast, strict)]
    struct Both;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
