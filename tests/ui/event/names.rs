lagrange::system! {
    struct Names;

    param drag = 1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = -drag;
    event drag = x, falling => stop;
    event hit = x, rising => stop;
    event hit = dot(x), rising => record;
    friction hit = dot(x), 1;
    output hit = x;
    event event = x, falling => record;
    event stabilise = x, falling => record;
}

lagrange::system! {
    struct Whole;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    event hit = x, rising => stop;
    reduce Half { freeze y = 0; }
}

fn main() {}
