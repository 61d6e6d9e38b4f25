//! What noise goes with, and what refuses it.

use lagrange::Simulate;
use lagrange::integrate::{EulerMaruyama, RungeKutta4, WienerPath};
use lagrange::system::OdeSystem;

lagrange::system! {
    /// A spring in a liquid, with what its equations without noise are used for.
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

/// The laws of emitted tests, the Jacobian and rates by hand are those without noise.
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
