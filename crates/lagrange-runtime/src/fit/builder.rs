//! The settings of a fit.

use std::boxed::Box;
use std::format;
use std::ops::{Bound, RangeBounds};
use std::string::{String, ToString};
use std::vec::Vec;

use super::data::Data;
use super::error::FitError;
use super::fitted::Fitted;
use super::least_squares::{Minimum, minimise};
use super::problem::{Bounded, Datum, FitProblem, MeasuredQuantity, ROWS, VariableOf, find};
use super::progress::{FitCallback, FitProgress, FitReporter, callback};
use super::starts::starts;
use crate::integrate::{Method, Verner98};
use crate::simulate::{
    Cancellation, Drive, Law, Sensitive, TIME, Undriven, Verdict, default_method, state_names, unit,
};
use crate::system::{ControlledSystem, OdeSystem, OutputSystem, ParametricSystem, split};

/// Default maximum number of iterations of a search.
const MAX_ITERATIONS: usize = 200;

/// A fit ready to be run: the data, the variables, and the method for motions.
#[must_use = "nothing happens before `.run()`"]
pub struct FitSearch<'a, M: ParametricSystem<Scalar = f64>, K, D = Undriven> {
    settings: FitSettings<'a, M>,
    method: K,
    drive: D,
}

/// The data, the variables and the search, independent of the method.
struct FitSettings<'a, M: ParametricSystem<Scalar = f64>> {
    system: &'a M,
    start: M::State,
    data: Data,
    varied: Vec<(&'static str, (f64, f64))>,
    noise: Vec<(String, f64)>,
    measured: Vec<(String, MeasuredQuantity<'a, M>)>,
    from: Option<f64>,
    starts: usize,
    most_iterations: usize,
    callback: Option<FitCallback<'a>>,
    is_cancelled: Option<Cancellation<'a>>,
}

impl<'a, M: ParametricSystem<Scalar = f64>> FitSearch<'a, M, Verner98<f64>> {
    pub(super) fn new(system: &'a M, start: M::State, data: Data) -> Self {
        let settings = FitSettings {
            system,
            start,
            data,
            varied: Vec::new(),
            noise: Vec::new(),
            measured: Vec::new(),
            from: None,
            starts: 1,
            most_iterations: MAX_ITERATIONS,
            callback: None,
            is_cancelled: None,
        };
        FitSearch { settings, method: default_method(), drive: Undriven }
    }
}

impl<M: ParametricSystem<Scalar = f64>, D> FitSearch<'_, M, Verner98<f64>, D> {
    /// Sets the error tolerance of a step, 1e-9 by default, as
    /// [`Simulation::tolerance`](crate::simulate::Simulation::tolerance) does.
    pub fn tolerance(mut self, tolerance: f64) -> Self {
        (self.method.relative, self.method.absolute) = (tolerance, tolerance);
        self
    }
}

impl<'a, M: ParametricSystem<Scalar = f64>, K> FitSearch<'a, M, K, Undriven> {
    /// Sets the inputs by a law, as [`Simulation::drive`](crate::simulate::Simulation::drive) does.
    pub fn drive<F>(self, law: F) -> FitSearch<'a, M, K, Law<F>>
    where
        M: ControlledSystem,
        F: Fn(&M, f64, M::NamedState) -> M::Inputs,
    {
        FitSearch { settings: self.settings, method: self.method, drive: Law::new(law) }
    }
}

impl<'a, M: ParametricSystem<Scalar = f64>, K, D> FitSearch<'a, M, K, D> {
    /// Lets a parameter, an input of constant value or an initial value vary between bounds, from
    /// its present value. The name of a state stands for its initial value.
    pub fn vary(mut self, name: &'static str, range: impl RangeBounds<f64>) -> Self {
        let end = |bound: Bound<&f64>, otherwise| match bound {
            Bound::Included(end) | Bound::Excluded(end) => *end,
            Bound::Unbounded => otherwise,
        };
        let (low, high) = (range.start_bound(), range.end_bound());
        self.settings.varied.push((name, (end(low, f64::NEG_INFINITY), end(high, f64::INFINITY))));
        self
    }

