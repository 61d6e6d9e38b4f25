#![deny(warnings)]
#![allow(dead_code)]

/// A constant with the name of a parameter.
const M: f64 = 1.0;

lagrange::system! {
    struct Cart;

    param m = 1.0, damping = 0.1, M = 3.0, _kept = 1.0;
    coord x;
    input u;
    let speed = dot(x);
    const k = 4;
    kinetic = 1/2 * m * dot(x)^2;
}

lagrange::system! {
    #[allow(unused_variables)]
    struct Silent;

    param unused = 1.0;
    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
