lagrange::system! {
    struct Cart;

    param m = ;
    const k;
    coord x = ;
    let = 3;
    kinetic 1/2 * dot(x)^2;
    potential == x^2;
    output 2 = x;
}

fn main() {}
