//! Tables in declarations: emitted code against the interpreter and against differences.

use lagrange::Simulate;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, parse};

/// Declares a system, and keeps its statements as text.
macro_rules! declared_twice {
    ($name:ident, $text:ident; $($statements:tt)*) => {
        lagrange::system! {
            #[derive(Clone, Debug)]
            struct $name;
            $($statements)*
        }
        const $text: &str = stringify!($($statements)*);
    };
}

declared_twice! { Wheel, WHEEL;
    param m = 12, j = 0.4, r = 0.3, g = 9.81;
    coord s;
    table motor(rate) = [(0, 90), (100, 140), (200, 120), (300, 60)], interpolation: monotone, outside: clamp;
    table brake(rate) = [(-2, 1), (0, 0), (1, 1/2), (5, 1)], interpolation: linear, outside: extend;
    table road(s) = [(0, 0), (3, 0.4), (8, 0.1), (14, -0.2), (20, 0)], interpolation: natural, outside: extend;
    table drag(speed, height) = [
        (0, -1, 0), (0, 1, 0.5), (10, -1, 3), (10, 1, 2.5), (30, -1, 25), (30, 1, 22)
    ], interpolation: natural, outside: error;
    table slip(s, speed) = [[0, 1, 1], [2, 2, 5], [3, 4, 9]],
        rows: [0, 4, 12], columns: [0, 10, 20], interpolation: monotone, outside: extend;
    let height = road(s);
    kinetic = kinetic_energy(m, dot((s, height))) + kinetic_energy(j, dot(s) / r);
    potential = m * g * height;
    force s = motor(dot(s) / r) / r - brake(dot(s)) - drag(dot(s), height) - slip(s, dot(s));
    output slips = slip(s, dot(s));
    emit { jacobian }
}

lagrange::system! {
    /// A mass on the spring of a table, in any number type.
    struct Sprung<S>;
    table energy(x) = [(-1, 5), (0, 0), (1, 4), (3, 20)], interpolation: natural, outside: extend;
    coord x;
    kinetic = kinetic_energy(2, dot(x));
    potential = energy(x);
}

lagrange::system! {
    /// A wheel pulled along the road of an example, from a file.
    #[derive(Clone, Debug)]
    struct Pulled;
    table road(x) = "../examples/data/road.csv", interpolation: natural, outside: error;
    coord x;
    kinetic = kinetic_energy(1, dot((x, road(x))));
    potential = 9.81 * road(x);
    force x = 3;
}

lagrange::system! {
    /// A crank on an engine, whose map is in a file.
    struct Driven;
    table map(speed, throttle) = "api/engine.csv", interpolation: monotone, outside: clamp;
    coord throttle;
    kinetic = kinetic_energy(1, dot(throttle));
    output moment = map(dot(throttle), throttle);
}

fn interpreted() -> NumericSystem {
    let derived = parse(WHEEL).and_then(|system| system.derive(StrategyChoice::Cheapest));
    NumericSystem::new(&derived.expect("a correct declaration"))
}

#[test]
fn the_interpreter_computes_the_same_bits() {
    let (wheel, interpreted) = (Wheel::default(), interpreted());
    for i in 0..200 {
        let (s, v) = (-2.0 + 0.123 * f64::from(i), 30.0 * f64::from(i * 37 % 200) / 200.0);
        let found = wheel.acceleration(0.0, &[s], &[v]);
        assert!(found[0].is_finite(), "{s} {v}");
        assert_eq!(found[0].to_bits(), interpreted.acceleration(0.0, &[s], &[v])[0].to_bits(), "{s} {v}");
        let jacobian = interpreted.product(Product::Jacobian, 0.0, &[s], &[v]).expect("it was asked for");
        let emitted = wheel.jacobian(0.0, &[s, v]);
        assert_eq!(emitted[1], jacobian[..], "{s} {v}");
    }
}

#[test]
fn jacobians_go_through_tables() {
    let wheel = Wheel::default();
    let at = |s: f64, v: f64| wheel.acceleration(0.0, &[s], &[v])[0];
    let h = 1e-5;
    for (s, v) in [(1.3, 2.0), (7.7, 12.5), (15.0, 29.0), (22.0, 0.4)] {
        let jacobian = wheel.jacobian(0.0, &[s, v])[1];
        let differences =
            [(at(s + h, v) - at(s - h, v)) / (2.0 * h), (at(s, v + h) - at(s, v - h)) / (2.0 * h)];
        for (found, difference) in jacobian.into_iter().zip(differences) {
            assert!((found - difference).abs() < 1e-7 * found.abs().max(1.0), "{found} or {difference}");
        }
    }
}

/// The moment in the file falls with speed and rises with throttle. At full throttle it is
/// constant.
#[test]
fn monotone_maps_from_files_and_from_matrices_do_not_overshoot() {
    let wheel = Wheel::default();
    let moment = |speed: f64, throttle: f64| Driven.moment(0.0, &[throttle], &[speed]);
    assert_eq!([moment(10.0, 0.5), moment(25.0, 0.0), moment(25.0, 1.0)], [60.0, -5.5, 90.0]);
    assert!((moment(17.5, 1.0) - 90.0).abs() < 1e-13 && moment(40.0, 2.0) == 90.0);
    let slips = |s: f64, speed: f64| wheel.slips(0.0, &[s], &[speed]);
    for i in 0..120 {
        for j in 0..50 {
            let [a, b] = [0.1 * f64::from(i), 0.4 * f64::from(j)];
            let [speed, throttle] = [31.0 * a / 12.0, b / 20.0];
            assert!(moment(speed + 0.2, throttle) <= moment(speed, throttle) + 1e-12, "{speed}, {throttle}");
            assert!(moment(speed, throttle + 0.01) >= moment(speed, throttle) - 1e-12, "{speed}, {throttle}");
            assert!(slips(a + 0.1, b) >= slips(a, b) && slips(a, b + 0.4) >= slips(a, b) - 1e-14, "{a}, {b}");
        }
    }
}

#[test]
fn single_precision_has_the_same_tables() {
    let (single, double) = (Sprung::<f32>::default(), Sprung::<f64>::default());
    for x in [-1.5, -0.4, 0.0, 0.99, 2.5, 4.0] {
        let [a, b] = [
            single.acceleration(0.0, &[x], &[0.0])[0],
            double.acceleration(0.0, &[f64::from(x)], &[0.0])[0] as f32,
        ];
        assert!((a - b).abs() < 1e-5, "{a} or {b} at {x}");
    }
}

#[test]
fn energy_is_kept_on_a_road_from_a_file() {
    let pulled = Pulled;
    let run = pulled.simulate([0.0, 0.0]).until(5.0).tolerance(1e-12).run().expect("it stays on the road");
    let [x, v] = run.last();
    let gained = pulled.energy(5.0, &[x], &[v]) - pulled.energy(0.0, &[0.0], &[0.0]);
    // Accelerations have kinks at every point of the table, 150 of which are passed.
    assert!((gained - 3.0 * x).abs() < 1e-6, "{gained} instead of {}", 3.0 * x);
}

#[test]
fn a_run_that_leaves_its_table_ends_with_an_error() {
    let run = Pulled.simulate([49.0, 2.0]).until(5.0).tolerance(1e-9).run();
    let error = run.expect_err("the road ends at 50 m");
    assert!(error.to_string().contains("`x_ddot` is NaN"), "{error}");
}
