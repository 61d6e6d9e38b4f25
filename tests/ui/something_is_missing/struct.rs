lagrange::system! {
    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}

fn main() {}
