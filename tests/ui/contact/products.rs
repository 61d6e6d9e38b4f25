//! Jumps have no derivatives, and methods of contacts keep their names.

lagrange::system! {
    struct Ball;
    param g = 9.81;
    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = g * y;
    event floor = y, falling => impact(0.8);
    output reactions = y;
    output event_functions = y;
    emit { jacobian }
}

lagrange::system! {
    struct Rod;
    param g = 9.81;
    coord x, y;
    kinetic = 1/2 * dot(x)^2 + 1/2 * dot(y)^2;
    potential = g * y;
    constraint length = (x^2 + y^2 - 1) / 2;
    output project = y;
    emit { no constraint_velocity, no constraint_forces }
}

fn main() {}
