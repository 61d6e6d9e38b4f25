lagrange::system! {
    struct Bob;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    potential = 9.81 * y;
    constraint rod = x^2 + y^2 - 1;
    emit { kernel }
}

lagrange::system! {
    struct Ball;

    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = 9.81 * h;
    event floor = h, falling => impact(0.5);
    emit { no energy, kernel }
}

lagrange::system! {
    struct Fall;

    coord h;
    kinetic = 1/2 * dot(h)^2;
    potential = 9.81 * h;
    event floor = h, falling => stop;
    emit { kernel }
}

lagrange::system! {
    struct Heavy;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = 1e60;
    emit { kernel }
}

fn main() {
    // Requested items exist nevertheless.
    println!("{} {}", Fall::KERNEL_F64, Fall::KERNEL_F32);
}
