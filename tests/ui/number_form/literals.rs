lagrange::system! {
    struct Cart;

    param a = 2.0f64, b = 0xff, c = "1", d = 'x', e = 1e999999999, f = .5;
    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
