//! Systems with constraints: multipliers, constrained quantities, and contact forces.

lagrange::system! {
    /// A cylinder that rolls down a slope, with the contact as two constraints.
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
    /// A point on a moving track: the mass of the track does not matter.
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
fn constrained_quantities_are_available() {
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
        for (i, row) in found.iter().enumerate() {
            assert!((row[j] - (after[i] - before[i]) / (2.0 * h)).abs() < 1e-8, "{i} {j}");
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

lagrange::system! {
    /// A point mass on a rod of constant length.
    #[derive(Clone, Debug)]
    struct Rod;

    param m = 2.0, l = 1.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint length = (x^2 + y^2 - l^2) / 2;
    emit { momentum_rates }
}

lagrange::system! {
    /// Three points that move as one; two of the constraints would suffice.
    #[derive(Clone, Debug)]
    struct Together;

    param m = 1.5, pull = 3.0;
    coord x, y, z;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2 + dot(z)^2);
    force x = pull;
    constraint first = x - y;
    constraint second = y - z;
    constraint third = x - z;
}

lagrange::system! {
    /// The point mass on a rod with stabilisation.
    struct Stabilised;

    param m = 2.0, l = 1.0, g = 9.81, rate = 20.0;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint length = (x^2 + y^2 - l^2) / 2;
    stabilise = rate;
}

#[test]
fn projection_takes_the_shortest_way_onto_the_constraint() {
    let rod = Rod::default();
    let (mut q, mut v) = ([0.9, -1.2], [1.0, 0.5]);
    rod.project(0.0, &mut q, &mut v).expect("a rod can be brought to its length");
    // Equal masses: straight towards the centre, and without the radial component of the velocity.
    crate::assert_close(q[0], 0.6);
    crate::assert_close(q[1], -0.8);
    let along = 1.0 * 0.8 + 0.5 * 0.6;
    crate::assert_close(v[0], along * 0.8);
    crate::assert_close(v[1], along * 0.6);
    let same = rod.consistent_velocity(0.0, &q, &[1.0, 0.5]).expect("there is one");
    crate::assert_close(same[0], v[0]);
}

#[test]
fn a_state_that_cannot_be_projected_stays_what_it_was() {
    let rod = Rod { l: f64::NAN, ..Rod::default() };
    let (mut q, mut v) = ([0.9, -1.2], [1.0, 0.5]);
    let violation = rod.project(0.0, &mut q, &mut v).expect_err("no length at all");
    assert_eq!((q, v), ([0.9, -1.2], [1.0, 0.5]));
    assert_eq!(violation.constraint, "length");
}

#[test]
fn forces_of_redundant_constraints_are_shared_evenly() {
    let together = Together::default();
    let (q, v) = ([0.3; 3], [0.1; 3]);
    for found in together.acceleration(0.0, &q, &v) {
        crate::assert_close(found, 3.0 / 4.5);
    }
    // The shortest of all λ with m a = f + Aᵀλ is normal to (1, 1, −1), which moves nothing.
    let [first, second, third] = together.multipliers(0.0, &q, &v);
    crate::assert_close(first + third, 1.0 - 3.0);
    crate::assert_close(second - first, 1.0);
    assert!((first + second - third).abs() < 1e-14);
}

lagrange::system! {
    /// A body on a fixed inclined axle, beside another one.
    struct HeldOnAxle;

    param c = 0.5;
    gravity = (0, 0, -9.81);
    body a { mass: 1; inertia: (1, 1, 1); }
    cylindrical (q, s) = ground to a { turned: (0.3, 0.4, c); }
    body b { mass: 1; inertia: (1, 1, 1); }
    free b;
    pin a.center to (0, 0, 0);
}

#[test]
fn forces_of_constraints_that_always_depend_on_each_other_are_along_the_axle() {
    for c in [0.5, -0.5, 0.0, 1.2] {
        let system = HeldOnAxle { c };
        let (mut q, v) = ([0.0; 9], [0.0; 8]);
        q[5] = 1.0;
        let accelerations = system.acceleration(0.0, &q, &v);
        for (k, found) in accelerations.into_iter().enumerate() {
            assert!((found + if k == 4 { 9.81 } else { 0.0 }).abs() < 1e-12, "{c}: {accelerations:?}");
        }
        // The smallest force that holds 9.81 n_z along the axle n is parallel to it.
        let forces = system.multipliers(0.0, &q, &v);
        let square = forces.iter().map(|force| force * force).sum::<f64>();
        assert!((square - 9.81 * forces[2].abs()).abs() < 1e-11 && square > 1.0, "{c}: {forces:?}");
    }
}

#[test]
fn undefined_motions_give_no_plausible_numbers() {
    let rod = Rod::default();
    assert!(rod.acceleration(0.0, &[0.0, 0.0], &[1.0, 0.0]).iter().all(|a| a.is_nan()));
    assert!(rod.multipliers(0.0, &[0.0, 0.0], &[1.0, 0.0])[0].is_nan());
}

#[test]
fn stabilised_residuals_decay_at_the_given_rate() {
    let system = Stabilised::default();
    let (q, v) = ([0.6, -0.81], [0.8, 0.7]);
    let a = system.acceleration(0.0, &q, &v);
    let [c] = system.constraints(0.0, &q, &v);
    let [rate] = system.constraint_velocity(0.0, &q, &v);
    let second = v[0] * v[0] + v[1] * v[1] + q[0] * a[0] + q[1] * a[1];
    assert!((second + 40.0 * rate + 400.0 * c).abs() < 1e-12);
    const { assert!(!<Stabilised as lagrange::system::OdeSystem>::IS_CONSTRAINED) };
    const { assert!(<Rod as lagrange::system::OdeSystem>::IS_CONSTRAINED) };
}

#[test]
fn momenta_of_free_motion_leave_constraint_forces_out() {
    use lagrange::system::CanonicalSystem;
    let rod = Rod::default();
    let (q, v) = ([0.6, -0.8], [0.8, 0.6]);
    assert_eq!(rod.free_momentum_rates(0.0, &q, &v), [0.0, -2.0 * 9.81]);
    let [length] = rod.multipliers(0.0, &q, &v);
    let all = rod.momentum_rates(0.0, &q, &v);
    crate::assert_close(all[0], 0.6 * length);
    crate::assert_close(all[1], -2.0 * 9.81 - 0.8 * length);
}

lagrange::system! {
    /// Two coordinates that share one inertia until the constraint separates them.
    struct Shared;

    param m = 2.0;
    coord x, y, z;
    input pull;
    kinetic = 1/2 * m * (dot(x) + dot(y))^2 + 1/2 * dot(z)^2;
    force x = pull;
    constraint lever = x - 1/2 * y;
}

lagrange::system! {
    /// A rod whose length is constrained twice, by different expressions.
    #[derive(Clone, Debug)]
    struct Doubled;

    param m = 1.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint square = (x^2 + y^2 - 1) / 2;
    constraint length = hypot(x, y) - 1;
    emit { jacobian, momentum_rates }
}

lagrange::system! {
    /// A pendulum that a stop at x = 0.3 reflects at half its speed.
    struct Struck;

    param m = 1.0, g = 9.81;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2);
    potential = m * g * y;
    constraint rod = (x^2 + y^2 - 1) / 2;
    event hit = x - 0.3, rising => { dot(x) = -dot(x) / 2; dot(y) = -dot(y) / 2; }
}

#[test]
fn mass_matrices_that_constraints_make_up_for_are_accepted() {
    let shared = Shared { m: 2.0, pull: 3.0 };
    // With y = 2x: T = m (3ẋ)²/2, so that 9 m a = pull; z is free.
    let [x, y, z] = shared.acceleration(0.0, &[0.0; 3], &[0.0; 3]);
    crate::assert_close(x, 3.0 / 18.0);
    crate::assert_close(y, 6.0 / 18.0);
    assert_eq!(z, 0.0);
}

#[test]
fn every_method_takes_constraints_that_repeat_each_other() {
    use lagrange::Simulate;
    use lagrange::integrate::{GaussLegendre4, RungeKutta4, Variational};
    let (doubled, start) = (Doubled::default(), [0.6, -0.8, 0.0, 0.0]);
    let expected = doubled.simulate(start).until(1.0).tolerance(1e-12).run().expect("a motion").last();
    let runs = [
        doubled.simulate(start).until(1.0).method(GaussLegendre4 { step: 1e-2 }).run(),
        doubled.simulate(start).until(1.0).method(Variational { step: 1e-2 }).run(),
        doubled.simulate(start).until(1.0).method(RungeKutta4 { step: 1e-2 }).run(),
    ];
    for run in runs {
        let found = run.expect("a motion").last();
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-5, "{found} for {expected}");
        }
    }
}

