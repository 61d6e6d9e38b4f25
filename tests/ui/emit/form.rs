lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    emit bias;
    emit { bias latex }
    emit { 1 }
}

fn main() {}
