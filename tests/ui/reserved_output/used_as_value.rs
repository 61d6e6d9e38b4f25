lagrange::system! {
    struct Cart;

    coord x;
    output reach = 2 * x;
    kinetic = 1/2 * dot(x)^2;
    potential = reach^2;
}

fn main() {}
