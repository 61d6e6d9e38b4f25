#![deny(warnings)]

// Half of the moment of inertia of a disk.
lagrange::system! {
    struct Wheel;

    param m = 1.0, r = 0.5;
    coord x, phi;
    body wheel {
        mass: m;
        inertia: 1/4 * m * r^2;
        center: (x, r);
        angle: phi;
        shape: disk(r);
    }
}

fn main() {}