    /// Sets the standard deviation of the noise in a column, in units of the column. With several
    /// columns, or if any column has a level, all columns need one.
    pub fn noise(mut self, column: &str, level: f64) -> Self {
        self.settings.noise.push((column.to_string(), level));
        self
    }

    /// Defines the quantity in the column of this name: a smooth function of system, time and
    /// state. Columns of states need no definition.
    pub fn measure(mut self, column: &str, value: impl Fn(&M, f64, &M::State) -> f64 + 'a) -> Self {
        self.settings.measured.push((column.to_string(), MeasuredQuantity::Function(Box::new(value))));
        self
    }

    /// Defines the outputs of the declaration as quantities for columns of the same names.
    pub fn outputs(mut self) -> Self
    where
        M: OutputSystem,
    {
        for (index, name) in self.settings.system.output_names().iter().enumerate() {
            self = self.measure(name, move |system, t, y| {
                let (q, v) = split::<M>(y);
                system.outputs(t, &q, &v).as_ref()[index]
            });
        }
        self
    }

    /// Starts motions at this time instead of the first time of the data.
    pub fn from(mut self, time: f64) -> Self {
        self.settings.from = Some(time);
        self
    }

    /// Searches from this many points, the first of which is the present values, and returns the
    /// best result. Points fill the bounds evenly and reproducibly. Without a bound they are within
    /// a factor of ten of the value.
    pub fn starts(mut self, count: usize) -> Self {
        self.settings.starts = count;
        self
    }

    /// Sets the maximum number of iterations from each start, 200 by default.
    pub fn max_iterations(mut self, most: usize) -> Self {
        self.settings.most_iterations = most;
        self
    }

    /// Calls back after each comparison of a motion with the data, as for a progress bar.
    ///
    /// The callback returns nothing, or `ControlFlow::Break(())` to cancel the fit. It then ends
    /// with [`FitError::Cancelled`], which contains the best values so far.
    pub fn progress<V: Verdict>(mut self, callback: impl FnMut(FitProgress) -> V + 'a) -> Self {
        self.settings.callback = Some(self::callback(callback));
        self
    }

    /// Cancels the fit soon after this function returns true, such as one that reads an atomic
    /// flag. It is called every few dozen steps of a motion.
    pub fn cancel_when(mut self, is_cancelled: impl Fn() -> bool + 'a) -> Self {
        self.settings.is_cancelled = Some(Box::new(is_cancelled));
        self
    }

    /// Computes motions by this method instead of the adaptive one.
    pub fn method<L>(self, method: L) -> FitSearch<'a, M, L, D> {
        FitSearch { settings: self.settings, method, drive: self.drive }
    }

    /// Searches for the values with the smallest sum of squares.
    ///
    /// # Errors
    /// If data or settings are invalid, or no motion reaches the end of the data. Also if the
    /// search does not converge or is cancelled, or the data do not determine all variables.
    pub fn run<const N: usize>(mut self) -> Result<Fitted<M>, FitError<M>>
    where
        M: OdeSystem<State = [f64; N]>,
        D: Drive<M>,
        D::Closed: OdeSystem<State = [f64; N]>,
        K: Method<Sensitive<M, D::Closed, N, ROWS>> + Clone,
    {
        let (count, most_iterations, has_noise) =
            (self.settings.starts, self.settings.most_iterations, !self.settings.noise.is_empty());
        let (callback, cancellation) = (self.settings.callback.take(), self.settings.is_cancelled.take());
        let mut reporter = FitReporter::new(callback, cancellation, count);
        let (problem, data) = self.settings.checked(self.method, self.drive)?;
        let bounds = problem.variables.iter().map(|variable| variable.bounds).collect::<Vec<_>>();
        let values = problem.values();
        let search = |(index, start)| {
            reporter.begin(index);
            minimise(start, &bounds, most_iterations, |values: &[f64]| {
                reporter.compare(|asks| problem.evaluate(values, asks))
            })
        };
        let (best, costs) = best(starts(&values, &bounds, count).enumerate().map(search));
        if best.is_err() && reporter.is_cancelled() {
            return Err(FitError::Cancelled(None));
        }
        let names = problem.variables.iter().map(|variable| variable.name);
        let minimum =
            best.map_err(|cause| FitError::Motion { values: names.zip(values).collect(), cause })?;
        let (at, points) = (problem.at(&minimum.values), (&data, &problem.data[..]));
        let fitted = Fitted::new(at, &problem.variables, points, has_noise, &minimum);
        let fitted = Box::new(fitted.with_costs(costs));
        if reporter.is_cancelled() {
            return Err(FitError::Cancelled(Some(fitted)));
        }
        match (minimum.has_converged, fitted.is_determined()) {
            (false, _) => Err(FitError::NotConverged(fitted)),
            (true, false) => Err(FitError::Undetermined(fitted)),
            (true, true) => Ok(*fitted),
        }
    }
}

