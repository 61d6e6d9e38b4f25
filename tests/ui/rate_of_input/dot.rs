lagrange::system! {
    struct Crane;

    input u, v;
    coord x;
    let px = x + u * sin(x);
    kinetic = 1/2 * dot(px)^2 + 1/2 * dot(x)^2;
    potential = x * dot(v);
    output drift = ddot(u);
}

fn main() {}
