lagrange::system! {
    struct Kinks;

    param m = 1.0, c = 0.1;
    coord x, y, z, w;
    let speed = norm(dot((x, 0)));
    kinetic = 1/2 * m * dot(x)^2 + c * speed;
    kinetic = 1/2 * m * dot(y)^2 + max(dot(y), 0);
    kinetic = 1/2 * m * dot(z)^2 + c * sqrt(4 * dot(z)^2);
    kinetic = 1/2 * m * dot(w)^2 + abs(dot(w)) * dot(w) + abs(dot(w))^3 + max(dot(w), 0)^2 + speed^2;
}

fn main() {}
