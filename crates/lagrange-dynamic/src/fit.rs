//! Estimation of parameters of systems read at run time from data.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

use lagrange_runtime::fit::{Data, DenseMatrix, FitError, Fits, Fitted, FittedValue};
use lagrange_runtime::system::{OutputSystem, ParametricSystem, StateVector};

use crate::declared::{DeclaredSystem, Visitor};
use crate::fixed::{FixedSystem, filled};
use crate::inline::Inline;
use crate::refusal::NoSuchName;
use crate::system::DynamicSystem;
use crate::watch::Watch;

/// A fit of motions to data, integrated by the method `verner`.
#[derive(Clone, PartialEq, Debug)]
pub struct FitSettings {
    /// Initial state.
    pub start: Vec<f64>,
    /// Times and measured columns: entries of the state or outputs.
    pub data: Data,
    /// Varied parameters, constant inputs and entries of the initial state, by name. Lower and
    /// upper bounds may be infinite.
    pub varied: Vec<(String, [f64; 2])>,
    /// Standard deviations of the noise, by column.
    pub noise: Vec<(String, f64)>,
    /// Initial time; the first time of the data if it is `None`.
    pub from: Option<f64>,
    /// Error tolerance of a step.
    pub tolerance: f64,
    /// Number of starting points of the search.
    pub starts: usize,
    /// Maximum number of iterations from each starting point.
    pub max_iterations: usize,
}

/// The values of a fit.
#[derive(Clone, PartialEq, Debug)]
pub struct FoundFit {
    /// Values with standard errors, in the order of the varied quantities.
    pub values: Vec<FittedValue>,
    /// Covariance matrix of the values, in rows, with zeros for values at a bound. `None` if data
    /// do not determine all values, or there are no noise levels and too few data to estimate them.
    pub covariance: Option<Vec<Vec<f64>>>,
    /// Combination of relative changes that is least determined by the data.
    pub weakest: Vec<(&'static str, f64)>,
    /// Standard error of this combination.
    pub weakest_error: f64,
    /// Sum of squares of the residuals, each over its noise level.
    pub chi_square: f64,
    /// Number of data values minus the number of variables not at a bound.
    pub degrees_of_freedom: usize,
    /// Number of iterations of the best search.
    pub iterations: usize,
    /// Parameters and inputs of the system, including the fitted ones.
    pub fields: Vec<f64>,
    /// Initial state, including the fitted entries.
    pub start: Vec<f64>,
    /// Full result as text.
    pub report: String,
}

/// The reason why a fit has no result.
#[derive(Clone, PartialEq, Debug)]
#[non_exhaustive]
pub enum FitFailure {
    /// The system has no quantity of this name to vary or measure.
    Unknown(NoSuchName),
    /// Data or settings are invalid.
    Setting(String),
    /// No motion reaches the end of the data.
    Motion(String),
    /// The data do not determine all variables, or the search did not converge or was cancelled.
    Unfinished {
        /// Undetermined combination, or the number of iterations.
        message: String,
        /// The best values.
        best: Box<FoundFit>,
    },
}

impl Display for FitFailure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            FitFailure::Unknown(name) => name.fmt(f),
            FitFailure::Setting(message)
            | FitFailure::Motion(message)
            | FitFailure::Unfinished { message, .. } => f.write_str(message),
        }
    }
}

impl Error for FitFailure {}

impl DeclaredSystem {
    /// Fits parameters, inputs and entries of the initial state to data.
    ///
    /// # Errors
    /// If any of these holds:
    /// - data or settings are invalid;
    /// - no motion reaches the end of the data;
    /// - the search does not converge, or data do not determine all variables.
    pub fn fit(&self, settings: &FitSettings) -> Result<FoundFit, FitFailure> {
        self.fit_watched(settings, &|_| false)
    }

