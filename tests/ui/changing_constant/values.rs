lagrange::system! {
    struct Cart;

    param m = 1.0, k = 2 * m, d = sin(t);
    coord x;
    const c = 1 + x;
    input u = dot(x);
    kinetic = 1/2 * m * dot(x)^2;
}

fn main() {}
