lagrange::system! {
    struct Free;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    emit { constraint_forces }
}

lagrange::system! {
    struct Held;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    output constraints = y;
    output multipliers = wall;
    reduce Flat { freeze x = 0; }
}

fn main() {}
