//! The request for an ensemble, and its computation.

use lagrange_runtime::Number;
use lagrange_runtime::integrate::RungeKutta4;
use lagrange_runtime::system::KernelSystem;

use crate::backend::{Backend, Description, Method, Run, Work};
use crate::ends::Ends;
use crate::error::DeviceError;
use crate::number::{DeviceNumber, Precision};

/// Changes the system of a motion.
type Change<'a, M> = Box<dyn Fn(usize, &M) -> M + 'a>;

/// Motions of one system, for which an end must be set.
#[must_use = "specify the end of the motions: `.until(time)`"]
pub struct Motions<'a, M: KernelSystem> {
    backend: &'a dyn Backend,
    system: &'a M,
    starts: Vec<M::State>,
    change: Option<Change<'a, M>>,
    from: M::Scalar,
}

impl<'a, M: KernelSystem<Scalar: DeviceNumber>> Motions<'a, M> {
    pub(crate) fn new(backend: &'a dyn Backend, system: &'a M, starts: Vec<M::State>) -> Self {
        Motions { backend, system, starts, change: None, from: M::Scalar::ZERO }
    }

    /// Gives each motion a separate system: a copy of the common one, with parameters and inputs
    /// changed by its index.
    pub fn parameters(mut self, change: impl Fn(usize, &mut M) + 'a) -> Self
    where
        M: Clone,
    {
        self.change = Some(Box::new(move |index, system| {
            let mut system = system.clone();
            change(index, &mut system);
            system
        }));
        self
    }

    /// Starts at this time instead of 0.
    pub fn from(mut self, time: M::Scalar) -> Self {
        self.from = time;
        self
    }

    /// Ends at this time, which may lie before the start.
    pub fn until(self, end: M::Scalar) -> Ensemble<'a, M> {
        let is_single = <M::Scalar as crate::number::sealed::Sealed>::IS_SINGLE;
        Ensemble { motions: self, end, step: None, tolerance: None, most: 1_000_000, is_single }
    }
}

/// Motions ready to be computed, by the pair of orders five and four of Dormand and Prince unless
/// another method is chosen.
#[must_use = "nothing happens before `.run()`"]
pub struct Ensemble<'a, M: KernelSystem> {
    motions: Motions<'a, M>,
    end: M::Scalar,
    /// The length of steps, if they are equal.
    step: Option<M::Scalar>,
    tolerance: Option<M::Scalar>,
    most: u32,
    is_single: bool,
}

impl<M: KernelSystem<Scalar: DeviceNumber>> Ensemble<'_, M> {
    /// Sets the error tolerated in a step, both as a fraction of the state and in its units: 1e-9
    /// by default, 1e-5 in single precision.
    pub fn tolerance(mut self, tolerance: M::Scalar) -> Self {
        self.tolerance = Some(tolerance);
        self
    }

    /// Integrates by the classical Runge–Kutta method in equal steps instead of the adaptive pair.
    pub fn method(mut self, method: RungeKutta4<M::Scalar>) -> Self {
        self.step = Some(method.step);
        self
    }

    /// Sets the largest number of steps of a motion, including rejected ones; a million by default.
    pub fn max_steps(mut self, limit: u32) -> Self {
        self.most = limit;
        self
    }

    /// Computes in `f32`, many times faster on most devices, and the only possibility on those
    /// without `f64`. Systems in `f32` always do.
    pub fn single_precision(mut self) -> Self {
        self.is_single = true;
        self
    }

    /// Computes all motions.
    ///
    /// # Errors
    /// Returns an error if a setting is invalid, or if the device cannot compute. A failed motion
    /// is not an error: its row holds NaN, and [`failures`](Ends::failures) describes it.
    pub fn run(self) -> Result<Ends<M>, DeviceError> {
        let backend = self.motions.backend;
        if self.is_single {
            return self.run_in::<f32>();
        }
        let Description { name, has_doubles, .. } = backend.description();
        if !has_doubles {
            return Err(DeviceError::NoDoublePrecision { device: name.clone() });
        }
        self.run_in::<f64>()
    }

    fn run_in<T: Precision>(&self) -> Result<Ends<M>, DeviceError>
    where
        for<'b> dyn Backend + 'b: Run<T>,
    {
        let mut work = self.work::<T>()?;
        let text = [T::text::<M>(), include_str!("methods.c")].concat();
        self.motions.backend.run(&text, &mut work)?;
        Ok(Ends::new(&work))
    }

    fn work<T: Precision>(&self) -> Result<Work<T>, DeviceError> {
        let Motions { starts, from, .. } = &self.motions;
        let motions = u32::try_from(starts.len()).ok().filter(|motions| *motions < u32::MAX - 1024);
        let motions =
            motions.ok_or(DeviceError::Setting("an ensemble has at most 2^32 motions"))?;
        if motions == 0 {
            return Err(DeviceError::Setting("an ensemble needs at least one motion"));
        }
        if !(from.to_f64().is_finite() && self.end.to_f64().is_finite()) {
            return Err(DeviceError::Setting("the start and end times must be finite"));
        }
        let (method, step) = match self.step.map(DeviceNumber::to_f64) {
            Some(step) if step > 0.0 && step.is_finite() => (Method::RungeKutta4, step),
            Some(_) => return Err(DeviceError::Setting("the step size must be positive and finite")),
            // Future changes, such as a push at a given time, do not appear in the errors of a
            // system at rest.
            None => (Method::DormandPrince, (self.end.to_f64() - from.to_f64()).abs() / 20.0),
        };
        let tolerance = self.tolerance.map_or(T::TOLERANCE, DeviceNumber::to_f64);
        if !(tolerance >= T::LEAST_TOLERANCE && tolerance.is_finite()) {
            return Err(DeviceError::Setting(
                "the tolerance must be finite and at least 1e-14, in single precision 1e-6",
            ));
        }
        let parameters = (0..starts.len()).map(|index| self.parameters_of(index)).collect::<Vec<_>>();
        let states = starts.iter().map(|start| start.as_ref().to_vec()).collect::<Vec<_>>();
        let (count, nothing) = (starts.len(), T::ZERO);
        // There is no previous step with an error for the controller.
        let controls = [vec![nothing; count], vec![T::from_f64(1e-4); count], vec![nothing; count]].concat();
        Ok(Work {
            method,
            motions,
            states: columns(&states),
            parameters: columns(&parameters),
            times: vec![T::from_f64(from.to_f64()); count],
            controls,
            taken: vec![0; count],
            statuses: vec![0; count],
            end: T::from_f64(self.end.to_f64()),
            step: T::from_f64(step),
            relative: T::from_f64(tolerance),
            absolute: T::from_f64(tolerance),
            most: self.most,
        })
    }

    /// Returns parameters and inputs of a motion.
    fn parameters_of(&self, index: usize) -> Vec<M::Scalar> {
        let Motions { system, change, .. } = &self.motions;
        let changed = change.as_ref().map(|change| change(index, system));
        changed.as_ref().unwrap_or(system).parameters().as_ref().to_vec()
    }
}

/// Returns rows, of which there is at least one, as columns one after the other, or a single number
/// if rows are empty.
fn columns<S: DeviceNumber, T: Precision>(rows: &[Vec<S>]) -> Vec<T> {
    let width = rows.first().map_or(0, Vec::len);
    let entries = (0..width).flat_map(|column| rows.iter().map(move |row| T::from_f64(row[column].to_f64())));
    let columns = entries.collect::<Vec<_>>();
    if columns.is_empty() { vec![T::ZERO] } else { columns }
}
