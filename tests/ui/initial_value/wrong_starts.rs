lagrange::system! {
    struct Cart;

    param m = 1.0;
    input u;
    coord x = u, dot(x) = 1, y = 2;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    start dot(x) = 2 * t, y = 3;
    start m = 2;
}

fn main() {}
