lagrange::system! {
    struct Functions;

    param m = 1, l = 2;
    input u;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    event floor = y, falling => impact(0);
    event never = m - l, falling => stop;
    event fixed = m * l, rising => record;
    event pair = (x, y), rising => record;
    event opens = floor, falling => record;
    event late = jump, falling => record;
    event jump = ddot(y), falling => record;
    output jumps = jump + 1;
    output pressure = floor;
    output rate = dot(floor);
}

fn main() {}
