lagrange::system! {
    struct Free;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    stabilise = 10;
}

lagrange::system! {
    struct Held;

    param k = 10;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    stabilise 10;
    stabilize = 10;
}

lagrange::system! {
    struct Twice;

    param k = 10;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    stabilise = k;
    stabilise = 2 * k;
}

lagrange::system! {
    struct Growing;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    stabilise = -1;
    constraint wall = x;
}

lagrange::system! {
    struct Controlled;

    input u;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    stabilise = 1 + u;
}

lagrange::system! {
    struct Moving;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    stabilise = 1 + y;
}

lagrange::system! {
    struct Pulled;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    stabilise = wall;
}

lagrange::system! {
    struct Pair;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint wall = x;
    stabilise = (1, 2);
}

fn main() {}
