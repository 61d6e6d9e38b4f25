lagrange::system! {
    struct Balloon;

    const lift = 2, weight = 3/2;
    param l = 1.0;
    coord x, y, z;
    body balloon { mass: weight - lift; center: (x, 1); }
    body ghost { mass: 0; center: (y, 2); }
    body plate {
        origin: (z, 0);
        compound { rectangle(l, l), mass: 1; hole disk(l/4), mass: -1/8; }
    }
}

fn main() {}
