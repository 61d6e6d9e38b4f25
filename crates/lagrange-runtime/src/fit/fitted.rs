//! The result of a fit.

use std::fmt::{Debug, Display, Formatter, Result as Written};
use std::format;
use std::string::String;
use std::vec::Vec;

use super::data::Data;
use super::least_squares::{Minimum, free};
use super::problem::{Bounded, Datum};
use crate::linalg::dense::DenseMatrix;
use crate::linalg::singular_values::SingularValues;
use crate::simulate::{Table, unit};
use crate::system::ParametricSystem;

/// A combination counts as undetermined below this, relative to the best determined one:
/// derivatives have errors of this size.
const UNTOLD: f64 = 1e-7;
/// Entries of a combination below this are not written.
const UNWRITTEN: f64 = 0.05;

/// A fitted value.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FittedValue {
    /// Name of the parameter, the input, or the state whose initial value it is.
    pub name: &'static str,
    /// Value.
    pub value: f64,
    /// The standard error; `None` at a bound, or if the data do not determine it.
    pub standard_error: Option<f64>,
    /// True if a bound holds it.
    pub is_at_bound: bool,
    /// Its unit, if it is known.
    pub unit: Option<&'static str>,
}

/// The result of a fit.
#[derive(Clone)]
pub struct Fitted<M: ParametricSystem<Scalar = f64>> {
    system: M,
    start: M::State,
    values: Vec<FittedValue>,
    covariance: Option<DenseMatrix>,
    /// The combination that the data determine least, as relative changes of length one. The next
    /// fields are its relative error, and true if the data determine it.
    weakest: Vec<(&'static str, f64)>,
    weakest_error: f64,
    is_determined: bool,
    table: Table<f64>,
    /// Name, number of values, and root mean square of the residuals of each column.
    columns: Vec<(String, usize, f64)>,
    chi_square: f64,
    degrees: usize,
    has_noise: bool,
    iterations: usize,
    evaluations: usize,
    costs: Vec<f64>,
}

impl<M: ParametricSystem<Scalar = f64>> Fitted<M> {
    pub(super) fn new(
        (system, start): (M, M::State),
        variables: &[Bounded],
        (data, points): (&Data, &[Datum]),
        has_noise: bool,
        minimum: &Minimum,
    ) -> Self {
        let bounds = variables.iter().map(|variable| variable.bounds).collect::<Vec<_>>();
        let free = free(minimum, &bounds);
        let degrees = points.len() - free.len();
        let chi_square = 2.0 * minimum.cost;
        let variance = match (has_noise, degrees) {
            (true, _) => Some(1.0),
            (false, 0) => None,
            (false, degrees) => Some(chi_square / degrees as f64),
        };
        let told = Told::new(minimum, &free, variance);
        let square = told.covariance.as_ref();
        let value = |(j, variable): (usize, &Bounded)| FittedValue {
            name: variable.name,
            value: minimum.values[j],
            standard_error: square.filter(|_| free.contains(&j)).map(|square| square[(j, j)].sqrt()),
            is_at_bound: !free.contains(&j),
            unit: unit(system.description(), variable.name),
        };
        let values = variables.iter().enumerate().map(value).collect();
        let weakest = free.iter().map(|j| variables[*j].name).zip(told.weakest).collect();
        let (table, columns) = tabulated(data, points, &minimum.at.residuals);
        Fitted {
            system,
            start,
            values,
            covariance: told.covariance,
            weakest,
            weakest_error: told.weakest_error,
            is_determined: told.is_all,
            table,
            columns,
            chi_square,
            degrees,
            has_noise,
            iterations: minimum.iterations,
            evaluations: minimum.evaluations,
            costs: Vec::new(),
        }
    }

    pub(super) fn with_costs(self, costs: Vec<f64>) -> Self {
        Fitted { costs, ..self }
    }

    pub(super) fn is_determined(&self) -> bool {
        self.is_determined
    }

    /// Returns the system with the fitted parameters.
    pub fn system(&self) -> &M {
        &self.system
    }

    /// Returns the initial state with the fitted initial values.
    pub fn start(&self) -> M::State {
        self.start
    }

