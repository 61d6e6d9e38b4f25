lagrange::system! {
    struct Cart;

    coord x;
    lagrangian = 1/2 * dot(x)^2 - x^2;
    emit { kinetic_energy, potential_energy }
}

fn main() {}
