lagrange::system! {
    struct Many;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    friction smooth = dot(x), 1, smooth: 0.1;
    friction dry = dot(y), 1;
    event e1 = x - 1, rising => record;
    event e2 = x - 2, rising => record;
    event e3 = x - 3, rising => record;
    event e4 = x - 4, rising => record;
    event e5 = x - 5, rising => record;
    event e6 = x - 6, rising => record;
    event e7 = x - 7, rising => record;
    event e8 = x - 8, rising => record;
    event e9 = x - 9, rising => record;
    event e10 = x - 10, rising => record;
    event e11 = x - 11, rising => record;
    event e12 = x - 12, rising => record;
    event e13 = x - 13, rising => record;
    event e14 = x - 14, rising => record;
    event e15 = x - 15, rising => record;
    event e16 = x - 16, rising => record;
    event e17 = x - 17, rising => record;
    event e18 = x - 18, rising => record;
    event e19 = x - 19, rising => record;
    event e20 = x - 20, rising => record;
    event e21 = x - 21, rising => record;
    event e22 = x - 22, rising => record;
    event e23 = x - 23, rising => record;
    event e24 = x - 24, rising => record;
    event e25 = x - 25, rising => record;
    event e26 = x - 26, rising => record;
    event e27 = x - 27, rising => record;
    event e28 = x - 28, rising => record;
    event e29 = x - 29, rising => record;
    event e30 = x - 30, rising => record;
    event e31 = x - 31, rising => record;
    event e32 = x - 32, rising => record;
}

fn main() {}
