//! Noise beside delayed signals: statistics against closed forms, and orders along one path.

use lagrange::ensemble::Moments;
use lagrange::integrate::{EulerMaruyama, StochasticRungeKutta4, WienerPath};
use lagrange::{Ensembles, Simulate};

lagrange::system! {
    /// A process that is drawn back to where it was.
    #[derive(Clone, Debug)]
    struct Late;

    param k = 1, lag = 0.5;
    state x;
    noise w, density: 1;
    dot(x) = -k * delay(x, lag) + w;
}

lagrange::system! {
    /// A process whose noise is as large as it was.
    #[derive(Clone, Debug)]
    struct Echo;

    state x = 1;
    noise w, density: 1;
    let before = delay(x, 1);
    dot(x) = -x + before * w;
}

fn euler(step: f64, path: WienerPath) -> EulerMaruyama<f64> {
    EulerMaruyama { step, path }
}

fn runge_kutta(step: f64, path: WienerPath) -> StochasticRungeKutta4<f64> {
    StochasticRungeKutta4 { step, path }
}

/// Adds the square of a number.
fn add_square(squares: &mut Moments, x: f64) {
    squares.add(x * x);
}

/// Asserts a mean within three standard errors, which are small.
fn assert_mean(numbers: &Moments, exact: f64) {
    let error = 3.0 * numbers.standard_deviation() / (numbers.count() as f64).sqrt();
    let mean = numbers.mean();
    assert!((mean - exact).abs() < error && error < 0.25 * exact, "{mean}, not {exact}, within {error}");
}

/// The stationary variance (1 + sin kτ)/(2 k cos kτ) for the density 1 (Küchler, Mensch,
/// "Langevins stochastic differential equation extended by a time-delayed term", *Stochastics and
/// Stochastics Reports* 40 (1992) 23–42).
#[test]
fn a_delayed_drift_has_its_stationary_variance() {
    let late = Late::default();
    let motions = late.ensemble(3000).start(|_, _| [0.0]).until(12.0).with_history();
    let squares = motions
        .method(runge_kutta(0.0625, WienerPath::of_seed(5)))
        .reduce(Moments::new(), |squares, motion| add_square(squares, motion.end().x))
        .expect("runs")
        .into_value();
    assert_mean(&squares, (1.0 + 0.5_f64.sin()) / (2.0 * 0.5_f64.cos()));
}

/// E x² is (1 + e^(−2t))/2 up to one, and then obeys d/dt E x² = −2 E x² + (1 + e^(−2(t−1)))/2:
/// what was does not correlate with what comes, so that the equations of Itô and Stratonovich
/// agree.
#[test]
fn a_delayed_diffusion_has_its_mean_square() {
    let echo = Echo::default();
    let motions = echo.ensemble(3000).start(|_, _| [1.0]).until(2.0).with_history();
    let squares = motions
        .method(euler(1.0 / 64.0, WienerPath::of_seed(9)))
        .reduce(Moments::new(), |squares, motion| add_square(squares, motion.end().x))
        .expect("runs")
        .into_value();
    let decay = (-2.0_f64).exp();
    assert_mean(&squares, ((1.0 + decay) / 2.0 - 0.25) * decay + 0.25 + decay / 2.0);
}

/// The strong orders of both methods between steps of 1/16 and of 1/64, from the ends of motions by
/// a method with a step along a path.
fn orders(ends: [&dyn Fn(f64, WienerPath) -> f64; 2]) -> [f64; 2] {
    let mut squares = [[0.0; 2]; 2];
    for motion in 0..60 {
        let path = WienerPath::of_seed(3).of_motion(motion);
        let end = |method: usize, halvings: u32| {
            ends[method](0.125 / f64::from(1 << halvings), path.halved(halvings))
        };
        let exact = end(1, 7);
        for (method, squares) in squares.iter_mut().enumerate() {
            for (square, halvings) in squares.iter_mut().zip([1, 3]) {
                *square += (end(method, halvings) - exact).powi(2);
            }
        }
    }
    squares.map(|[long, short]| (long / short).log2() / 4.0)
}

/// Whether steps divide the delay or not.
#[test]
fn a_delayed_drift_has_the_strong_order_one() {
    for lag in [0.5, 0.3] {
        let late = Late { lag, ..Late::default() };
        let run = || late.simulate([0.5]).until(2.0).with_history();
        let found = orders([
            &|step, path| run().method(euler(step, path)).run().expect("moves").last()[0],
            &|step, path| run().method(runge_kutta(step, path)).run().expect("moves").last()[0],
        ]);
        assert!(found.iter().all(|order| (order - 1.0).abs() < 0.25), "{found:?} for a delay of {lag}");
    }
}

/// Values of a delayed factor within a step are noise of their own.
#[test]
fn a_delayed_diffusion_has_the_strong_order_one_half() {
    let echo = Echo::default();
    let run = || echo.simulate([1.0]).until(2.0).with_history();
    let found = orders([
        &|step, path| run().method(euler(step, path)).run().expect("moves").last()[0],
        &|step, path| run().method(runge_kutta(step, path)).run().expect("moves").last()[0],
    ]);
    assert!(found.iter().all(|order| (order - 0.5).abs() < 0.25), "{found:?}");
}

#[test]
fn what_is_missing_is_said() {
    let late = Late::default();
    let method = runge_kutta(0.1, WienerPath::of_seed(1));
    let error = late.simulate([1.0]).until(1.0).method(method).run().map(drop).expect_err("has delays");
    assert!(error.to_string().contains("`.with_history()`"), "{error}");
    let error = late.simulate([1.0]).until(1.0).with_history().run().map(drop).expect_err("has noise");
    assert!(error.to_string().contains("`EulerMaruyama` and `StochasticRungeKutta4`"), "{error}");
}
