lagrange::system! {
    struct Wheel;

    table road(x) = "missing.csv", interpolation: natural, outside: error;
    table hill(x) = [(0, 1), (2, 5), (1, 2)], interpolation: natural, outside: extend;
    table motor(speed) = [(0, 90), (1000, 140)], interpolation: cubic, outside: clamp;
    table brake(speed) = [(0, 90, 1), (1000)], interpolation: linear, outside: clamp;
    coord x;
    kinetic = kinetic_energy(1, dot((x, road(x) + hill(x))));
    force x = motor(dot(x)) + brake(dot(x));
}

lagrange::system! {
    struct Bent;

    table hill(x) = [(0, 1), (2, 5), (3, 2)], interpolation: monotone, outside: extend;
    coord x;
    kinetic = kinetic_energy(1, dot((x, hill(x))));
}

fn main() {}
