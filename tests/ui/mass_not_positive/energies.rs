lagrange::system! {
    struct Falling;

    const lift = 2;
    param m = 1.0;
    coord x, y, z, w;
    kinetic = kinetic_energy(1 - lift, dot(x)) + 1/2 * m * dot(w)^2;
    kinetic = kinetic_energy(m, dot((y, z)));
}

lagrange::system! {
    struct Wrong;

    coord x, y;
    kinetic = -1/2 * dot(x)^2 + dot(y)^2;
    kinetic = dot(y)^2 - pi * dot(y)^2;
}

fn main() {}
