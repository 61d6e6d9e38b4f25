lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    emit { momentum_rates, no momenta, no mass_matrix }
}

fn main() {}
