fn height(x: f64) -> f64 {
    x * x
}

fn height_derivative(x: f64) -> f64 {
    2.0 * x
}

lagrange::system! {
    struct Slope;

    function slope(x);
    coord x;
    kinetic = kinetic_energy(1, dot(x));
    force x = slope(x);
}

lagrange::system! {
    struct Bead;

    function height(x);
    coord x;
    kinetic = kinetic_energy(1, dot((x, height(x))));
}

fn main() {}
