//! Functions that a declaration defines.

lagrange::system! {
    /// A double pendulum whose energies are written with functions.
    struct WithFunctions;
    param m = 1.2, l = 0.7, g = 9.81;
    coord p, q;
    let hung(from, angle) = from + l * (sin(angle), -cos(angle));
    let energy(mass, place) = kinetic_energy(mass, dot(place)) - mass * g * place.y;
    let first = hung((0, 0), p);
    lagrangian = energy(m, first) + energy(2 * m, hung(first, q));
    output end = hung(first, q);
}

lagrange::system! {
    /// The double pendulum written without functions.
    struct Written;
    param m = 1.2, l = 0.7, g = 9.81;
    coord p, q;
    let first = (0, 0) + l * (sin(p), -cos(p));
    let second = first + l * (sin(q), -cos(q));
    lagrangian = kinetic_energy(m, dot(first)) - m * g * first.y + (kinetic_energy(2 * m, dot(second)) - 2 * m * g * second.y);
    output end = second;
}

#[test]
fn functions_do_not_change_the_equations() {
    let (functions, written) = (WithFunctions::default(), Written::default());
    for (q, v) in [([0.0, 0.0], [0.0, 0.0]), ([0.4, -1.3], [2.0, 0.7]), ([3.0, 1.0], [-1.0, 4.0])] {
        assert_eq!(functions.acceleration(0.0, &q, &v), written.acceleration(0.0, &q, &v));
        assert_eq!(functions.end(0.0, &q, &v), written.end(0.0, &q, &v));
    }
}
