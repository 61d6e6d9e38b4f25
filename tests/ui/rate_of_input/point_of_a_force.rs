lagrange::system! {
    struct Crane;

    input u;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force (1, 0) at (x, u);
}

fn main() {}
