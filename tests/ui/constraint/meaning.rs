lagrange::system! {
    struct Point;

    param r = 1;
    input u;
    coord x, y, z, w;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2 + dot(z)^2 + dot(w)^2);
    constraint fixed = r - 1;
    constraint fast = dot(x)^2 + dot(y)^2 - 1;
    constraint driven = z - u;
    constraint steered = dot(w) - u;
    constraint pulled = ddot(x);
}

fn main() {}
