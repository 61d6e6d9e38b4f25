lagrange::system! {
    struct Cart;

    param t = 1.0, pi = 3.0, _ = 1.0, __m = 2.0, r#move = 1.0;
    coord x, sin, norm;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
