lagrange::system! {
    struct Slips;

    param v = 1;
    input belt;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    friction place = x, 1;
    friction still = v, 1;
    friction speed = norm(dot((x, y))), 1;
    friction plane = dot((x, y)), 1;
    friction space = (dot(x), dot(y), dot(x)), 1;
    friction half = (dot(x), y), 1;
    friction creeps = dot((x, y)), 1, smooth: 1/10;
    friction driven = dot(x) - belt, 1;
    friction smooth = dot(y) - belt, 1, smooth: 1/10;
    friction pull = ddot(x), 1;
}

fn main() {}
