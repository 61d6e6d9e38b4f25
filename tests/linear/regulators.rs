//! Regulators, controllability and eigenvalues, against NumPy and SciPy (`tools/linear.py`).

use std::f64::consts::PI;

use lagrange::Simulate;
use lagrange::linear::{DenseMatrix, DesignError, LinearModel, Linearise};

lagrange::system! {
    /// A cart that carries a pole, pushed by a force; the angle is measured from below.
    #[derive(Clone, Debug)]
    struct CartPole;

    param cart = 1.0, pole = 0.1, l = 0.5, g = 9.81;
    coord x, theta;
    input u, twist;
    kinetic = 1/2 * cart * dot(x)^2 + kinetic_energy(pole, dot((x + l*sin(theta), -l*cos(theta))));
    potential = -pole * g * l * cos(theta);
    force x = u;
    force theta = twist;
    emit { system_matrix }
}

lagrange::system! {
    /// Two equal pendulums on a cart without mass of its own: only their sum is controllable.
    #[derive(Debug)]
    struct Twins;

    coord x, a, b;
    input u;
    kinetic = 1/2 * dot(x)^2;
    kinetic = kinetic_energy(1, dot((x + sin(a), cos(a)))) + kinetic_energy(1, dot((x + sin(b), cos(b))));
    potential = 9.81 * (cos(a) + cos(b));
    force x = u;
    output place = x;
    emit { system_matrix }
}

lagrange::system! {
    /// The cart with its force only.
    #[derive(Clone, Debug)]
    struct Pushed;

    param cart = 1.0, pole = 0.1, l = 0.5, g = 9.81;
    coord x, theta;
    input u;
    kinetic = 1/2 * cart * dot(x)^2 + kinetic_energy(pole, dot((x + l*sin(theta), -l*cos(theta))));
    potential = -pole * g * l * cos(theta);
    force x = u;
    output tip = x + l*sin(theta);
    emit { system_matrix }
}

lagrange::system! {
    /// The cart, pushed by a regulator whose Riccati equation runs in the declaration.
    #[derive(Clone, Debug)]
    struct Regulated;

    param cart = 1.0, pole = 0.1, l = 0.5, g = 9.81;
    // The linear model of x, theta and their rates where the pole is upright.
    let c = pole * g / cart;
    let a = (g + c) / l;
    let A = ((0, 0, 1, 0), (0, 0, 0, 1), (0, c, 0, 0), (0, a, 0, 0));
    param B[4][1] = [[0], [0], [1], [2]];
    param Q[4][4] = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
    state S[4][4];
    dot(S) = transpose(A) * S + S * A - S * B * transpose(B) * S + Q;
    coord x, theta;
    kinetic = 1/2 * cart * dot(x)^2 + kinetic_energy(pole, dot((x + l*sin(theta), -l*cos(theta))));
    potential = -pole * g * l * cos(theta);
    let gain = (transpose(B) * S)[0];
    force x = -inner(gain, (x, theta - pi, dot(x), dot(theta)));
}

fn upright() -> LinearModel {
    let pushed = Pushed::default();
    let found = pushed.equilibrium([0.0, 3.0, 0.0, 0.0]).solve().expect("an equilibrium");
    assert!((found.state[1] - PI).abs() < 1e-15 && found.freedom == 1, "{found:?}");
    pushed.linearise(0.0, found.state).expect("smooth")
}

/// The gain of the Riccati equation at rest is that of the model, and holds the pole upright.
#[test]
fn a_regulator_in_matrices_of_the_declaration_is_that_of_the_model() {
    let regulated = Regulated::default();
    let mut start = [0.0; 20];
    start[1] = PI;
    let mut start = regulated.simulate(start).until(10.0).run().expect("comes to rest").last();
    [start[0], start[1]] = [0.1, PI - 0.2];
    let run = regulated.simulate(start).until(20.0).run().expect("moves");
    let identity = DenseMatrix::identity(4);
    let regulator = upright().lqr(&identity, &DenseMatrix::identity(1)).expect("a regulator");
    let riccati = &run.last()[2..18];
    for (column, gain) in (0..4).map(|column| (column, regulator.gain[(0, column)])) {
        let found = riccati[8 + column] + 2.0 * riccati[12 + column];
        assert!((found - gain).abs() < 1e-8 * gain.abs(), "{found}, not {gain}");
    }
    let [x, theta] = [run.last()[0], run.last()[1]];
    assert!(x.abs() < 1e-6 && (theta - PI).abs() < 1e-6, "{x}, {theta}");
}

