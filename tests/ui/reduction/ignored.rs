lagrange::system! {
    struct Spherical;

    param m = 1, l = 1, g = 9.81;
    coord theta, phi;
    let bob = l * (sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta));
    kinetic = kinetic_energy(m, dot(bob));
    potential = gravitational_energy(m, g, bob.z);

    reduce Twice { ignore phi, phi; }
    reduce AlsoFrozen { freeze phi = 0; ignore phi; }
    reduce AlsoSmall { ignore phi; small phi; }
    reduce All { ignore theta, phi; }
    reduce Misspelt { ignore phy; }
    reduce WithValue { ignore phi = 0; }
}

lagrange::system! {
    struct Leaning;

    param m = 1, l = 1, g = 9.81, c = 1;
    coord theta, phi;
    let bob = l * (sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta));
    kinetic = kinetic_energy(m, dot(bob));
    potential = gravitational_energy(m, g, bob.z);
    potential = c * bob.x;

    reduce NotCyclic { ignore phi; }
}

lagrange::system! {
    struct Pushed;

    param m = 1;
    coord x, y, z;
    input u;
    kinetic = kinetic_energy(m, dot((x, y, z)));
    dissipation = 1/2 * dot(x)^2;
    dissipation = 1/2 * (dot(y) - dot(x))^2;
    force (0, 0, u) at (x, y, x + z);

    reduce Forced { ignore z; }
    reduce Damped { ignore y; }
}

lagrange::system! {
    struct Loose;

    coord x, y, z, w;
    lagrangian = 1/2 * dot(x)^2 - sqrt(1 - dot(y)^2) + 1/2 * dot(z)^2 * (1 + dot(w)^2) + 1/x * dot(w);

    reduce NotLinear { ignore y; }
    reduce Depends { ignore z; }
    reduce Together { ignore w; }
}

lagrange::system! {
    struct Jointed;

    state s;
    quaternion turn;
    coord x;
    kinetic = 1/2 * dot(x)^2 + 1/2 * (turn_wx^2 + turn_wy^2 + turn_wz^2);
    dot(s) = x;

    reduce Component { ignore turn_qx; }
    reduce OfFirstOrder { ignore s; }
}

lagrange::system! {
    struct Named;

    param x_momentum = 1;
    coord x, y;
    kinetic = 1/2 * dot(x)^2 + 1/2 * x_momentum * dot(y)^2;
    output from_state = x;
    output position_rates = y;
    emit { no momenta }

    reduce Taken { ignore x; }
    reduce TakenLater { ignore y; }
    param y_momentum = 1;
    potential = y_momentum * x;
}

fn main() {}
