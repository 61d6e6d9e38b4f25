//! A system for the crate `differential-equations`: two trait methods, to copy.
//!
//! Its solvers take any implementation of [`ODE`]. Implicit ones receive the Jacobian emitted for
//! `emit { jacobian }`, and use differences without it. Constraints and the length of unit
//! quaternions are kept as accurately as that crate integrates: nothing is projected. The quantity
//! to watch is the energy, which both solvers conserve.

use std::error::Error;

use differential_equations::ivp::IVP;
use differential_equations::linalg::Matrix;
use differential_equations::methods::{ExplicitRungeKutta, ImplicitRungeKutta};
use differential_equations::ode::ODE;
use differential_equations::traits::{Real, State};
use lagrange::system::OdeSystem;

lagrange::system! {
    pub struct Pendulum;
    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -9.81 * cos(theta);
    emit { jacobian }
}

/// A borrowed system for the solvers.
struct Adapter<'a, M>(&'a M);

impl<M> ODE<M::Scalar, M::State> for Adapter<'_, M>
where
    M: OdeSystem<Scalar: Real, State: State<<M as OdeSystem>::Scalar>>,
{
    fn diff(&self, t: M::Scalar, y: &M::State, rate: &mut M::State) {
        *rate = self.0.rhs(t, y);
    }

    fn jacobian(&self, t: M::Scalar, y: &M::State, matrix: &mut Matrix<M::Scalar>) {
        let Some(rows) = self.0.jacobian(t, y) else { return Differenced(self.0).jacobian(t, y, matrix) };
        for (i, row) in rows.as_ref().iter().enumerate() {
            for (j, entry) in row.as_ref().iter().enumerate() {
                matrix[(i, j)] = *entry;
            }
        }
    }
}

/// A borrowed system whose Jacobian the solvers approximate by differences.
struct Differenced<'a, M>(&'a M);

impl<M> ODE<M::Scalar, M::State> for Differenced<'_, M>
where
    M: OdeSystem<Scalar: Real, State: State<<M as OdeSystem>::Scalar>>,
{
    fn diff(&self, t: M::Scalar, y: &M::State, rate: &mut M::State) {
        *rate = self.0.rhs(t, y);
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let pendulum = Pendulum;
    let adapter = Adapter(&pendulum);
    let explicit = ExplicitRungeKutta::dop853().rtol(1e-11).atol(1e-11);
    let implicit = ImplicitRungeKutta::radau5().rtol(1e-9).atol(1e-9);
    let problem = || IVP::ode(&adapter, 0.0, 10.0, [1.0, 0.0]);
    let ends = [problem().method(explicit).solve(), problem().method(implicit).solve()];
    for (name, end) in ["DOP853", "Radau 5"].into_iter().zip(ends) {
        let mut solution = end.map_err(|error| format!("{name}: {error:?}"))?;
        let [theta, rate] = solution.y.pop().ok_or("no state is kept")?;
        let error = pendulum.energy(10.0, &[theta], &[rate]) - pendulum.energy(0.0, &[1.0], &[0.0]);
        println!("{name}: θ = {theta:.8}, energy changed by {error:.1e}");
        assert!(error.abs() < 1e-5, "the energy of the pendulum is constant");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Adapter, Matrix, ODE, OdeSystem, main};

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
    fn an_unknown_jacobian_is_differenced() {
        for (found, exact) in jacobian(false).as_flattened().iter().zip(jacobian(true).as_flattened()) {
            assert!((found - exact).abs() < 1e-7, "{found} is not {exact}");
        }
    }

    #[test]
    fn explicit_and_implicit_solvers_keep_the_energy() {
        main().expect("both solvers reach the end");
    }
}
