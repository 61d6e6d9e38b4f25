lagrange::system! {
    struct Cart;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = kinetic + self;
    output energy_rate = _;
}

fn main() {}
