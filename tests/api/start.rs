//! Initial values in declarations: the state that `start` returns.

use lagrange::Simulate;

lagrange::system! {
    /// A cart with a pendulum and a battery; only some of its state starts away from zero.
    #[derive(Clone, Debug)]
    struct Cart;

    param m: kg = 2, l: m = 1, g: m/s^2 = 9.81, lean: deg = 10, speed: m/s = 3;
    coord x: mm = 250, theta: rad = lean + 30 deg;
    state charge: C = 2 [mC];
    velocity u = dot(x);
    dot(charge) = -charge / 5 [s];
    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = kinetic_energy(m, dot(x)) + kinetic_energy(m, dot((px, py)));
    potential = m * g * py;
    start u = 2 * speed, dot(theta) = -60 [rpm];

    reduce Held { freeze x = 0 [m]; }
    reduce Still { freeze x = 0 [m], charge = 0 [C]; small theta; }
}

#[test]
fn initial_values_are_the_declared_ones_in_si_units() {
    let cart = Cart { speed: 0.75, ..Cart::default() };
    let expected = CartState {
        x: 0.25,
        theta: 40_f64.to_radians(),
        charge: 2e-3,
        u: 1.5,
        theta_dot: -std::f64::consts::TAU,
    };
    let found: [f64; 5] = cart.start().into();
    for (found, expected) in found.into_iter().zip(<[f64; 5]>::from(expected)) {
        assert!((found - expected).abs() <= f64::EPSILON * expected.abs(), "{found}, not {expected}");
    }
}

#[test]
fn a_run_from_them_is_that_from_the_same_numbers() {
    let cart = Cart::default();
    let numbers: [f64; 5] = cart.start().into();
    let declared = cart.simulate(cart.start()).until(2.0).every(0.5).run().expect("a motion");
    let by_hand = cart.simulate(numbers).until(2.0).every(0.5).run().expect("a motion");
    assert_eq!(declared.last(), by_hand.last());
    assert_eq!(declared.charge()[0], 2e-3);
}

#[test]
fn reduced_types_start_with_what_they_keep() {
    let cart = Cart::default();
    let HeldState { theta, charge, theta_dot } = Held::from(&cart).start();
    let whole = cart.start();
    assert_eq!((theta, charge, theta_dot), (whole.theta, whole.charge, whole.theta_dot));
    assert_eq!(Still::from(&cart).start(), StillState { theta, theta_dot });
}

lagrange::system! {
    /// Masses in a row, in any number type.
    struct Row<S>;

    const n = 3;
    param a = 0.1, b[n] = [1, 2, 3];
    coord x[n] = a, y[2][n] = [[1, 2, 3], [4, 5, b[1] / 3]];
    state e[n] = [1/3, 0, 1];
    for i in 0..n {
        kinetic = 1/2 * (dot(x[i])^2 + dot(y[0][i])^2 + dot(y[1][i])^2);
        dot(e[i]) = -b[i] * e[i];
        start dot(x[i]) = i * a, dot(y[1][n - 1 - i]) = b[i];
    }
}

#[test]
fn arrays_start_with_one_value_or_with_one_for_each_element() {
    let row = Row::<f64>::default();
    let expected = RowState {
        x: [0.1; 3],
        y: [[1.0, 2.0, 3.0], [4.0, 5.0, 2.0 / 3.0]],
        e: [1.0 / 3.0, 0.0, 1.0],
        x_dot: [0.0, 0.1, 0.2],
        y_dot: [[0.0; 3], [3.0, 2.0, 1.0]],
    };
    assert_eq!(row.start(), expected);
    let single = Row { a: 0.7_f32, ..Row::default() };
    let start = single.start();
    assert_eq!((start.x, start.e[0]), ([0.7_f32; 3], 1.0_f32 / 3.0));
}

lagrange::system! {
    #[scalar(f32)]
    struct Arm;

    param m = 1, l = 0.5, bend = 0.4, tilt = 0.3;
    gravity = (0, 0, -9.81);
    body upper { mass: m; centroid: (0, 0, -l / 2); inertia: (0.02, 0.02, 0.01); }
    body lower { mass: m; centroid: (0, 0, -l / 2); inertia: (0.02, 0.02, 0.01); }
    body stone { mass: m; inertia: (0.02, 0.03, 0.01); }
    ball shoulder = ground to upper;
    revolute elbow = upper to lower { at: (0, 0, -l); axis: (0, 1, 0); }
    free stone;
    start elbow = bend, dot(elbow) = 0.1;
    start shoulder_qw = cos(tilt / 2), shoulder_qx = sin(tilt / 2), shoulder_qy = 0, shoulder_qz = 0;
    start shoulder_wz = 2, stone_z = 1, stone_vx = 3;
    output tip = lower.point(0, 0, -l);
}

#[test]
fn joints_and_bodies_start_as_declared() {
    let arm = Arm::default();
    let start = arm.start();
    assert_eq!((start.elbow, start.elbow_dot, start.shoulder_wz), (0.4, 0.1, 2.0));
    assert_eq!((start.shoulder_qw, start.shoulder_qx), (0.15_f32.cos(), 0.15_f32.sin()));
    assert_eq!((start.stone_z, start.stone_vx, start.stone_x), (1.0, 3.0, 0.0));
    // An orientation without initial values is the identity.
    assert_eq!([start.stone_qw, start.stone_qx, start.stone_qy, start.stone_qz], [1.0, 0.0, 0.0, 0.0]);
    // Tilted about x, the upper arm of 0.5 points to y; the lower one is bent about its own y.
    let [x, y, z] = arm.tip(0.0, &start.coordinates(), &start.velocities());
    let (sine, cosine) = 0.3_f64.sin_cos();
    let below = 0.5 + 0.5 * 0.4_f64.cos();
    let expected = [-0.5 * 0.4_f64.sin(), below * sine, -below * cosine];
    for (found, expected) in [x, y, z].into_iter().zip(expected) {
        assert!((f64::from(found) - expected).abs() < 1e-6, "{found}, not {expected}");
    }
}

lagrange::system! {
    /// A point on a rod, which a start off the rod violates.
    #[derive(Clone, Debug)]
    struct Bob;

    param m = 1, l = 1, far = 1;
    coord x = far, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = 9.81 * m * y;
    constraint rod = x^2 + y^2 - l^2;
}

#[test]
fn starts_that_violate_constraints_end_as_others_do() {
    let bob = Bob { far: 2.0, ..Bob::default() };
    let declared = bob.simulate(bob.start()).until(1.0).run();
    let by_hand = bob.simulate([2.0, 0.0, 0.0, 0.0]).until(1.0).run();
    match (declared, by_hand) {
        (Ok(declared), Ok(by_hand)) => assert_eq!(declared.last(), by_hand.last()),
        (Err(declared), Err(by_hand)) => assert_eq!(declared.to_string(), by_hand.to_string()),
        (declared, by_hand) => panic!("{declared:?}, but {by_hand:?}"),
    }
    let satisfied = Bob::default();
    assert!(satisfied.simulate(satisfied.start()).until(1.0).run().is_ok());
}

lagrange::system! {
    /// Names with other meanings elsewhere.
    struct Words;

    param start = 2;
    coord x = start;
    kinetic = 1/2 * start * dot(x)^2;
    solve y: 0 = y^3 - start, start: start;
    potential = y * x;
}

#[test]
fn the_word_stays_free_for_names() {
    let words = Words { start: 8.0 };
    assert_eq!(words.start(), WordsState { x: 8.0, x_dot: 0.0 });
}
