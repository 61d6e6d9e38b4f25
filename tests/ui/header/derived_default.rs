lagrange::system! {
    #[derive(Clone, Default)]
    struct Cart;

    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}

fn main() {
    let _ = Cart::default().clone();
}
