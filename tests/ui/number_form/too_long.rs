lagrange::system! {
    struct Growth;

    coord x;
    const a = 1/7 + 1e4000;
    const b = a * a;
    kinetic = dot(x)^2;
    potential = b * b * x;
}

fn main() {}