#[test]
fn states_that_events_assign_are_put_onto_the_constraints() {
    use lagrange::Simulate;
    let struck = Struck { m: 1.0, g: 9.81 };
    let run = struck.simulate([-0.8, -0.6, 0.0, 0.0]).until(3.0).tolerance(1e-12).energy().run();
    let trajectory = run.expect("a pendulum swings back");
    let hits = trajectory.events().len();
    assert!(hits > 1, "{hits}");
    // Each hit leaves a quarter of the kinetic energy.
    let kinetic = |y: [f64; 4]| 0.5 * (y[2] * y[2] + y[3] * y[3]);
    let before = trajectory.events()[0].state;
    let height = -(1.0_f64 - 0.09).sqrt();
    let later = 9.81 * height + kinetic(before) / 4.0;
    let last = trajectory.events()[1].state;
    assert!((9.81 * last[1] + kinetic(last) - later).abs() < 1e-9);
}

/// Two of the cranks may turn in the same or in opposite directions from the position where they
/// are aligned.
#[test]
fn a_motion_that_constraints_do_not_determine_is_refused_in_finite_work() {
    use lagrange::Simulate;
    use lagrange::integrate::StepFailure;
    use std::f64::consts::PI;
    let (turning, tolerance) = ([0.0, 0.0, PI, 2.0, 0.0, 2.0], 1e-12);
    let run =
        ChangePoint::default().simulate(turning).until(30.0).tolerance(tolerance).max_steps(20_000).run();
    match run {
        // It may pass the aligned position again and again,
        Ok(trajectory) => assert!((trajectory.p()[trajectory.len() - 1] - 60.0).abs() < 1e-6),
        // or stop there, but not slow down without end.
        Err(error) => assert!(matches!(error.cause, StepFailure::Stuck(_)), "{error}"),
    }
}

lagrange::system! {
    /// A parallelogram of bars.
    struct ChangePoint;

    param m = 1.0, a = 1.0, b = 2.0;
    coord p, q, r;
    let (x1, y1) = (a * cos(p), a * sin(p));
    let (x2, y2) = (x1 + b * cos(q), y1 + b * sin(q));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2) + 1/2 * m * (dot(x2)^2 + dot(y2)^2) + 1/20 * m * dot(q)^2;
    constraint closed_x = x2 + a * cos(r) - b;
    constraint closed_y = y2 + a * sin(r);
}
