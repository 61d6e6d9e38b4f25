use lagrange::system::{Equations, LanesSystem};

lagrange::system! {
    struct Bob;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    potential = 9.81 * y;
    constraint rod = x^2 + y^2 - 1;
    emit { lanes }
}

lagrange::system! {
    struct Ball;

    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = 9.81 * h;
    event floor = h, falling => impact(0.5);
    emit { lanes, no energy }
}

lagrange::system! {
    struct Block;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    friction ground = dot(x), 3;
    emit { lanes }
}

lagrange::system! {
    struct Shot;

    param m = 2;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    event away = x - 3, rising => stop;
    emit { lanes }
}

lagrange::system! {
    struct Top;

    body rotor { mass: 1; inertia: (1, 1, 2); }
    ball turn = ground to rotor;
    emit { lanes }
}

lagrange::system! {
    struct Swapped;

    coord x, y;
    lagrangian = dot(x) * dot(y) * (1 + x^2) + 1/2 * x * dot(x)^2 + 1/2 * y * dot(y)^2 - x * y;
    emit { lanes }
}

fn main() {
    // Requested items exist nevertheless.
    let shot = Shot::default();
    let lanes: ShotLanes<f32> = shot.lanes(|parameter| parameter as f32);
    println!("{:?} {:?} {}", lanes, lanes.m, lanes.rhs(0.0, &[0.5, 0.0])[1]);
}