impl<'a, M: ParametricSystem<Scalar = f64>> FitSettings<'a, M> {
    /// Returns the problem specified by the settings, and the data.
    fn checked<K, D>(mut self, method: K, drive: D) -> Result<Checked<'a, M, K, D>, FitError<M>> {
        let states = state_names(self.system.description()).collect::<Vec<_>>();
        let begin = self.from.or(self.data.times.first().copied()).unwrap_or(0.0);
        check_data(&self.data, begin)?;
        let (variables, noise) = (self.variables(&states)?, self.levels()?);
        let quantities = self.quantities(&states)?;
        let columns = self.data.columns.iter().zip(noise).enumerate();
        let data = columns.flat_map(|(column, (measured, noise))| {
            let values = measured.values.iter().enumerate();
            values.filter_map(move |(row, value)| Some(Datum { column, row, value: (*value)?, noise }))
        });
        let data = data.collect::<Vec<_>>();
        if data.len() < variables.len() {
            return Err(FitError::TooFew { values: data.len(), variables: variables.len() });
        }
        let times = self.data.times.clone();
        let span = [begin, times.last().copied().unwrap_or(begin)];
        let FitSettings { system, start, .. } = self;
        Ok((FitProblem { system, start, span, times, data, quantities, variables, method, drive }, self.data))
    }

    /// Returns the quantity in each column.
    fn quantities(&mut self, states: &[String]) -> Result<Vec<MeasuredQuantity<'a, M>>, FitError<M>> {
        let description = self.system.description();
        let mut quantities = Vec::new();
        for column in &self.data.columns {
            let known = self.measured.iter().position(|(name, _)| *name == column.name);
            let state = states.iter().position(|state| *state == column.name);
            quantities.push(match (known, state) {
                (Some(index), _) => self.measured.swap_remove(index).1,
                (None, Some(index)) => MeasuredQuantity::State(index),
                (None, None) => {
                    let known = states.iter().chain(self.measured.iter().map(|(name, _)| name));
                    return Err(FitError::UnknownColumn {
                        name: column.name.clone(),
                        known: known.cloned().collect(),
                    });
                }
            });
            if let (Some(unit), Some(wanted)) = (&column.unit, unit(description, &column.name))
                && unit != wanted
            {
                return Err(FitError::Unit { column: column.name.clone(), unit: unit.clone(), wanted });
            }
        }
        Ok(quantities)
    }

    /// Returns the variables with their bounds.
    fn variables(&self, states: &[String]) -> Result<Vec<Bounded>, FitError<M>> {
        let (numbers, mut variables) = (self.system.numbers(), Vec::<Bounded>::new());
        for &(name, (low, high)) in &self.varied {
            let wrong = |reason: String| FitError::Variable { name, reason };
            let of = find(name, numbers, states).ok_or_else(|| {
                let known = numbers.iter().map(ToString::to_string).chain(states.iter().cloned());
                wrong(format!(
                    "it is no parameter, input or state; these are {}",
                    known.collect::<Vec<_>>().join(", ")
                ))
            })?;
            let value = match of {
                VariableOf::Number(index) => self.system.number(index),
                VariableOf::Start(index) => self.start.as_ref().get(index).copied(),
            };
            let value = value.unwrap_or(f64::NAN);
            if variables.iter().any(|other| other.of == of) {
                return Err(wrong("it varies already".into()));
            }
            if low >= high || !(low..=high).contains(&value) {
                return Err(wrong(format!("its value {value:?} is not between {low:?} and {high:?}")));
            }
            variables.push(Bounded { name, of, bounds: (low, high) });
        }
        if variables.is_empty() { Err(FitError::NothingVaries) } else { Ok(variables) }
    }

    /// Returns the noise level of each column; one for a single column without a level.
    fn levels(&self) -> Result<Vec<f64>, FitError<M>> {
        let columns = &self.data.columns;
        for (name, level) in &self.noise {
            if columns.iter().all(|column| column.name != *name) {
                let known = columns.iter().map(|column| column.name.clone()).collect();
                return Err(FitError::UnknownColumn { name: name.clone(), known });
            }
            if !(*level > 0.0 && level.is_finite()) {
                return Err(FitError::Noise { column: name.clone(), level: Some(*level) });
            }
        }
        let level = |name: &str| self.noise.iter().rev().find(|(of, _)| of == name).map(|(_, level)| *level);
        let levels = columns.iter().map(|column| match level(&column.name) {
            None if columns.len() > 1 || !self.noise.is_empty() => {
                Err(FitError::Noise { column: column.name.clone(), level: None })
            }
            level => Ok(level.unwrap_or(1.0)),
        });
        levels.collect()
    }
}

