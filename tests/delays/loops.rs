//! Loops with delayed feedback, beside Chebyshev collocation by `tools/delay.py`.

use lagrange::Simulate;
use lagrange::integrate::RungeKutta4;

lagrange::system! {
    /// An inverted pendulum balanced by a controller with a delayed measurement.
    #[derive(Debug)]
    struct Held;
    param m: kg = 1, l: m = 1, g: m/s^2 = 9.81, p: N*m = 30, d: N*m*s = 6, lag: s = 0.05;
    coord theta: rad = 0.3;
    kinetic = 1/2 * m * (l * dot(theta))^2;
    potential = m * g * l * cos(theta);
    force theta = -p * delay(theta, lag) - d * delay(dot(theta), lag);
}

/// Angle and velocity after each fifth of a second: `python3 tools/delay.py`.
const HELD: &str = include_str!("../references/delay.csv");

#[test]
fn a_delayed_controller_holds_a_pendulum_as_another_tool_says() {
    let held = Held::default();
    let motion =
        held.simulate(held.start()).until(4.0).every(0.2).tolerance(1e-12).with_history().run().unwrap();
    let mut compared = 0;
    for (index, line) in HELD.lines().skip(1).enumerate() {
        let numbers = line.split(',').map(|number| number.parse::<f64>().unwrap()).collect::<Vec<_>>();
        assert!((motion.times()[index] - numbers[0]).abs() < 1e-12);
        assert!((motion.theta()[index] - numbers[1]).abs() < 1e-11, "{line}");
        assert!((motion.theta_dot()[index] - numbers[2]).abs() < 1e-10, "{line}");
        compared += 1;
    }
    assert_eq!(compared, motion.len());
}

#[test]
fn a_later_measurement_lets_it_fall() {
    let held = Held { lag: 0.25, ..Held::default() };
    let motion = held.simulate(held.start()).until(4.0).with_history().run().unwrap();
    assert!(motion.theta().iter().any(|theta| theta.abs() > 1.5));
}

#[test]
fn fixed_steps_converge_with_their_order() {
    let held = Held::default();
    let expected = HELD.lines().nth(4).unwrap().split(',').nth(1).unwrap().parse::<f64>().unwrap();
    // The step does not divide the delay, but jumps still end steps.
    let errors = [0.014, 0.007, 0.0035].map(|step| {
        let run = held.simulate(held.start()).until(0.6).with_history().method(RungeKutta4 { step });
        (run.run().unwrap().last()[0] - expected).abs()
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((3.5..5.0).contains(&order), "{order} of {errors:?}");
    }
}
