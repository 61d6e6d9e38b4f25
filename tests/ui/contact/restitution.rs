lagrange::system! {
    struct Restitutions;

    const bouncy = 3/2;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    event floor = y, falling => impact(bouncy);
    event wall = x, falling => impact(-0.1);
    event left = x - 1, falling => impact(floor);
    event right = x + 1, falling => impact((0, 1));
    event ceiling = y - 1, rising => impact(1 / (1 + abs(dot(y))));
}

fn main() {}