/// A problem, and the data.
type Checked<'a, M, K, D> = (FitProblem<'a, M, K, D>, Data);

/// Returns the best search, or the error of the first one, and the final cost of each.
fn best(searches: impl Iterator<Item = Result<Minimum, String>>) -> (Result<Minimum, String>, Vec<f64>) {
    let mut costs = Vec::new();
    let all = searches.inspect(|found| {
        costs.push(found.as_ref().map_or(f64::INFINITY, |minimum| minimum.cost));
    });
    let best = all.reduce(|best, found| match (&best, &found) {
        (Ok(lowest), Ok(other)) if other.cost < lowest.cost => found,
        (Err(_), Ok(_)) => found,
        _ => best,
    });
    (best.unwrap_or_else(|| Err(String::new())), costs)
}

/// Checks the times, and that the number of values in each column equals the number of times.
fn check_data<M: ParametricSystem<Scalar = f64>>(data: &Data, begin: f64) -> Result<(), FitError<M>> {
    let not_finite = |column: &str, row| FitError::NotFinite { column: column.into(), row };
    if let Some(row) = data.times.iter().position(|time| !time.is_finite()) {
        return Err(not_finite(TIME, row));
    }
    let is_early = |&row: &usize| match row {
        0 => begin > data.times[0] || !begin.is_finite(),
        _ => data.times[row] <= data.times[row - 1],
    };
    if let Some(row) = (0..data.times.len()).find(is_early) {
        return Err(FitError::Times { row });
    }
    for (index, column) in data.columns.iter().enumerate() {
        let (values, times) = (column.values.len(), data.times.len());
        if values != times {
            return Err(FitError::Length { column: column.name.clone(), values, times });
        }
        if let Some(row) =
            column.values.iter().position(|value| value.is_some_and(|value| !value.is_finite()))
        {
            return Err(not_finite(&column.name, row));
        }
        if data.columns[..index].iter().any(|other| other.name == column.name) {
            return Err(FitError::RepeatedColumn(column.name.clone()));
        }
    }
    Ok(())
}
