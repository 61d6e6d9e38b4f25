lagrange::system! {
    struct Cart;

    param k = 1.0;
    coord x, theta;
    let p = (x, 0);
    kinetic = 1/2 * (dot(x)^2 + dot(theta)^2);
    force k = 1;
    force p = (1, 0);
    force X = 1;
}

fn main() {}
