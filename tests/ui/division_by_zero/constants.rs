lagrange::system! {
    struct Cart;

    const zero = 1 - 1;
    coord x;
    kinetic = 1/2 * dot(x)^2 / 0;
    potential = x / zero + x / (x - x) + 0^-1 + 1 / (2 * zero);
}

fn main() {}
