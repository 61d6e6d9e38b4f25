lagrange::system! {
    struct Assignments;

    param k = 1/2;
    coord x, y;
    let speed = dot(x);
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    event hit = x, falling => {
        dot(x) = -k * dot(x);
        k = 0;
        speed = 0;
        x_dot = 0;
        ddot(x) = 0;
        dot(x + y) = 0;
        dot(z) = 0;
        dot(k) = 0;
        dot(x) = 0;
        dot(y) = ddot(y);
        y = (x, y);
    };
}

fn main() {}
