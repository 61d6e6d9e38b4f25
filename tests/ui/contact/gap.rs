lagrange::system! {
    struct Gaps;

    param h = 1;
    input lift;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    event timed = t - h, falling => impact(0);
    event speed = dot(y), falling => impact(0);
    event pull = y + ddot(x), falling => impact(0);
    event floor = y, crossing => impact(0);
    event table = y - lift, falling => impact(0);
    event corner = (x, y), falling => impact(0);
}

fn main() {}
