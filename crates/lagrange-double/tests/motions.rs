//! Motions with thirty digits.

use lagrange::integrate::{Method, Radau5, RungeKutta4, Taylor, Verner98, integrate};
use lagrange::system::OdeSystem;
use lagrange_double::Double;
use lagrange_runtime::{Number, Scalar};

lagrange::system! {
    #[derive(Clone, Debug)]
    struct DoublePendulum<S>;

    param m1 = 1, m2 = 1, l1 = 1, l2 = 1, g = 9.81;
    coord theta1, theta2;
    let (x1, y1) = (l1 * sin(theta1), -l1 * cos(theta1));
    let (x2, y2) = (x1 + l2 * sin(theta2), y1 - l2 * cos(theta2));
    kinetic = 1/2 * m1 * (dot(x1)^2 + dot(y1)^2) + 1/2 * m2 * (dot(x2)^2 + dot(y2)^2);
    potential = m1 * g * y1 + m2 * g * y2;
    emit { taylor }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Pendulum<S>;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
    emit { taylor }
}

fn read(text: &str) -> Double {
    text.parse().expect("a number")
}

/// Returns a state of `tools/references.py`, from its printed decimals.
fn state(system: &str, t: &str) -> [Double; 4] {
    let rows = include_str!("../../../tests/references/states.csv").lines();
    let start = format!("{system},decimal,{t},");
    let mut values =
        rows.filter_map(|row| row.strip_prefix(&start)).map(|row| read(row.split_once(',').unwrap().1));
    core::array::from_fn(|_| values.next().expect("four components"))
}

fn end<M: OdeSystem<Scalar = Double>>(
    system: &M,
    start: M::State,
    t: f64,
    method: &impl Method<M>,
) -> M::State {
    integrate(system, Double::ZERO, start, Double::from(t), method, |_, _| {}).expect("reaches the end")
}

fn error(found: &[Double], wanted: &[Double]) -> f64 {
    found
        .iter()
        .zip(wanted)
        .fold(0.0, |largest, (found, wanted)| f64::from((*found - *wanted).abs()).max(largest))
}

#[test]
fn the_double_pendulum_is_right_to_26_digits() {
    let system = DoublePendulum { g: read("9.81"), ..DoublePendulum::default() };
    let (start, wanted) = (state("double_pendulum", "0.0"), state("double_pendulum", "10.0"));
    let tolerance = read("1e-31");
    let found = end(&system, start, 10.0, &Taylor { order: Some(40), ..Taylor::tolerance(tolerance) });
    let error = error(&found, &wanted);
    assert!(error < 1e-26, "{error:e}");
}

/// Returns the energy, which is known in closed form for any amplitude.
fn energy([angle, speed]: [Double; 2]) -> Double {
    Double::from(0.5) * speed * speed - angle.cos()
}

#[test]
fn equal_steps_converge_with_their_order() {
    let start = [Double::from(0.5), Double::ZERO];
    let exact = end(
        &Pendulum::default(),
        start,
        1.0,
        &Taylor { order: Some(40), ..Taylor::tolerance(read("1e-30")) },
    );
    assert!(f64::from((energy(exact) - energy(start)).abs()) < 1e-29);
    let errors = [64.0, 128.0].map(|steps| {
        let method = RungeKutta4 { step: Double::ONE / Double::from(steps) };
        error(&end(&Pendulum::default(), start, 1.0, &method), &exact)
    });
    let order = (errors[0] / errors[1]).log2();
    assert!((3.9..4.1).contains(&order), "{order}");
}

#[test]
fn the_adaptive_pair_is_as_accurate_as_its_coefficients() {
    let start = [Double::from(0.5), Double::ZERO];
    let exact = end(
        &Pendulum::default(),
        start,
        1.0,
        &Taylor { order: Some(40), ..Taylor::tolerance(read("1e-30")) },
    );
    let found = end(&Pendulum::default(), start, 1.0, &Verner98::tolerance(read("1e-18")));
    let error = error(&found, &exact);
    assert!(error < 1e-15, "{error:e}");
}

#[test]
fn tolerances_below_the_coefficients_are_refused() {
    let (system, start, second) = (Pendulum::default(), [Double::from(0.5), Double::ZERO], Double::ONE);
    let pair = Verner98::tolerance(read("1e-20"));
    let implicit = Radau5::tolerance(read("1e-18"));
    let messages = [
        integrate(&system, Double::ZERO, start, second, &pair, |_, _| {}).map_err(|error| error.to_string()),
        integrate(&system, Double::ZERO, start, second, &implicit, |_, _| {})
            .map_err(|error| error.to_string()),
    ];
    let messages = messages.map(|refused| refused.expect_err("refuses the tolerance"));
    assert!(messages.iter().all(|message| message.contains("use `Taylor`")), "{messages:?}");
    // In double precision the same tolerances stand for rounding.
    let pair = Verner98::tolerance(1e-20);
    integrate(&Pendulum::default(), 0.0, [0.5, 0.0], 1.0, &pair, |_, _| {}).expect("runs to rounding");
}

#[test]
fn the_spacing_at_one_is_not_lost() {
    let three = Double::from(3.0);
    let spacing = (three * (Double::from(4.0) / three - Double::ONE) - Double::ONE).abs();
    assert!(Double::ZERO < spacing && spacing < Double::epsilon());
}

lagrange::system! {
    /// A mass pushed by a table of time against a spring with a power as its energy. Numbers of the
    /// table are exact in binary.
    #[derive(Clone, Debug)]
    struct Pushed<S>;

    param n = 7/4, stiff = 0;
    coord x;
    table push(time) = [(1, 0), (2, 6), (4, -2), (8, 0)], interpolation: linear, outside: clamp;
    kinetic = 1/2 * dot(x)^2;
    potential = stiff * pow(1 + x^2, n);
    force x = push(t);
    emit { taylor }
}

#[test]
fn tables_and_powers_have_thirty_digits() {
    let exact = Taylor { order: Some(40), ..Taylor::tolerance(read("1e-29")) };
    let free = Pushed::<Double>::default();
    let [x, v] = integrate(&free, Double::ZERO, [Double::ZERO; 2], read("9"), &exact, |_, _| {}).unwrap();
    let wanted = [read("34"), read("3")];
    assert!((x - wanted[0]).abs() < read("1e-28") && (v - wanted[1]).abs() < read("1e-28"), "{x} {v}");

    let held = Pushed { stiff: Double::ONE, ..free };
    let energy = |[x, v]: [Double; 2]| v * v / read("2") + (Double::ONE + x * x).powf(held.n);
    let start = [read("0.3"), Double::ZERO];
    // The table pushes from t = 1 on.
    let end = integrate(&held, read("-5"), start, Double::ONE, &exact, |_, _| {}).unwrap();
    let change = (energy(end) - energy(start)).abs();
    assert!(change < read("1e-27") && (end[0] - start[0]).abs() > read("0.01"), "{change}");
}
