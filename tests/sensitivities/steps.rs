//! Derivatives of one step are those of the step as computed.

use lagrange::Simulate;
use lagrange::integrate::{
    BlanesMoan4, DifferentiableStep, GaussLegendre, RungeKutta4, StepFailure, Stepper, StormerVerlet,
    SymplecticEuler, rk4_step,
};
use lagrange::system::ParametricSystem;

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
        let step = RungeKutta4 { step: h }.step_derivatives(&cart, t, &y, [0, 3, 4]).expect("emitted");
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
    let step =
        RungeKutta4 { step: h }.step_derivatives(&oscillator, 0.0, &[0.3, -0.2], [2]).expect("emitted");
    let found = step.by_state.iter().flatten().zip(wanted.iter().flatten());
    let found = found.chain(step.by_numbers[0].iter().zip(&by_push));
    for (found, wanted) in found {
        assert!((found - wanted).abs() < 1e-15, "{step:?} {wanted:?}");
    }
    let small = Oscillator::<f32>::default();
    let small = RungeKutta4 { step: 0.1 }.step_derivatives(&small, 0.0, &[0.3, -0.2], [2]).expect("emitted");
    assert!((f64::from(small.by_state[1][0]) - wanted[1][0]).abs() < 1e-6);
}

lagrange::system! {
    /// Two masses in a potential that is neither even nor quadratic, pulled and shaken.
    struct Masses<S>;
    param m = 1.3, k = 2.0, b = 0.7;
    coord x, y;
    input pull;
    kinetic = 1/2 * m * (dot(x)^2 + 2 * dot(y)^2);
    potential = 1/2 * k * (x^2 + y^2) + b * x * y^2 + 1/4 * x^4;
    force x = pull * y + sin(3 * t);
    emit { jacobian }
}

const PLACE: [f64; 4] = [0.4, -0.7, 0.3, 0.9];

/// Checks derivatives of a step by eighth-order differences of steps, and the step as a run takes
/// it.
fn check_beside_differences<M, D>(system: &M, method: &D, y: [f64; 4], tolerance: f64)
where
    M: ParametricSystem + lagrange::system::OdeSystem<Scalar = f64, State = [f64; 4]>,
    D: DifferentiableStep<M>,
{
    let t = 0.2;
    let end = |system: &M, y: [f64; 4]| {
        let mut stepper = method.start(system, t, &y, 10.0).expect("a start");
        stepper.step(system, 10.0).expect("a step");
        *stepper.state()
    };
    let indices = [0, 1, M::NUMBERS.len() - 1];
    let found = method.step_derivatives(system, t, &y, indices).expect("emitted");
    assert_eq!(found.end, end(system, y), "{}", method.name());
    let slope = |ends: &dyn Fn(f64) -> [f64; 4]| {
        let weights = [4.0 / 5.0, -1.0 / 5.0, 4.0 / 105.0, -1.0 / 280.0];
        let (scale, mut sum) = (1e-2, [0.0; 4]);
        for (index, weight) in weights.into_iter().enumerate() {
            let by = scale * (index + 1) as f64;
            let (there, here) = (ends(by), ends(-by));
            (0..4).for_each(|i| sum[i] += weight * (there[i] - here[i]) / scale);
        }
        sum
    };
    let check = |found: f64, wanted: f64| {
        assert!((found - wanted).abs() < tolerance, "{}: {found} {wanted}", method.name());
    };
    for j in 0..4 {
        let wanted = slope(&|by| end(system, std::array::from_fn(|i| y[i] + if i == j { by } else { 0.0 })));
        (0..4).for_each(|i| check(found.by_state.as_ref()[i][j], wanted[i]));
    }
    for (column, index) in found.by_numbers.iter().zip(indices) {
        let value = system.number(index).expect("a number");
        let wanted = slope(&|by| end(&system.with_number(index, value + by), y));
        (0..4).for_each(|i| check(column[i], wanted[i]));
    }
}

#[test]
fn steps_of_all_methods_have_the_derivatives_of_differences() {
    let masses = Masses { pull: 0.6, ..Masses::default() };
    let cart = CartPole { push: 0.7, ..CartPole::default() };
    for step in [1e-3, 0.05, 0.3] {
        check_beside_differences(&masses, &RungeKutta4 { step }, PLACE, 1e-11);
        check_beside_differences(&masses, &SymplecticEuler { step }, PLACE, 1e-11);
        check_beside_differences(&masses, &StormerVerlet { step }, PLACE, 1e-11);
        check_beside_differences(&masses, &BlanesMoan4 { step }, PLACE, 1e-11);
        check_beside_differences(&masses, &GaussLegendre::<_, 1> { step }.plain(), PLACE, 1e-11);
        check_beside_differences(&masses, &GaussLegendre::<_, 2> { step }.plain(), PLACE, 1e-11);
        check_beside_differences(&masses, &GaussLegendre::<_, 3> { step }.plain(), PLACE, 1e-11);
        check_beside_differences(&masses, &GaussLegendre::<_, 3> { step }.plain(), [0.0; 4], 1e-11);
        check_beside_differences(&masses, &BlanesMoan4 { step }, [0.0; 4], 1e-11);
    }
    for step in [1e-3, 0.05] {
        check_beside_differences(&cart, &RungeKutta4 { step }, START, 1e-9);
        check_beside_differences(&cart, &GaussLegendre::<_, 3> { step }.plain(), START, 1e-9);
    }
}