#[test]
fn gains_are_shown_with_names() {
    let model = upright();
    let regulator = model.lqr(&DenseMatrix::identity(4), &DenseMatrix::identity(1)).expect("a regulator");
    // The gain of SciPy, of six digits without zeros at their ends.
    let expected = "\
K   x    theta     x_dot  theta_dot
u  -1  30.3091  -2.23142    6.68877";
    assert_eq!(format!("{regulator}"), expected);
    let observer = model.observer(&DenseMatrix::identity(4), &DenseMatrix::identity(1)).expect("an observer");
    let shown = format!("{observer:.3}");
    let first = shown.lines().map(|line| line.split_whitespace().next().expect("a name")).collect::<Vec<_>>();
    assert_eq!(first, ["L", "x", "theta", "x_dot", "theta_dot"]);
    let [head, entries @ ..] = &shown.lines().collect::<Vec<_>>()[..] else { panic!("{shown}") };
    assert!(head.ends_with(" tip"), "{shown}");
    for (row, line) in entries.iter().enumerate() {
        let entry: f64 = line.split_whitespace().nth(1).expect("an entry").parse().expect("a number");
        assert!((entry / observer.gain[(row, 0)] - 1.0).abs() < 5e-3, "{shown}");
    }
    let sampled = model.sampled(0.02).expect("finite");
    let shown = format!("{sampled}");
    let heads = shown.lines().filter(|line| line.starts_with(['A', 'B', 'C', 'D'])).count();
    assert_eq!((heads, shown.lines().count()), (4, 5 + 5 + 2 + 2), "{shown}");
}

#[test]
fn a_balanced_pole_has_the_gains_of_scipy() {
    let model = upright();
    let mut rows = 0;
    for line in include_str!("riccati.csv").lines() {
        let numbers = line.split(',').map(|text| text.parse().expect("a number")).collect::<Vec<f64>>();
        let (q, r) = (DenseMatrix::diagonal(&numbers[..4]), DenseMatrix::diagonal(&numbers[4..5]));
        let regulator = model.lqr(&q, &r).expect("a regulator");
        for (k, wanted) in numbers[5..].iter().enumerate() {
            let found = regulator.gain[(0, k)];
            assert!((found - wanted).abs() < 1e-9 * wanted.abs(), "{line}: {found} {wanted}");
        }
        // The Riccati equation is satisfied up to the rounding of its terms.
        let (a, b, x) = (model.a(), model.b(), &regulator.cost);
        let residual = a.transposed().times(x).plus(1.0, &x.times(a)).plus(1.0, &q);
        let residual = residual.plus(-1.0, &x.times(b).times(&regulator.gain));
        let size = x.largest() * (a.largest() + regulator.gain.largest()) + q.largest();
        assert!(residual.largest() < 1e-13 * size, "{line}: {} of {size}", residual.largest());
        let poles = regulator.closed_loop.eigenvalues().expect("eigenvalues");
        assert!(poles.iter().all(|(real, _)| *real < 0.0), "{poles:?}");
        rows += 1;
    }
    assert_eq!(rows, 5);
}

