lagrange::system! {
    struct Wheel;

    param b = 1.0;
    coord x, y;
    lagrangian = 1/2 * dot(x)^2 + b * x * dot(y);
}

fn main() {}