    /// Fits as [`fit`](Self::fit) does, unless it is cancelled.
    ///
    /// # Errors
    /// As those of [`fit`](Self::fit), or if it is cancelled.
    pub fn fit_watched(&self, settings: &FitSettings, watch: Watch<'_>) -> Result<FoundFit, FitFailure> {
        let measurable = [self.state_names(), self.variables().outputs.concat()].concat();
        let variable = [&self.variables().fields[..], &self.state_names()].concat();
        let columns = settings.data.names().chain(settings.noise.iter().map(|(name, _)| name.as_str()));
        let varied = settings.varied.iter().map(|(name, _)| name.as_str());
        let pairs = columns.map(|name| (name, &measurable)).chain(varied.map(|name| (name, &variable)));
        for (name, known) in pairs {
            if !known.iter().any(|known| known == name) {
                let unknown = NoSuchName { name: name.to_owned(), known: known.clone() };
                return Err(FitFailure::Unknown(unknown));
            }
        }
        match settings.starts {
            0 => Err(FitFailure::Setting("a fit searches from at least one point".to_owned())),
            _ => self.visit(Fit { settings, watch }),
        }
    }
}

/// A fit with valid names.
struct Fit<'a> {
    settings: &'a FitSettings,
    watch: Watch<'a>,
}

impl Visitor for Fit<'_> {
    type Output = Result<FoundFit, FitFailure>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Self::Output {
        let Fit { settings, watch } = self;
        let start = filled(&system.state(&settings.start));
        let fixed = FixedSystem(system.clone());
        let mut search = fixed.fit(start, settings.data.clone()).tolerance(settings.tolerance);
        search = search.cancel_when(|| watch(0.0));
        for (name, [low, high]) in &settings.varied {
            let name = system.names.known(name).unwrap_or_default();
            search = search.vary(name, *low..=*high);
        }
        for (column, level) in &settings.noise {
            search = search.noise(column, *level);
        }
        for (index, name) in system.names.layout.outputs.iter().enumerate() {
            let output = move |system: &FixedSystem<CAPACITY>, t, y: &[f64; CAPACITY]| {
                let own = system.own(y);
                let (q, v) = own.parts(0);
                system.0.outputs(t, &Inline::of(q), &Inline::of(v)).get(index).copied().unwrap_or(f64::NAN)
            };
            search = search.measure(name, output);
        }
        if let Some(time) = settings.from {
            search = search.from(time);
        }
        let fitted = search.starts(settings.starts).max_iterations(settings.max_iterations).run();
        fitted.map_or_else(failed, |fitted| Ok(found(&fitted)))
    }
}

fn failed<const N: usize>(error: FitError<FixedSystem<N>>) -> Result<FoundFit, FitFailure> {
    let message = error.to_string();
    Err(match error {
        FitError::Motion { .. } => FitFailure::Motion(message),
        FitError::Undetermined(fitted)
        | FitError::NotConverged(fitted)
        | FitError::Cancelled(Some(fitted)) => {
            FitFailure::Unfinished { message, best: Box::new(found(&fitted)) }
        }
        _ => FitFailure::Setting(message),
    })
}

fn found<const N: usize>(fitted: &Fitted<FixedSystem<N>>) -> FoundFit {
    let system = fitted.system();
    let fields = (0..system.numbers().len()).filter_map(|index| system.number(index));
    let rows = |matrix: &DenseMatrix| (0..matrix.rows()).map(|row| matrix.row(row).to_vec()).collect();
    FoundFit {
        values: fitted.values().to_vec(),
        covariance: fitted.covariance().map(rows),
        weakest: fitted.weakest().to_vec(),
        weakest_error: fitted.weakest_error(),
        chi_square: fitted.chi_square(),
        degrees_of_freedom: fitted.degrees_of_freedom(),
        iterations: fitted.iterations(),
        fields: fields.collect(),
        start: system.own(&fitted.start()).as_ref().to_vec(),
        report: fitted.to_string(),
    }
}
