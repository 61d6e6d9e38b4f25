lagrange::system! {
    struct Cart;

    param type = 1.0, force, m = 1.0;
    coord x, loop;
    input in;
    let final = 2;
    kinetic = 1/2 * m * dot(x)^2 + type * dot(loop)^2;
    output body = x;
}

fn main() {}
