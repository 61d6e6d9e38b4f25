fn lift(alpha: f64, speed: f64) -> f64 {
    speed * alpha
}

fn stretch(x: f64) -> f64 {
    x * x
}

fn force(x: f64) -> f64 {
    2.0 * x
}

lagrange::system! {
    struct Spring;

    function stretch(x) { derivative: force; }
    coord x;
    kinetic = kinetic_energy(1, dot(x));
    potential = stretch(x);
    emit { jacobian }
}

lagrange::system! {
    struct Wing;

    function lift(alpha, speed) { by alpha: force; }
    function lost(x);
    coord x;
    kinetic = kinetic_energy(1, dot(x));
    potential = lift(x, x);
}

lagrange::system! {
    struct Wrong;

    function lift(alpha, speed) { derivative: force; by gamma: force; slope: force; by alpha: force }
    function stretch(x, x);
    function sin(x);
    function force x;
    coord x;
    kinetic = kinetic_energy(1, dot(x));
    potential = lift(x) + lift(x, (x, x)) + lift;
}

fn main() {}
