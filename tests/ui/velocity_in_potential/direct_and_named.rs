lagrange::system! {
    struct Cart;

    param k = 1.0;
    coord x;
    let speed = dot(x);
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2 + k * x * dot(x);
    potential = k * speed;
}

fn main() {}