#[test]
fn sampled_models_regulators_and_observers_are_those_of_scipy() {
    let model = upright();
    let (mut counts, mut worst) = ([0; 3], 0.0_f64);
    for line in include_str!("designs.csv").lines() {
        let (kind, numbers) = line.split_once(',').expect("a kind");
        let numbers = numbers.split(',').map(|text| text.parse().expect("a number")).collect::<Vec<f64>>();
        let (period, wanted) = (numbers[0], &numbers[6..]);
        let (w, v) = (DenseMatrix::diagonal(&numbers[1..5]), DenseMatrix::diagonal(&numbers[5..6]));
        let sampled = model.sampled(period).expect("no overflow");
        let (kind, found) = match kind {
            "held" => (0, [sampled.a.clone(), sampled.b.clone()].to_vec()),
            "regulator" => (1, [sampled.lqr(&w, &v).expect("a regulator").gain].to_vec()),
            _ if period == 0.0 => (2, [model.observer(&w, &v).expect("an observer").gain].to_vec()),
            _ => (2, [sampled.observer(&w, &v).expect("an observer").gain].to_vec()),
        };
        let found = found.iter().flat_map(|m| (0..m.rows()).flat_map(|i| m.row(i).to_vec()));
        let size = wanted.iter().fold(0.0, |most: f64, wanted| most.max(wanted.abs()));
        let errors = found.zip(wanted).map(|(found, wanted)| (found - wanted).abs() / size);
        let error = errors.fold(0.0, f64::max);
        // With weights eight orders of magnitude apart, costs span fourteen.
        let bound = if numbers[5] == 1e4 { 1e-5 } else { 1e-9 };
        assert!(error < bound, "{line}: {error:e}");
        worst = worst.max(error / bound);
        counts[kind] += 1;
    }
    println!("the largest relative difference is {worst:e} of its bound");
    assert_eq!(counts, [3, 12, 12]);
}

#[test]
fn an_observer_and_a_regulator_balance_together() {
    let sampled = upright().sampled(0.02).expect("no overflow");
    let (states, one) = (DenseMatrix::identity(4), DenseMatrix::identity(1));
    let regulator = sampled.lqr(&states, &one).expect("a regulator");
    let observer = sampled.observer(&states, &one).expect("an observer");
    // The error of the estimate does not depend on the feedback.
    let (mut x, mut estimate) =
        (DenseMatrix::from_rows(&[[0.1], [0.2], [0.0], [0.0]]), DenseMatrix::zeros(4, 1));
    for _ in 0..3000 {
        let u = regulator.gain.times(&estimate).scaled(-1.0);
        let by_input = sampled.b.times(&u);
        let seen = sampled.c.times(&x.plus(-1.0, &estimate));
        estimate = sampled.a.times(&estimate).plus(1.0, &by_input).plus(1.0, &observer.gain.times(&seen));
        x = sampled.a.times(&x).plus(1.0, &by_input);
    }
    assert!(x.largest() < 1e-9 && estimate.largest() < 1e-9, "{x:?} {estimate:?}");
    for (poles, matrix) in [("closed loop", &regulator.closed_loop), ("errors", &observer.error_dynamics)] {
        let found = matrix.eigenvalues().expect("eigenvalues");
        assert!(found.iter().all(|(real, imaginary)| real.hypot(*imaginary) < 1.0), "{poles}: {found:?}");
    }
}

#[test]
fn unobservable_states_are_named() {
    let model = Twins::default().linearise(0.0, [0.0; 6]).expect("smooth");
    let hidden = model.least_observed_direction().expect("states");
    assert!(!hidden.is_controllable(), "{hidden}");
    let error =
        model.observer(&DenseMatrix::identity(6), &DenseMatrix::identity(1)).expect_err("nothing shows it");
    assert!(
        error.to_string().starts_with("no observer follows the system: the outputs do not show"),
        "{error}"
    );
    let sampled = model.sampled(0.1).expect("no overflow");
    let error =
        sampled.lqr(&DenseMatrix::identity(6), &DenseMatrix::identity(1)).expect_err("nothing moves it");
    assert!(
        error.to_string().starts_with("no feedback stabilises the system: the inputs do not move"),
        "{error}"
    );
    let weights = DenseMatrix::identity(6);
    let error = model.observer(&weights, &weights).expect_err("of another size");
    assert_eq!(error.to_string(), "the intensities of the noise must have 1 rows and columns");
    for period in [f64::NAN, f64::INFINITY, 1e6] {
        assert!(model.sampled(period).is_none(), "{period}");
    }
}

#[test]
fn the_regulator_balances_the_nonlinear_system() {
    use lagrange::Simulate;
    let gain = upright().lqr(&DenseMatrix::identity(4), &DenseMatrix::identity(1)).expect("a regulator").gain;
    let law = |_: &Pushed, _: f64, state: PushedState| {
        let state: [f64; 4] = state.into();
        let x = [state[0], state[1] - PI, state[2], state[3]];
        PushedInputs { u: -(0..4).map(|k| gain[(0, k)] * x[k]).sum::<f64>() }
    };
    let motion = Pushed::default().simulate([0.2, PI - 0.3, 0.0, 0.0]).until(30.0).drive(law).run();
    let [x, theta, ..] = motion.expect("a motion").last();
    assert!(x.abs() < 1e-6 && (theta - PI).abs() < 1e-6, "{x} {theta}");
}

