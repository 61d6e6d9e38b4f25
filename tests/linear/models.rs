//! Linear models against closed-form matrices and differences.

use lagrange::linear::{DenseMatrix, Linearise};
use lagrange::system::{LinearisedSystem, OdeSystem};

use super::equilibria::{DoublePendulum, Hanging, Rotor};

lagrange::system! {
    /// A motor with a spring and an eccentric weight: every kind of entry in a system matrix.
    #[derive(Clone, Debug)]
    struct Motor;

    param j = 0.3, m = 0.4, e = 0.2, k = 2, r = 1.5, l = 0.05, km = 0.7, g = 9.81;
    coord theta, x;
    input voltage, push = 0.5;
    state current, count;
    kinetic = 1/2 * j * dot(theta)^2 + kinetic_energy(m, dot((x + e*sin(theta), -e*cos(theta))));
    potential = 1/2 * k * x^2 - m * g * e * cos(theta);
    force theta = km * current;
    force x = push * cos(theta) * count;
    dot(current) = (voltage - r * current - km * dot(theta)) / l;
    dot(count) = sin(theta) * dot(x) - count * push;
    output shaking = ddot(x)^2;
    output all = (voltage * theta, current * dot(x), count);
    emit { system_matrix, tangent_jacobian }
}

#[test]
fn hanging_rods_have_the_textbook_matrix() {
    let rods = DoublePendulum::<f64>::default();
    let model = rods.linearise(0.0, [0.0; 4]).expect("smooth");
    let rate = rods.g / rods.l;
    let wanted = DenseMatrix::from_rows(&[
        [0.0, 0.0, 1.0, 0.0],
        [0.0, 0.0, 0.0, 1.0],
        [-2.0 * rate, rate, 0.0, 0.0],
        [2.0 * rate, -2.0 * rate, 0.0, 0.0],
    ]);
    assert!(model.a().plus(-1.0, &wanted).largest() < 1e-14, "{:?}", model.a());
    assert_eq!(model.states(), ["a", "b", "a_dot", "b_dot"]);
    assert_eq!((model.b().columns(), model.c().rows()), (0, 0));
    let narrow = DoublePendulum::<f32>::default().linearise(0.0, [0.0_f32; 4]).expect("smooth");
    assert!(narrow.a().plus(-1.0, &wanted).largest() < 2e-5, "{:?}", narrow.a());
}

#[test]
fn a_hover_has_the_textbook_matrices() {
    let rotor = Rotor::default();
    let hover = rotor.equilibrium([0.0; 6]).trim(&["left", "right"]).solve().expect("a hover");
    let model = hover.system(&rotor).linearise(0.0, hover.state).expect("smooth");
    let (mut a, mut b) = (DenseMatrix::zeros(6, 6), DenseMatrix::zeros(6, 2));
    (0..3).for_each(|i| a[(i, i + 3)] = 1.0);
    a[(3, 2)] = -rotor.g;
    for (input, sign) in [(0, -1.0), (1, 1.0)] {
        b[(4, input)] = 1.0 / rotor.m;
        b[(5, input)] = sign * rotor.arm / rotor.j;
    }
    assert!(model.a().plus(-1.0, &a).largest() < 1e-14, "{:?}", model.a());
    assert!(model.b().plus(-1.0, &b).largest() < 1e-14, "{:?}", model.b());
    assert_eq!(model.c().row(0), [0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!((model.inputs(), model.outputs()), (&["left", "right"][..], &["height"][..]));
}

/// Returns central differences, whose error is about 1e-10 of the entries.
fn differences(rate: impl Fn(&[f64], [f64; 2]) -> Vec<f64>, y: &[f64], u: [f64; 2]) -> DenseMatrix {
    let columns = (0..y.len() + 2).map(|k| {
        let h = 1e-5;
        let at = |sign: f64| {
            let (mut y, mut u) = (y.to_vec(), u);
            match k.checked_sub(y.len()) {
                Some(input) => u[input] += sign * h,
                None => y[k] += sign * h,
            }
            rate(&y, u)
        };
        at(1.0).iter().zip(at(-1.0)).map(|(up, down)| (up - down) / (2.0 * h)).collect::<Vec<_>>()
    });
    let columns = columns.collect::<Vec<_>>();
    DenseMatrix::from_fn(columns[0].len(), columns.len(), |i, j| columns[j][i])
}

#[test]
fn all_blocks_are_slopes_of_rates_and_outputs() {
    let y = [0.7, -0.2, 1.1, 0.4, 0.9, -1.3];
    let u = [2.0, 0.6];
    let with = |u: [f64; 2]| Motor { voltage: u[0], push: u[1], ..Motor::default() };
    let rates = |y: &[f64], u: [f64; 2]| {
        let (y, motor) = (y.try_into().expect("a state"), with(u));
        let (q, v) = lagrange::system::split::<Motor>(&y);
        let outputs = [vec![motor.shaking(0.0, &q, &v)], motor.all(0.0, &q, &v).to_vec()].concat();
        [OdeSystem::rhs(&motor, 0.0, &y).to_vec(), outputs].concat()
    };
    let wanted = differences(rates, &y, u);
    let model = with(u).linearise(0.0, y).expect("smooth");
    let found = DenseMatrix::from_fn(10, 8, |i, j| match (i < 6, j < 6) {
        (true, true) => model.a()[(i, j)],
        (true, false) => model.b()[(i, j - 6)],
        (false, true) => model.c()[(i - 6, j)],
        (false, false) => model.d()[(i - 6, j - 6)],
    });
    assert!(found.plus(-1.0, &wanted).largest() < 1e-7, "{:?}", found.plus(-1.0, &wanted));
    assert_eq!(model.states(), ["theta", "x", "current", "count", "theta_dot", "x_dot"]);
    assert_eq!(model.outputs(), ["shaking", "all.x", "all.y", "all.z"]);
    // The first rows and columns equal the separate product.
    let tangent = with(u).tangent_jacobian(0.0, &y);
    let matrix = with(u).system_matrix(0.0, &y);
    for (row, wanted) in matrix.iter().zip(tangent) {
        assert!(row.iter().zip(wanted).all(|(a, b)| (a - b).abs() <= 1e-13 * b.abs()), "{row:?} {wanted:?}");
    }
}

#[test]
fn orientations_change_by_rotations_about_the_axes_of_the_body() {
    let hanging = Hanging;
    let found = hanging.equilibrium([0.1, 0.9, 0.2, -0.1, 0.0, 0.0, 0.0]).solve().expect("an equilibrium");
    let model = hanging.linearise(0.0, found.state).expect("smooth");
    assert_eq!((model.a().rows(), model.outputs().len()), (6, 3));
    assert!(model.states()[0].starts_with("rotation("), "{:?}", model.states());
    // A rotation about the vertical moves nothing: the slopes of the outputs have rank two.
    let c = model.c();
    let up = [0.1, -0.2, 0.2].map(|entry: f64| -entry / 0.3);
    for row in 0..3 {
        let moved = (0..3).map(|k| c[(row, k)] * up[k]).sum::<f64>();
        assert!(moved.abs() < 1e-14, "{moved}");
    }
}

#[test]
fn system_matrices_have_the_layout_of_their_names() {
    assert_eq!(Motor::LAYOUT.inputs, ["voltage", "push"]);
    assert_eq!(Motor::LAYOUT.outputs.len(), 4);
    assert!(Motor::LAYOUT.constraints.is_empty());
}
