lagrange::system! {
    #[scalar(f32)]
    #[scalar(f64)]
    #[accuracy(standard)]
    #[accuracy(fast)]
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