    /// Returns the fitted values in the order in which they were varied.
    pub fn values(&self) -> &[FittedValue] {
        &self.values
    }

    /// Returns the fitted value of this name.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|value| value.name == name).map(|value| value.value)
    }

    /// Returns the standard error of the value of this name, if there is one.
    pub fn standard_error(&self, name: &str) -> Option<f64> {
        self.values.iter().find(|value| value.name == name)?.standard_error
    }

    /// Returns the covariance matrix of the values, with zeros for those at a bound. `None` if the
    /// data do not determine all of them, or if there are no noise levels and no more values than
    /// variables.
    pub fn covariance(&self) -> Option<&DenseMatrix> {
        self.covariance.as_ref()
    }

    /// Returns the combination that the data determine least: a vector of length one of relative
    /// changes, or of changes for values of zero.
    pub fn weakest(&self) -> &[(&'static str, f64)] {
        &self.weakest
    }

    /// Returns the standard error of that combination.
    pub fn weakest_error(&self) -> f64 {
        self.weakest_error
    }

    /// Returns the sum of squares of all residuals, each divided by its noise level.
    pub fn chi_square(&self) -> f64 {
        self.chi_square
    }

    /// Returns the number of values in the data minus the number of variables not held at a bound.
    pub fn degrees_of_freedom(&self) -> usize {
        self.degrees
    }

    /// Returns the table of all columns at the times of the data. In addition to measured values it
    /// contains fitted ones, such as `x (fit)`, and residuals, such as `x (residual)`: fitted minus
    /// measured. Missing values are NaN.
    pub fn table(&self) -> &Table<f64> {
        &self.table
    }

    /// Returns the number of iterations of the best search.
    pub fn iterations(&self) -> usize {
        self.iterations
    }

    /// Returns the number of motions with derivatives that the best search computed.
    pub fn evaluations(&self) -> usize {
        self.evaluations
    }

    /// Returns half the sum of squares at the end of the search from each start; infinity if there
    /// was no motion.
    pub fn costs(&self) -> &[f64] {
        &self.costs
    }

    /// Writes the combination that the data determine least.
    pub(super) fn write_weakest(&self, f: &mut Formatter<'_>) -> Written {
        let seen = self.weakest.iter().filter(|(_, part)| part.abs() > UNWRITTEN);
        for (index, (name, part)) in seen.enumerate() {
            let sign = match (index, *part < 0.0) {
                (0, false) => "",
                (0, true) => "−",
                (_, false) => "+ ",
                (_, true) => "− ",
            };
            write!(f, " {sign}{:.2} `{name}`", part.abs())?;
        }
        Ok(())
    }
}

/// The information about the variables in the data.
struct Told {
    /// True if all free variables are determined.
    is_all: bool,
    covariance: Option<DenseMatrix>,
    /// The combination of free variables that is determined least, with its error below.
    weakest: Vec<f64>,
    weakest_error: f64,
}

impl Told {
    /// Finds the relative changes of the free variables that a comparison with this variance tells.
    fn new(minimum: &Minimum, free: &[usize], variance: Option<f64>) -> Told {
        let size = |j: usize| if minimum.values[j] == 0.0 { 1.0 } else { minimum.values[j].abs() };
        let (jacobian, n) = (&minimum.at.jacobian, minimum.values.len());
        let relative = |i: usize, j: usize| jacobian[(i, free[j])] * size(free[j]);
        let found = SingularValues::of(&DenseMatrix::from_fn(jacobian.rows(), free.len(), relative));
        let is_all = found.as_ref().is_some_and(|found| found.rank(UNTOLD) == free.len());
        let square = found.as_ref().filter(|_| is_all).and_then(SingularValues::inverse_square);
        let covariance = square.zip(variance).map(|(square, variance)| {
            let place = |j: usize| free.iter().position(|free| *free == j);
            DenseMatrix::from_fn(n, n, |i, j| match (place(i), place(j)) {
                (Some(k), Some(l)) => variance * square[(k, l)] * size(i) * size(j),
                _ => 0.0,
            })
        });
        let weakest = found.as_ref().and_then(SingularValues::weakest).unwrap_or_default().to_vec();
        let least = found.and_then(|found| found.values().last().copied()).unwrap_or(0.0);
        Told { is_all, covariance, weakest, weakest_error: variance.unwrap_or(f64::NAN).sqrt() / least }
    }
}

/// Returns the name of the column of fitted values.
pub(super) fn fitted_name(column: &str) -> String {
    format!("{column} (fit)")
}

/// Returns the table of measured and fitted values and residuals, and the size of the residuals of
/// each column.
fn tabulated(data: &Data, points: &[Datum], residuals: &[f64]) -> (Table<f64>, Vec<(String, usize, f64)>) {
    let names = data.columns.iter().map(|column| &column.name);
    let names = names.flat_map(|name| [name.clone(), fitted_name(name), format!("{name} (residual)")]);
    let mut table = Table::new(names.collect());
    let mut rows = std::vec![std::vec![f64::NAN; 3 * data.columns.len()]; data.times.len()];
    let mut sums = std::vec![(0, 0.0); data.columns.len()];
    for (point, residual) in points.iter().zip(residuals) {
        let residual = residual * point.noise;
        let cells = [point.value, point.value + residual, residual];
        rows[point.row][3 * point.column..][..3].copy_from_slice(&cells);
        sums[point.column].0 += 1;
        sums[point.column].1 += residual * residual;
    }
    data.times.iter().zip(&rows).for_each(|(time, row)| table.push(*time, row));
    let column = |(column, (count, sum)): (&super::data::Measured, (usize, f64))| {
        (column.name.clone(), count, (sum / count as f64).sqrt())
    };
    (table, data.columns.iter().zip(sums).map(column).collect())
}

impl<M: ParametricSystem<Scalar = f64>> Display for Fitted<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let count: usize = self.columns.iter().map(|(_, count, _)| count).sum();
        writeln!(
            f,
            "{} variables fitted to {count} values in {} iterations",
            self.values.len(),
            self.iterations
        )?;
        for value in &self.values {
            writeln!(f, "  {value}")?;
        }
        if self.degrees > 0 && self.has_noise {
            writeln!(f, "χ² per degree of freedom: {:.3}", self.chi_square / self.degrees as f64)?;
        }
        for (name, count, size) in &self.columns {
            let unit = unit(self.system.description(), name).filter(|unit| *unit != "1").unwrap_or_default();
            writeln!(f, "residuals of {count} values of `{name}`: {size:.3e} {unit}")?;
        }
        if self.costs.len() > 1 {
            let least = self.costs.iter().fold(f64::INFINITY, |least: f64, cost| least.min(*cost));
            let same = self.costs.iter().filter(|cost| **cost <= least * (1.0 + 1e-6)).count();
            writeln!(f, "{same} of {} searches end here", self.costs.len())?;
        }
        f.write_str("the data tell least:")?;
        self.write_weakest(f)?;
        write!(f, ", in relative changes, to {:.1e}", self.weakest_error)
    }
}

impl Display for FittedValue {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        let FittedValue { name, value, standard_error, is_at_bound, unit } = self;
        match standard_error {
            // Write two digits of the error.
            Some(error) if *error > 1e-9 && *error < 1e6 && value.abs() < 1e9 => {
                let decimals = (1.0 - error.log10().floor()).clamp(0.0, 12.0) as usize;
                write!(f, "{name} = {value:.decimals$} ± {error:.decimals$}")?;
            }
            Some(error) => write!(f, "{name} = {value:.9e} ± {error:.1e}")?,
            None => write!(f, "{name} = {value}")?,
        }
        if let Some(unit) = unit.filter(|unit| *unit != "1") {
            write!(f, " {unit}")?;
        }
        if *is_at_bound { f.write_str(", at its bound") } else { Ok(()) }
    }
}

impl<M: ParametricSystem<Scalar = f64>> Debug for Fitted<M> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Written {
        f.debug_struct("Fitted")
            .field("values", &self.values)
            .field("chi_square", &self.chi_square)
            .field("degrees_of_freedom", &self.degrees)
            .finish_non_exhaustive()
    }
}
