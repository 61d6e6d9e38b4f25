lagrange::system! {
    struct Many;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    friction smooth = dot(x), 1, smooth: 0.1;
    friction dry = dot(y), 1;
    for i in 0..448 { event e[i] = x - i, rising => record; }
    event last = x - 448, rising => record;
}

fn main() {}
