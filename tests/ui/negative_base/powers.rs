lagrange::system! {
    struct Cart;

    const c = -8;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = (-8)^(1/3) + (-2)^x + c^0.5 + pow(-1, x);
}

fn main() {}
