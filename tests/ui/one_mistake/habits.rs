lagrange::system! {
    struct Typed;
    param m: f64 = 1.0, l: f64 = 2.0, g: f64 = 9.81;
    coord theta;
    kinetic = 1/2 * m * l^2 * dot(theta)^2;
    potential = -m * g * l * cos(theta);
}

lagrange::system! {
    struct PowerOfFunction;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = sin^2(theta);
}

lagrange::system! {
    struct WithUnits;
    param m = 2.0 kilograms;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}

lagrange::system! {
    struct OfRust;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = std::f64::consts::PI * x;
}

lagrange::system! {
    struct Letters;
    coord x;
    T = 1/2 * dot(x)^2;
}

fn main() {}