#[test]
fn equal_pendulums_have_a_direction_that_nothing_moves() {
    let model = Twins::default().linearise(0.0, [0.0; 6]).expect("smooth");
    let weakest = model.weakest_direction().expect("states");
    assert!(!weakest.is_controllable() && weakest.distance < 1e-14, "{weakest}");
    assert!((weakest.eigenvalue.0.abs() - 9.81_f64.sqrt()).abs() < 1e-14, "{weakest}");
    let share = |name: &str| {
        let found = weakest.direction.iter().find(|(state, _)| state == name);
        found.unwrap_or_else(|| panic!("{name}")).1
    };
    assert!((share("a") - share("b")).abs() < 1e-12 && share("x") < 1e-12 && share("a") > 0.1, "{weakest}");
    let error =
        model.lqr(&DenseMatrix::identity(6), &DenseMatrix::identity(1)).expect_err("nothing moves it");
    assert!(matches!(error, DesignError::OutOfReach(_)), "{error}");
    assert!(error.to_string().contains("`a`") && error.to_string().contains("`b`"), "{error}");
    assert!(upright().weakest_direction().expect("states").is_controllable());
}

#[test]
fn units_of_inputs_do_not_matter_to_controllability() {
    let model = CartPole::default().linearise(0.0, [0.0, PI, 0.0, 0.0]).expect("smooth");
    let with_both = model.weakest_direction().expect("states").distance;
    let alone = upright().weakest_direction().expect("states").distance;
    // A second input never reduces controllability.
    assert!(with_both >= alone * (1.0 - 1e-12) && alone > 1e-3, "{with_both} {alone}");
}

/// Numbers from −1/2 to 1/2 by Knuth's linear congruential generator.
struct Generator(u64);

impl Generator {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / 2.0_f64.powi(53) - 0.5
    }

    /// Returns a full, sparse, badly scaled or antisymmetric matrix of one to six rows.
    fn matrix(&mut self, index: usize) -> DenseMatrix {
        let n = 1 + index % 6;
        let a = DenseMatrix::from_fn(n, n, |_, _| self.next());
        let entry = |i: usize, j: usize| match index / 6 % 4 {
            1 if i != j && a[(i, j)] < 0.2 => 0.0,
            2 => a[(i, j)] * 2.0_f64.powi(8 * (i as i32 - j as i32)),
            3 => a[(i, j)] - a[(j, i)],
            _ => a[(i, j)],
        };
        DenseMatrix::from_fn(n, n, entry)
    }
}

#[test]
fn a_thousand_matrices_have_the_eigenvalues_of_numpy() {
    let (mut generator, mut worst, mut rows) = (Generator(1), 0.0_f64, 0);
    for (index, line) in include_str!("eigenvalues.csv").lines().enumerate() {
        let numbers = line.split(',').map(|text| text.parse().expect("a number")).collect::<Vec<f64>>();
        let matrix = generator.matrix(index);
        let mut found = matrix.eigenvalues().expect("eigenvalues");
        assert_eq!(found.len(), matrix.rows());
        found.retain(|(_, imaginary)| *imaginary >= 0.0);
        let size = found.iter().fold(0.0, |most: f64, (real, imaginary)| most.max(real.hypot(*imaginary)));
        for wanted in numbers.chunks_exact(2) {
            let distance = |(real, imaginary): &(f64, f64)| (real - wanted[0]).hypot(imaginary - wanted[1]);
            let nearest = found.iter().map(distance).fold(f64::INFINITY, f64::min);
            worst = worst.max(nearest / size);
        }
        // Two equal eigenvalues may be a pair in one result and two real ones in the other.
        assert!(2 * found.len() >= numbers.len() - 2, "{index}: {found:?} {line}");
        rows += 1;
    }
    println!("the largest relative difference is {worst:e}");
    assert!(worst < 1e-10 && rows == 1000, "{worst} {rows}");
}
