lagrange::system! {
    #[derive(Clone)]
    struct Cart<S>;

    param m = 1.0;
    coord x, type;
    kinetic = 1/2 * m * (dot(x)^2 + dot(type)^2);
}

fn main() {
    let cart = Cart::<f32>::default().clone();
    let a: [f32; 2] = cart.acceleration(0.0, &[0.0; 2], &[0.0; 2]);
    let _ = cart.rhs(0.0, &[a[0]; 4]);
}
