//! Comparison of motions with data, and derivatives.

use std::boxed::Box;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::least_squares::Comparison;
use super::progress::Asks;
use crate::differences::slope;
use crate::integrate::Method;
use crate::linalg::dense::DenseMatrix;
use crate::simulate::{
    Differentiated, Drive, Ending, Plan, RunPlan, Sampling, Sensitive, Simulation, Trajectory, varied,
};
use crate::system::{MechanicalSystem, OdeSystem, ParametricSystem, State};

/// Number of variables by which one run is differentiated; more variables need further runs. It is
/// fixed so that the integration is compiled only once.
const BLOCK: usize = 4;
/// The rows of a state with this number of derivatives.
pub(super) const ROWS: usize = BLOCK + 1;

/// A quantity of a system that data may contain.
pub(super) enum MeasuredQuantity<'a, M: MechanicalSystem> {
    /// An entry of the state.
    State(usize),
    /// A function of system, time and state.
    Function(Function<'a, M>),
}

/// A function of system, time and state.
pub(super) type Function<'a, M> = Box<dyn Fn(&M, f64, &State<M>) -> f64 + 'a>;

/// The place of a variable: among parameters and inputs, or in the initial state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum VariableOf {
    Number(usize),
    Start(usize),
}

/// A variable with its bounds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded {
    pub(super) name: &'static str,
    pub(super) of: VariableOf,
    pub(super) bounds: (f64, f64),
}

/// A value of the data.
#[derive(Clone, Copy, Debug)]
pub(super) struct Datum {
    /// Index of its column.
    pub(super) column: usize,
    /// Its row in the data.
    pub(super) row: usize,
    pub(super) value: f64,
    pub(super) noise: f64,
}

/// A system, data, and the method for motions.
pub(super) struct FitProblem<'a, M: ParametricSystem<Scalar = f64>, K, D> {
    pub(super) system: &'a M,
    pub(super) start: M::State,
    /// Start and end time of motions.
    pub(super) span: [f64; 2],
    pub(super) times: Vec<f64>,
    pub(super) data: Vec<Datum>,
    pub(super) quantities: Vec<MeasuredQuantity<'a, M>>,
    pub(super) variables: Vec<Bounded>,
    pub(super) method: K,
    pub(super) drive: D,
}

