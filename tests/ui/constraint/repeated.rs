lagrange::system! {
    struct Rolling;

    param r = 1;
    coord x, phi, z;
    kinetic = 1/2 * (dot(x)^2 + dot(phi)^2 + dot(z)^2);
    constraint rolling = x - r * phi;
    constraint again = 2 * (dot(x) - r * dot(phi));
    constraint shifted = x - r * phi + 1;
}

fn main() {}
