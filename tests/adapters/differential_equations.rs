//! Systems in the hands of `differential-equations`.

use differential_equations::ivp::IVP;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::ODE;

use lagrange::adapt::differential_equations::Adapter;
use lagrange::system::OdeSystem;

/// ẏ = (y₂, −sin y₁ − t y₂), with or without a Jacobian.
struct Damped {
    knows_jacobian: bool,
}

impl OdeSystem for Damped {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
        [y[1], -y[0].sin() - t * y[1]]
    }

    fn jacobian(&self, t: f64, y: &[f64; 2]) -> Option<[[f64; 2]; 2]> {
        self.knows_jacobian.then(|| [[0.0, 1.0], [-y[0].cos(), -t]])
    }
}

fn jacobian(knows_jacobian: bool) -> [[f64; 2]; 2] {
    let mut matrix = Matrix::zeros(2, 2);
    Adapter(&Damped { knows_jacobian }).jacobian(0.5, &[0.3, -2.0], &mut matrix);
    [[matrix[(0, 0)], matrix[(0, 1)]], [matrix[(1, 0)], matrix[(1, 1)]]]
}

#[test]
fn a_known_jacobian_arrives_as_it_is() {
    assert_eq!(jacobian(true), [[0.0, 1.0], [-0.3_f64.cos(), -0.5]]);
}

#[test]
fn an_unknown_jacobian_is_differenced_to_nine_digits() {
    for (found, exact) in jacobian(false).as_flattened().iter().zip(jacobian(true).as_flattened()) {
        assert!((found - exact).abs() < 1e-9, "{found} is not {exact}");
    }
}

#[test]
fn explicit_and_implicit_solvers_agree() {
    let system = Damped { knows_jacobian: true };
    let adapter = Adapter(&system);
    let explicit = ExplicitRungeKutta::dop853().rtol(1e-11).atol(1e-11);
    let implicit = ImplicitRungeKutta::radau5().rtol(1e-9).atol(1e-9);
    let end = |y: Vec<[f64; 2]>| *y.last().expect("the end is kept");
    let one = end(IVP::ode(&adapter, 0.0, 3.0, [1.0, 0.0]).method(explicit).solve().expect("solved").y);
    let other = end(IVP::ode(&adapter, 0.0, 3.0, [1.0, 0.0]).method(implicit).solve().expect("solved").y);
    assert!((one[0] - other[0]).abs() < 1e-7 && (one[1] - other[1]).abs() < 1e-7, "{one:?} is not {other:?}");
}
