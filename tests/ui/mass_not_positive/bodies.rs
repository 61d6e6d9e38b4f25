lagrange::system! {
    struct Rotor;

    param r = 1.0;
    coord a, b;
    body rotor { mass: 1; inertia: -1/2; center: (0, 0); angle: a; }
    body disk_and_bob {
        origin: (1, 0);
        angle: b;
        compound { disk(r), mass: 1; point_mass(), mass: 1/2 - 1, at: (0, 0); }
    }
}

fn main() {}
