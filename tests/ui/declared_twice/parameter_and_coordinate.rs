lagrange::system! {
    struct Cart;

    param m = 1.0, x = 2.0;
    coord x, y, y;
    input m;
    let k = 3;
    const k = 4;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    output k = 1;
    output speed = dot(x);
    output speed = dot(y);
}

fn main() {}
