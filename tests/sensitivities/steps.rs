//! Derivatives of one step are those of the step as computed.

use lagrange::Simulate;
use lagrange::integrate::{RungeKutta4, rk4_step, rk4_step_derivatives};

lagrange::system! {
    /// A cart that carries a pendulum.
    #[derive(Clone, Debug)]
    struct CartPole;
    param cart = 1.0, pole = 0.1, l = 0.5, g = 9.81;
    coord x, theta;
    input push;
    kinetic = 1/2 * cart * dot(x)^2 + kinetic_energy(pole, dot((x + l * sin(theta), -l * cos(theta))));
    potential = -pole * g * l * cos(theta);
    force x = push;
    emit { jacobian }
}

lagrange::system! {
    /// A mass on a spring with a damper.
    struct Oscillator<S>;
    param k = 4.0, c = 0.4;
    coord x;
    input push;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    force x = push;
    emit { jacobian }
}

lagrange::system! {
    /// A mass without emitted derivatives.
    struct Plain;
    coord x;
    kinetic = 1/2 * dot(x)^2;
}

const START: [f64; 4] = [0.1, 2.0, -0.3, 0.8];

/// Forward sensitivities integrate the variational equations by the same method.
#[test]
fn steps_compose_to_the_sensitivities_of_a_motion() {
    let cart = CartPole { push: 0.7, ..CartPole::default() };
    let (h, steps, names) = (0.02, 25, ["cart", "g", "push", "theta", "x_dot"]);
    let run = cart.simulate(START).until(0.5).method(RungeKutta4 { step: h });
    let run = run.sensitivities(names).run().expect("a motion");
    let wanted = run.sensitivities(run.len() - 1).expect("the end");
    let mut y = START;
    let mut columns = [[0.0; 4], [0.0; 4], [0.0; 4], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
    for index in 0..steps {
        let t = f64::from(index) * h;
        let step = rk4_step_derivatives(&cart, t, &y, h, [0, 3, 4]).expect("emitted");
        assert_eq!(step.end, rk4_step(&cart, t, &y, h));
        let times = |column: [f64; 4]| {
            step.by_state.map(|row| row.iter().zip(column).map(|(entry, part)| entry * part).sum::<f64>())
        };
        columns = columns.map(times);
        for (column, own) in columns.iter_mut().zip(&step.by_numbers) {
            column.iter_mut().zip(own).for_each(|(entry, own)| *entry += own);
        }
        y = step.end;
    }
    for (column, wanted) in columns.iter().zip(&wanted) {
        for (found, wanted) in column.iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{column:?} {wanted:?}");
        }
    }
}

/// With z = h A, a step of a linear system is 1 + z + z²/2 + z³/6 + z⁴/24. The input has the factor
/// h (1 + z/2 + z²/6 + z³/24).
#[test]
fn a_linear_system_has_the_polynomial_of_the_method() {
    let oscillator = Oscillator::<f64>::default();
    let (h, a) = (0.1, [[0.0, 1.0], [-4.0, -0.4]]);
    let product = |b: [[f64; 2]; 2]| {
        a.map(|[first, second]: [f64; 2]| {
            [0, 1].map(|column| h * (first * b[0][column] + second * b[1][column]))
        })
    };
    let (mut power, mut factor) = ([[1.0, 0.0], [0.0, 1.0]], 1.0);
    let (mut wanted, mut by_push) = ([[0.0; 2]; 2], [0.0; 2]);
    for order in 1..=5 {
        for row in 0..2 {
            (0..2).for_each(|column| wanted[row][column] += power[row][column] / factor);
            by_push[row] += if order < 5 { h * power[row][1] / factor / f64::from(order) } else { 0.0 };
        }
        power = product(power);
        factor *= f64::from(order);
    }
    let step = rk4_step_derivatives(&oscillator, 0.0, &[0.3, -0.2], h, [2]).expect("emitted");
    let found = step.by_state.iter().flatten().zip(wanted.iter().flatten());
    let found = found.chain(step.by_numbers[0].iter().zip(&by_push));
    for (found, wanted) in found {
        assert!((found - wanted).abs() < 1e-15, "{step:?} {wanted:?}");
    }
    let small =
        rk4_step_derivatives(&Oscillator::<f32>::default(), 0.0, &[0.3, -0.2], 0.1, [2]).expect("emitted");
    assert!((f64::from(small.by_state[1][0]) - wanted[1][0]).abs() < 1e-6);
}

#[test]
fn systems_without_emitted_derivatives_have_none() {
    assert!(rk4_step_derivatives(&Plain, 0.0, &[0.0, 1.0], 0.1, []).is_none());
}
