lagrange::system! {
    struct Pole;

    param m = 1, k = 1;
    coord r, theta;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = k / theta;

    reduce SmallPole { small r, theta; }
    reduce FrozenPole { freeze theta = 0; }
}

lagrange::system! {
    struct Friction;

    param m = 1, c = 1;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    force x = -c * sign(dot(x));

    reduce SmallFriction { small x; }
}

lagrange::system! {
    struct Contact;

    param m = 1, k = 1;
    coord z;
    lagrangian = 1/2 * m * dot(z)^2 - if z < 0 { k * z^2 } else { 0 };

    reduce SmallContact { small z; }
}

lagrange::system! {
    struct Output;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    output slope = x / y;

    reduce SmallOutput { small y; }
    reduce FrozenOutput { freeze y = 0; }
}

lagrange::system! {
    struct Orbit;

    coord r, phi;
    kinetic = 1/2 * (dot(r)^2 + r^2 * dot(phi)^2);

    reduce CentreOrbit { freeze r = 0; }
}

lagrange::system! {
    struct Sheet;

    coord x, y, z;
    kinetic = 1/2 * ((dot(x) + dot(y))^2 + z^2 * dot(x)^2 + dot(z)^2);

    reduce Flat { freeze z = 0; }
}

fn main() {}
