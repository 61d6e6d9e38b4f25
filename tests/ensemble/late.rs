//! Noise beside delayed signals: statistics against closed forms, and orders along one path.

use std::array::from_fn;

use lagrange::ensemble::Moments;
use lagrange::integrate::{EulerMaruyama, Method, StochasticRungeKutta4, WienerPath};
use lagrange::simulate::Remembering;
use lagrange::system::{DelayedSystem, MechanicalSystem};
use lagrange::{Ensembles, Simulate};

use super::shortened;

lagrange::system! {
    /// A process that is drawn back to its earlier value.
    #[derive(Clone, Debug)]
    struct Late;

    param k = 1, lag = 0.5;
    state x;
    noise w, density: 1;
    dot(x) = -k * delay(x, lag) + w;
}

lagrange::system! {
    /// A process whose noise has the magnitude of its earlier value.
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

/// The stationary variance is `(1 + sin kτ)/(2 k cos kτ)` for the density 1. See Küchler, Mensch,
/// "Langevins stochastic differential equation extended by a time-delayed term", *Stochastics and
/// Stochastics Reports* 40 (1992) 23–42.
#[test]
fn a_delayed_drift_has_its_stationary_variance() {
    let late = Late::default();
    let motions = late.ensemble(shortened(1500)).start(|_, _| [0.0]).until(12.0).with_history();
    let squares = motions
        .method(runge_kutta(0.0625, WienerPath::of_seed(5)))
        .reduce(Moments::new(), |squares, motion| add_square(squares, motion.end().x))
        .expect("runs")
        .into_value();
    assert_mean(&squares, (1.0 + 0.5_f64.sin()) / (2.0 * 0.5_f64.cos()));
}

/// E x² is (1 + e^(−2t))/2 up to one, and then obeys d/dt E x² = −2 E x² + (1 + e^(−2(t−1)))/2. The
/// past does not correlate with future noise, so the equations of Itô and Stratonovich agree.
#[test]
fn a_delayed_diffusion_has_its_mean_square() {
    let echo = Echo::default();
    let motions = echo.ensemble(1500).start(|_, _| [1.0]).until(2.0).with_history();
    let squares = motions
        .method(euler(1.0 / 64.0, WienerPath::of_seed(9)))
        .reduce(Moments::new(), |squares, motion| add_square(squares, motion.end().x))
        .expect("runs")
        .into_value();
    let decay = (-2.0_f64).exp();
    assert_mean(&squares, ((1.0 + decay) / 2.0 - 0.25) * decay + 0.25 + decay / 2.0);
}

/// Returns the end of a motion with steps of 1/8 that are halved several times, as is its path.
fn end<M, K>(late: &M, halvings: u32, motion: usize, method: fn(f64, WienerPath) -> K) -> f64
where
    M: DelayedSystem + MechanicalSystem<Scalar = f64, State = [f64; 1]>,
    K: Method<Remembering<M>>,
{
    let (step, path) = (0.125 / f64::from(1 << halvings), WienerPath::of_seed(3).of_motion(motion));
    let run = late.simulate([0.5]).until(2.0).with_history().method(method(step, path.halved(halvings)));
    run.run().map_err(|error| error.cause).expect("moves").last()[0]
}

/// Returns the strong orders of both methods between steps of 1/16 and 1/64, from this number of
/// motions.
fn strong_orders<M>(late: &M, motions: usize) -> [f64; 2]
where
    M: DelayedSystem + MechanicalSystem<Scalar = f64, State = [f64; 1]>,
{
    let errors = |motion| {
        let exact = end(late, 7, motion, runge_kutta);
        [1, 3].map(|halvings| {
            let ends = [end(late, halvings, motion, euler), end(late, halvings, motion, runge_kutta)];
            ends.map(|end| (end - exact).powi(2))
        })
    };
    let [long, short] = (0..motions).map(errors).fold([[0.0; 2]; 2], |sums, squares| {
        from_fn(|step| from_fn(|method| sums[step][method] + squares[step][method]))
    });
    from_fn(|method| (long[method] / short[method]).log2() / 4.0)
}

/// The strong order is one, whether steps divide the delay or not.
#[test]
fn a_delayed_drift_has_the_strong_order_one() {
    for late in [Late::default(), Late { lag: 0.3, ..Late::default() }] {
        let orders = strong_orders(&late, shortened(40));
        assert!(orders.iter().all(|order| (0.8..2.6).contains(order)), "{orders:?} for {late:?}");
    }
}

/// The factor is x(t − 1) during a step from t. The error ∫ (x(s − 1) − x(t − 1)) dW is of the
/// order h, and independent from step to step.
#[test]
fn a_delayed_diffusion_has_the_strong_order_one_half() {
    let orders = strong_orders(&Echo::default(), 20);
    assert!(orders.iter().all(|order| (order - 0.5).abs() < 0.2), "{orders:?}");
}

#[test]
fn missing_features_are_reported() {
    let late = Late::default();
    let method = runge_kutta(0.1, WienerPath::of_seed(1));
    let error = late.simulate([1.0]).until(1.0).method(method).run().map(drop).expect_err("has delays");
    assert!(error.to_string().contains("`.with_history()`"), "{error}");
    let error = late.simulate([1.0]).until(1.0).with_history().run().map(drop).expect_err("has noise");
    assert!(error.to_string().contains("`EulerMaruyama` and `StochasticRungeKutta4`"), "{error}");
}
