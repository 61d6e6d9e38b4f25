lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    output rhs = x;
    output energy = 1/2 * dot(x)^2;
    output mass_matrix = 1;
    output EQUATIONS_LATEX = 1;
}

fn main() {
    let cart = Cart::default();
    let _ = (cart.energy(0.0, &[1.0], &[1.0]), cart.rhs(0.0, &[0.0; 2]));
}
