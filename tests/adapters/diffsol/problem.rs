//! A system as the closures from which `diffsol` builds a problem.

use core::cell::RefCell;

use diffsol::{MatrixCommon, NalgebraMat, OdeBuilder, OdeEquationsImplicit, OdeSolverProblem};

use crate::jacobian::jacobian;
use crate::stiff::Stiff;
use lagrange::system::{OdeSystem, StateMatrix, StateVector, StepFailure};

pub(crate) type Matrix = NalgebraMat<f64>;
pub(crate) type Vector = <Matrix as MatrixCommon>::V;
pub(crate) type Context = <Matrix as MatrixCommon>::C;

/// Returns the problem in the time ± t that grows towards the end, since `diffsol` only stops at
/// later times.
pub(crate) fn problem<'a, M>(
    system: &'a M,
    t0: f64,
    y0: &M::State,
    t_end: f64,
    method: &Stiff,
) -> Result<
    OdeSolverProblem<impl OdeEquationsImplicit<T = f64, V = Vector, M = Matrix, C = Context> + use<'a, M>>,
    StepFailure<f64>,
>
where
    M: OdeSystem<Scalar = f64> + ?Sized,
{
    let direction = direction(t0, t_end);
    let start = *y0;
    let columns = RefCell::new(Known::<M>::new());
    OdeBuilder::<Matrix>::new()
        .t0(direction * t0)
        .rtol(method.relative)
        .atol([method.absolute])
        .rhs_implicit(
            move |y: &[f64], _: &[f64], t: f64, rate: &mut [f64]| {
                let own = system.rhs(direction * t, &state::<M>(y));
                for (rate, own) in rate.iter_mut().zip(own.as_ref()) {
                    *rate = direction * own;
                }
            },
            move |y: &[f64], _: &[f64], t: f64, v: &[f64], product: &mut [f64]| {
                let rows = columns.borrow_mut().at(system, direction * t, &state::<M>(y));
                for (product, row) in product.iter_mut().zip(rows.as_ref()) {
                    let sum = row.as_ref().iter().zip(v).map(|(entry, v)| entry * v).sum::<f64>();
                    *product = direction * sum;
                }
            },
        )
        .init(move |_: &[f64], _: f64, y: &mut [f64]| y.copy_from_slice(start.as_ref()), y0.as_ref().len())
        .build()
        .map_err(|_| StepFailure::Stuck("diffsol refused the problem"))
}

/// Returns 1 forwards and −1 backwards.
pub(crate) fn direction(t0: f64, t_end: f64) -> f64 {
    if t_end < t0 { -1.0 } else { 1.0 }
}

pub(crate) fn state<M: OdeSystem<Scalar = f64> + ?Sized>(values: &[f64]) -> M::State {
    let mut y = M::State::ZERO;
    y.as_mut().copy_from_slice(values);
    y
}

/// The last Jacobian, since `diffsol` requests it column by column, in products with unit vectors.
struct Known<M: OdeSystem<Scalar = f64> + ?Sized> {
    last: Option<(f64, M::State, StateMatrix<M>)>,
}

impl<M: OdeSystem<Scalar = f64> + ?Sized> Known<M> {
    fn new() -> Self {
        Known { last: None }
    }

    fn at(&mut self, system: &M, t: f64, y: &M::State) -> StateMatrix<M> {
        match &self.last {
            Some((time, at, rows)) if *time == t && at.as_ref() == y.as_ref() => *rows,
            _ => {
                let rows = jacobian(system, t, y);
                self.last = Some((t, *y, rows));
                rows
            }
        }
    }
}