/// Kicks and drifts are symplectic in coordinates and momenta if forces have a potential: AᵀΩA = Ω.
/// Velocities times masses stand for momenta.
#[test]
fn derivatives_of_splittings_are_symplectic() {
    let masses = Masses::<f64> { m: 1.0, ..Masses::default() };
    let method = BlanesMoan4 { step: 0.4 };
    let a = method.step_derivatives(&masses, 0.0, &PLACE, []).expect("emitted").by_state;
    // The second mass is twice the first.
    let mass = [1.0, 2.0];
    for i in 0..4 {
        for j in 0..4 {
            let form = |p: &dyn Fn(usize) -> f64, q: &dyn Fn(usize) -> f64| {
                (0..2).map(|k| mass[k] * (p(k) * q(k + 2) - p(k + 2) * q(k))).sum::<f64>()
            };
            let unit = |of: usize| move |k: usize| f64::from(u8::from(of == k));
            let found = form(&|k| a[k][i], &|k| a[k][j]);
            assert!((found - form(&unit(i), &unit(j))).abs() < 1e-14);
        }
    }
}

/// Steps forwards and back again multiply to one for symmetric methods, in either number type.
#[test]
fn derivatives_of_steps_back_are_inverse() {
    fn check<S: lagrange::Scalar, D: DifferentiableStep<Masses<S>>>(methods: &[D; 2], tolerance: f64)
    where
        Masses<S>: ParametricSystem<Scalar = S> + lagrange::system::OdeSystem<Scalar = S, State = [S; 4]>,
    {
        let masses = Masses::<S>::default();
        let start = PLACE.map(S::from_f64);
        let there = methods[0].step_derivatives(&masses, S::ZERO, &start, []).expect("emitted");
        let time = S::from_f64(0.1);
        let back = methods[1].step_derivatives(&masses, time, &there.end, []).expect("emitted");
        for i in 0..4 {
            for j in 0..4 {
                let product = |k: usize| back.by_state[i][k] * there.by_state[k][j];
                let found = (1..4).fold(product(0), |sum, k| sum + product(k));
                let wanted = if i == j { S::ONE } else { S::ZERO };
                assert!((found - wanted).abs() < S::from_f64(tolerance), "{found:?} {wanted:?}");
            }
        }
    }
    check::<f64, _>(&[0.1, -0.1].map(|step| StormerVerlet { step }), 1e-14);
    check::<f64, _>(&[0.1, -0.1].map(|step| GaussLegendre::<_, 2> { step }.plain()), 1e-13);
    check::<f32, _>(&[0.1, -0.1].map(|step| BlanesMoan4 { step }), 1e-5);
    check::<f32, _>(&[0.1, -0.1].map(|step| GaussLegendre::<_, 3> { step }.plain()), 1e-5);
    let still = RungeKutta4 { step: 0.0 }.step_derivatives(&Masses::<f64>::default(), 0.0, &PLACE, [0]);
    let still = still.expect("emitted");
    assert_eq!((still.end, still.by_numbers), (PLACE, [[0.0; 4]]));
}

#[test]
fn steps_without_derivatives_say_why() {
    let failure = RungeKutta4 { step: 0.1 }.step_derivatives(&Plain, 0.0, &[0.0, 1.0], []).unwrap_err();
    assert!(failure.to_string().contains("emit { jacobian }"), "{failure}");
    let cart = CartPole::default();
    let broken = RungeKutta4 { step: 0.1 }.step_derivatives(&cart, 0.0, &[0.0, f64::NAN, 0.0, 0.0], [0]);
    assert_eq!(broken.unwrap_err(), StepFailure::NotFinite);
    lagrange::system! {
        /// A mass on a rod.
        struct Rod;
        coord x, y;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        constraint rod = x^2 + y^2 - 1;
        emit { jacobian }
    }
    let held = StormerVerlet { step: 0.1 }.step_derivatives(&Rod, 0.0, &[1.0, 0.0, 0.0, 1.0], []);
    assert!(held.unwrap_err().to_string().contains("RungeKutta4"));
}
