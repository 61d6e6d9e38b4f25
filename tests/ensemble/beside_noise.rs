//! Features that combine with noise, and those that refuse it.

use lagrange::Simulate;
use lagrange::integrate::{EulerMaruyama, RungeKutta4, StochasticRungeKutta4, WienerPath};
use lagrange::system::OdeSystem;

lagrange::system! {
    /// A spring in a liquid, with features that use its equations without noise.
    #[derive(Clone, Debug)]
    struct Shaken;
    param k = 4, size = 0.5;
    coord x = 1;
    noise w, density: size^2;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * dot(x)^2;
    force x = w;
    emit { tests, jacobian }
}

/// Laws of emitted tests, the Jacobian and handwritten rates are those without noise.
#[test]
fn equations_by_hand_are_those_without_noise() {
    let shaken = Shaken::default();
    assert_eq!(shaken.rhs(0.0, &[1.0, 1.0]), [1.0, -5.0]);
    assert_eq!(shaken.jacobian(0.0, &[1.0, 1.0]), [[0.0, 1.0], [-4.0, -1.0]]);
    assert_eq!(shaken.diffuse(0.0, &[1.0, 1.0], &[1.0]), [0.0, 0.5]);
}

#[test]
fn derivatives_do_not_go_through_noise() {
    let (shaken, said) = (Shaken::default(), "derivatives do not go through white noise");
    let run = || shaken.simulate([1.0, 0.0]).until(1.0);
    let error = run().sensitivities(["k"]).run().map(drop).expect_err("has noise").to_string();
    assert!(error.contains(said), "{error}");
    let method = EulerMaruyama { step: 0.1, path: WienerPath::of_seed(1) };
    let error =
        run().sensitivities(["size"]).method(method).run().map(drop).expect_err("has noise").to_string();
    assert!(error.contains(said), "{error}");
    let method = RungeKutta4 { step: 0.1 };
    let error = run().method(method).gradient(["k"], |_, [x, _], _| *x).expect_err("has noise").to_string();
    assert!(error.contains(said), "{error}");
}

lagrange::system! {
    /// A state whose noise is multiplied by an input.
    #[derive(Clone)]
    struct Scaled;
    input u;
    state z = 1;
    noise w, density: 0.25;
    dot(z) = u * w;
}

/// A feedback law makes the input a function of the state; the solution is in the sense of
/// Stratonovich.
#[test]
fn laws_make_noise_multiplicative() {
    let scaled = Scaled::default();
    let path = WienerPath::of_seed(3);
    let law = |_: &Scaled, _: f64, y: ScaledState| ScaledInputs { u: y.z };
    let end = |halvings: u32| {
        let method =
            StochasticRungeKutta4 { step: 0.0625 / f64::from(1 << halvings), path: path.halved(halvings) };
        scaled.simulate([1.0]).until(4.0).method(method).drive(law).run().unwrap().last()[0]
    };
    lagrange::system! {
        /// The law and the state as one equation.
        struct Grown;
        state z = 1;
        noise w, density: 0.25;
        dot(z) = z * w;
    }
    let method = StochasticRungeKutta4 { step: 0.0625 / 16.0, path: path.halved(4) };
    let declared = Grown.simulate([1.0]).until(4.0).method(method).run().unwrap().last()[0];
    assert!((end(4) - declared).abs() < 1e-12, "{} {declared}", end(4));
    assert!((end(0) - declared).abs() < 0.1);
    let euler = scaled.simulate([1.0]).until(4.0).method(EulerMaruyama { step: 0.01, path }).drive(law).run();
    assert!(euler.is_err());
}
