lagrange::system! {
    struct Limits;

    param mu = 0.3, w = 1;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint track = y;
    event wall = x, falling => impact(0);
    friction first = dot(x), mu * abs(track);
    friction second = dot(x), mu * track * wall;
    friction third = dot(x), mu * fourth;
    friction fourth = dot(x), -1;
    friction fifth = dot(x), kinetic: 0.3, static: 0.2;
    friction sixth = dot(x), kinetic: 2 * mu * wall, static: 2 * mu * wall - 1;
    friction seventh = dot(x), mu * ddot(x);
    friction eighth = dot(x), (1, 2);
    friction ninth = dot(x), mu, smooth: 0;
    friction tenth = dot(x), mu, smooth: x;
    friction fine = dot(x), mu * (track + wall) * exp(-dot(x)^2), smooth: w;
}

fn main() {}
