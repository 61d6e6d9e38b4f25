//! Integrations by other crates.

use differential_equations::methods::ExplicitRungeKutta;
use differential_equations::ode::{ODE, OrdinaryNumericalMethod, solve_ode};
use differential_equations::prelude::{ControlFlag, Interpolation, Solout, Solution};
use ode_solvers::{Dop853, OutputType, SVector, System};

use crate::problem::{Motion, Run, Solver};

/// A handwritten right-hand side.
#[derive(Clone, Copy)]
pub(crate) struct ByHand<F>(pub(crate) F);

impl<F: Fn(&[f64; 4]) -> [f64; 4]> ODE<f64, [f64; 4]> for ByHand<F> {
    #[inline]
    fn diff(&self, _t: f64, y: &[f64; 4], rate: &mut [f64; 4]) {
        *rate = (self.0)(y);
    }
}

impl<F: Fn(&[f64; 4]) -> [f64; 4]> System<f64, SVector<f64, 4>> for ByHand<F> {
    #[inline]
    fn system(&self, _t: f64, y: &SVector<f64, 4>, rate: &mut SVector<f64, 4>) {
        *rate = SVector::from((self.0)(y.as_ref()));
    }
}

/// An output that keeps no points, since the others need not either.
struct Nothing;

impl Solout<f64, [f64; 4]> for Nothing {
    fn solout<I>(
        &mut self,
        _: f64,
        _: f64,
        _: &[f64; 4],
        _: &[f64; 4],
        _: &mut I,
        _: &mut Solution<f64, [f64; 4]>,
    ) -> ControlFlag<f64, [f64; 4]>
    where
        I: Interpolation<f64, [f64; 4]> + ?Sized,
    {
        ControlFlag::Continue
    }
}

const MANY_STEPS: usize = 10_000_000;

/// Returns the high-order solvers of these crates.
pub(crate) fn all<F>(system: &ByHand<F>, motion: Motion) -> Vec<Solver>
where
    F: Fn(&[f64; 4]) -> [f64; 4] + Copy + 'static,
{
    let system = *system;
    macro_rules! differential_equations {
        ($name:literal, $method:ident) => {
            peer($name, move |tolerance| {
                let method = ExplicitRungeKutta::$method().rtol(tolerance).atol(tolerance);
                differential_equations(method.max_steps(MANY_STEPS), &system, motion)
            })
        };
    }
    vec![
        differential_equations!("differential-equations rkv98", rkv988e),
        differential_equations!("differential-equations rkv98, order 9 dense", rkv989e),
        differential_equations!("differential-equations DOP853", dop853),
        peer("ode_solvers DOP853", move |tolerance| ode_solvers(system, motion, tolerance)),
    ]
}

fn peer(name: &'static str, run: impl Fn(f64) -> Option<Run> + 'static) -> Solver {
    Solver { name, is_peer: true, run: Box::new(run) }
}

fn differential_equations<K, F>(mut method: K, system: &ByHand<F>, motion: Motion) -> Option<Run>
where
    K: OrdinaryNumericalMethod<f64, [f64; 4]> + Interpolation<f64, [f64; 4]>,
    F: Fn(&[f64; 4]) -> [f64; 4],
{
    let solution = solve_ode(&mut method, system, 0.0, motion.end, &motion.start, &mut Nothing).ok()?;
    Some(Run { state: *method.y(), evaluations: solution.evals.function as u64 })
}

fn ode_solvers<F>(system: ByHand<F>, motion: Motion, tolerance: f64) -> Option<Run>
where
    F: Fn(&[f64; 4]) -> [f64; 4],
{
    let Motion { start, end } = motion;
    let mut solver = Dop853::from_param(
        system,
        0.0,
        end,
        0.0,
        SVector::from(start),
        tolerance,
        tolerance,
        // The documented defaults, except for steps and output.
        0.9,
        0.0,
        0.333,
        6.0,
        end,
        0.0,
        MANY_STEPS as u32,
        1000,
        OutputType::Sparse,
    );
    let stats = solver.integrate().ok()?;
    Some(Run { state: (*solver.y_out().last()?).into(), evaluations: u64::from(stats.num_eval) })
}
