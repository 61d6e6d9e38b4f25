lagrange::system! {
    struct Point;

    coord x, y;
    let p = (x, y);
    param k = (1, 2);
    const c = (1, 2);
    kinetic = 1/2 * dot(p);
    potential = p^2 + 2^p + sin(p) + spring_energy(p, x) + if p < 1 { x } else { y };
    dissipation = dot(p);
    force x = p;
    torque p on x;
    torque 1 on p;
    output nested = (p, x);
}

fn main() {}
