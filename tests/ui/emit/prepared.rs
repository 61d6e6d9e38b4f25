lagrange::system! {
    struct Bob;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    potential = 9.81 * y;
    constraint rod = x^2 + y^2 - 1;
    emit { prepared }
}

lagrange::system! {
    struct Ball;

    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = 9.81 * h;
    event floor = h, falling => impact(0.5);
    emit { prepared, no energy }
}

lagrange::system! {
    struct Stop;

    param m = 2, k = 3;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    force x = -k * max(x - 1, 0);
    emit { prepared }
}

lagrange::system! {
    struct Swapped;

    coord x, y;
    lagrangian = dot(x) * dot(y) * (1 + x^2) + 1/2 * x * dot(x)^2 + 1/2 * y * dot(y)^2 - x * y;
    emit { prepared }
}

fn main() {
    // Requested items exist nevertheless.
    let stop = Stop::default().prepared();
    println!("{:?} {:?}", stop.acceleration(0.0, &[0.5], &[0.0]), stop.system().m);
}