impl<M, K, D, const N: usize> FitProblem<'_, M, K, D>
where
    M: ParametricSystem<Scalar = f64> + OdeSystem<Scalar = f64, State = [f64; N]>,
    D: Drive<M>,
    D::Closed: OdeSystem<State = [f64; N]>,
    K: Method<Sensitive<M, D::Closed, N, ROWS>> + Clone,
{
    /// Returns the present values of the variables.
    pub(super) fn values(&self) -> Vec<f64> {
        let value = |variable: &Bounded| match variable.of {
            VariableOf::Number(index) => self.system.number(index).unwrap_or(f64::NAN),
            VariableOf::Start(index) => self.start[index],
        };
        self.variables.iter().map(value).collect()
    }

    /// Returns the system and the initial state with other values.
    pub(super) fn at(&self, values: &[f64]) -> (M, M::State) {
        let mut system = self.system.with_number(usize::MAX, 0.0);
        let mut start = self.start;
        for (variable, &value) in self.variables.iter().zip(values) {
            match variable.of {
                VariableOf::Number(index) => system = system.with_number(index, value),
                VariableOf::Start(index) => start[index] = value,
            }
        }
        (system, start)
    }

    /// Computes the residuals, each divided by its noise level, and their derivatives.
    ///
    /// # Errors
    /// If no motion reaches the end of the data, with the reason, or the fit is cancelled.
    pub(super) fn evaluate(&self, values: &[f64], is_cancelled: Asks<'_>) -> Result<Comparison, String> {
        let (system, start) = self.at(values);
        let mut residuals = std::vec![0.0; self.data.len()];
        let mut jacobian = DenseMatrix::zeros(self.data.len(), self.variables.len());
        for (block, variables) in self.variables.chunks(BLOCK).enumerate() {
            let motion = self.motion((&system, start), variables, is_cancelled)?;
            let first = motion.len() - self.times.len();
            for (i, datum) in self.data.iter().enumerate() {
                let row = first + datum.row;
                let (time, state) = (self.times[datum.row], motion.state(row).unwrap_or([f64::NAN; N]));
                let quantity = &self.quantities[datum.column];
                residuals[i] = (quantity.value(&system, time, &state) - datum.value) / datum.noise;
                let changes = motion.sensitivities(row).unwrap_or_default();
                for (k, (variable, change)) in variables.iter().zip(&changes).enumerate() {
                    let slope = quantity.slope(&system, (time, &state), change, *variable);
                    jacobian[(i, block * BLOCK + k)] = slope / datum.noise;
                }
            }
        }
        match residuals.iter().all(|residual| residual.is_finite()) && jacobian.is_finite() {
            true => Ok(Comparison { residuals, jacobian }),
            false => Err("a quantity or its derivative is NaN or infinite".into()),
        }
    }

    /// Computes the motion with derivatives with respect to some variables.
    fn motion(
        &self,
        (system, start): (&M, [f64; N]),
        variables: &[Bounded],
        is_cancelled: Asks<'_>,
    ) -> Result<Trajectory<M>, String> {
        let found = variables.iter().map(|variable| varied(system, &start, variable.name, 1.0));
        let found = found.collect::<Result<Vec<_>, _>>().map_err(|error| error.to_string())?;
        let mut plan: RunPlan<'_, M> = Plan::new(Sampling::Times);
        plan.settings.span = self.span;
        plan.settings.times.clone_from(&self.times);
        let drive = Differentiated::<M, D, N, ROWS>::new(self.drive.clone(), found.into());
        let run = Simulation::new(system, start, plan, (self.method.clone(), drive));
        let motion = run.cancel_when(is_cancelled).run().map_err(|error| error.to_string())?;
        match motion.end_time() == self.span[1] {
            true => Ok(motion),
            false if motion.ending() == Ending::Cancelled => Err("the fit is cancelled".into()),
            false => Err(format!("an event ends the motion at time {:?}", motion.end_time())),
        }
    }
}

impl<M, const N: usize> MeasuredQuantity<'_, M>
where
    M: ParametricSystem<Scalar = f64> + OdeSystem<Scalar = f64, State = [f64; N]>,
{
    fn value(&self, system: &M, time: f64, state: &[f64; N]) -> f64 {
        match self {
            MeasuredQuantity::State(index) => state[*index],
            MeasuredQuantity::Function(function) => function(system, time, state),
        }
    }

    /// Returns the derivative with respect to a variable, with which the state changes like this.
    fn slope(
        &self,
        system: &M,
        (time, state): (f64, &[f64; N]),
        change: &[f64; N],
        variable: Bounded,
    ) -> f64 {
        let MeasuredQuantity::Function(function) = self else { return self.value(system, time, change) };
        let largest = |vector: &[f64]| vector.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        let (size, moving) = (largest(state), largest(change));
        let rate = if size > 0.0 { moving / size } else { moving };
        let value = |index| system.number(index).unwrap_or(f64::NAN);
        let own = match variable.of {
            VariableOf::Number(index) if value(index) != 0.0 => 1.0 / value(index).abs(),
            VariableOf::Number(_) => 1.0,
            VariableOf::Start(_) => 0.0,
        };
        let found = slope(rate.max(own), |by: f64| {
            let there = core::array::from_fn(|i| state[i] + by * change[i]);
            let value = match variable.of {
                VariableOf::Number(index) => {
                    function(&system.with_number(index, value(index) + by), time, &there)
                }
                VariableOf::Start(_) => function(system, time, &there),
            };
            Some([value]).filter(|[value]| value.is_finite())
        });
        found.map_or(f64::NAN, |[slope]| slope)
    }
}

/// Finds the variable of this name.
pub(super) fn find(name: &str, numbers: &[&str], states: &[String]) -> Option<VariableOf> {
    let number = numbers.iter().position(|number| *number == name).map(VariableOf::Number);
    number.or_else(|| states.iter().position(|state| state == name).map(VariableOf::Start))
}
