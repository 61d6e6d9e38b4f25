//! Systems with constraints: multipliers, what is constrained, and the forces of the contacts.

lagrange::system! {
    /// A cylinder rolls down a slope; the contact is kept as two constraints.
    #[derive(Clone, Debug)]
    struct Cylinder;

    param m = 2.0, r = 0.3, alpha = 30 * pi / 180, g = 9.81;
    coord x, y, phi;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2) + 1/4 * m * r^2 * dot(phi)^2;
    potential = m * g * (y * cos(alpha) - x * sin(alpha));
    constraint normal = y;
    constraint rolling = x - r * phi;
    output contact = (-rolling, normal);
}

lagrange::system! {
    /// A skate: the blade does not slide sideways.
    #[derive(Clone, Debug)]
    struct Sleigh<S>;

    param m = 1.2, j = 0.3, a = 0.4;
    coord x, y, theta;
    let (cx, cy) = (x + a * cos(theta), y + a * sin(theta));
    kinetic = 1/2 * m * (dot(cx)^2 + dot(cy)^2) + 1/2 * j * dot(theta)^2;
    constraint blade = dot(y) * cos(theta) - dot(x) * sin(theta);
    emit { jacobian, momentum_rates }
}

lagrange::system! {
    /// A point that a moving track carries: the mass of the track does not matter.
    struct Carried;

    param m = 1.0, b = 0.5;
    coord x, track;
    kinetic = 1/2 * m * dot(x)^2;
    constraint driven = track - b * sin(3 * t);
    constraint held = x - track;
}

const Q: [f64; 3] = [0.2, 0.1, -0.4];
const V: [f64; 3] = [0.7, -0.3, 1.1];

#[test]
fn contact_forces_of_a_rolling_cylinder_are_those_of_the_textbook() {
    let cylinder = Cylinder::default();
    let weight = cylinder.m * cylinder.g;
    let (sine, cosine) = cylinder.alpha.sin_cos();
    let accelerations = cylinder.acceleration(0.0, &Q, &V);
    let along = 2.0 / 3.0 * cylinder.g * sine;
    for (found, wanted) in accelerations.into_iter().zip([along, 0.0, along / cylinder.r]) {
        crate::assert_close(found, wanted);
    }
    let [friction, normal] = cylinder.contact(0.0, &Q, &V);
    crate::assert_close(friction, weight * sine / 3.0);
    crate::assert_close(normal, weight * cosine);
    let [normal, rolling] = cylinder.multipliers(0.0, &Q, &V);
    let forces = cylinder.constraint_forces(0.0, &Q, &V);
    for (found, wanted) in forces.into_iter().zip([rolling, normal, -cylinder.r * rolling]) {
        crate::assert_close(found, wanted);
    }
}

#[test]
fn what_is_constrained_can_be_asked_for() {
    let cylinder = Cylinder::default();
    assert_eq!(cylinder.constraints(0.0, &Q, &V), [0.1, 0.2 + 0.3 * 0.4]);
    assert_eq!(cylinder.constraint_velocity(0.0, &Q, &V), [-0.3, 0.7 - 0.3 * 1.1]);
    assert_eq!(cylinder.constraint_jacobian(0.0, &Q), [[0.0, 1.0, 0.0], [1.0, 0.0, -0.3]]);
}

#[test]
fn accelerations_and_multipliers_satisfy_both_rows_of_the_equations() {
    let sleigh = Sleigh::<f64>::default();
    let (a, [blade]) = (sleigh.acceleration(0.0, &Q, &V), sleigh.multipliers(0.0, &Q, &V));
    let ([row], mass) = (sleigh.constraint_jacobian(0.0, &Q), sleigh.mass_matrix(0.0, &Q));
    let forcing = sleigh.forcing(0.0, &Q, &V);
    for i in 0..3 {
        let inertia: f64 = (0..3).map(|j| mass[i][j] * a[j]).sum();
        crate::assert_close(inertia, forcing[i] + row[i] * blade);
    }
    let h = 1e-6;
    let later = |s: f64| {
        let [q, v] =
            [0, 1].map(|k| std::array::from_fn(|i| if k == 0 { Q[i] + s * V[i] } else { V[i] + s * a[i] }));
        sleigh.constraint_velocity(0.0, &q, &v)[0]
    };
    assert!(((later(h) - later(-h)) / (2.0 * h)).abs() < 1e-8);
}

#[test]
fn reactions_change_momenta() {
    let sleigh = Sleigh::<f64>::default();
    let a = sleigh.acceleration(0.0, &Q, &V);
    let rates = sleigh.momentum_rates(0.0, &Q, &V);
    let h = 1e-6;
    let momenta = |s: f64| {
        sleigh.momenta(
            0.0,
            &std::array::from_fn(|i| Q[i] + s * V[i]),
            &std::array::from_fn(|i| V[i] + s * a[i]),
        )
    };
    let (before, after) = (momenta(-h), momenta(h));
    for i in 0..3 {
        assert!((rates[i] - (after[i] - before[i]) / (2.0 * h)).abs() < 1e-8, "{i}");
    }
}

#[test]
fn jacobians_know_of_constraints() {
    let sleigh = Sleigh::<f64>::default();
    let y = [Q[0], Q[1], Q[2], V[0], V[1], V[2]];
    let (found, h) = (sleigh.jacobian(0.0, &y), 1e-6);
    for j in 0..6 {
        let moved = |s: f64| sleigh.rhs(0.0, &std::array::from_fn(|k| if k == j { y[k] + s } else { y[k] }));
        let (before, after) = (moved(-h), moved(h));
        for i in 0..6 {
            assert!((found[i][j] - (after[i] - before[i]) / (2.0 * h)).abs() < 1e-8, "{i} {j}");
        }
    }
}

#[test]
fn coordinates_without_inertia_follow_from_their_constraints() {
    let system = Carried { m: 2.0, b: 0.5 };
    let t = 0.4_f64;
    let wanted = -9.0 * 0.5 * (3.0 * t).sin();
    for found in system.acceleration(t, &[0.1, 0.2], &[0.3, 0.4]) {
        crate::assert_close(found, wanted);
    }
    let [driven, held] = system.multipliers(t, &[0.1, 0.2], &[0.3, 0.4]);
    crate::assert_close(held, 2.0 * wanted);
    crate::assert_close(driven, held);
}
