//! Declared systems.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use lagrange_c::Module;
use lagrange_core::model::Product;
use lagrange_core::pipeline::Derived;
use lagrange_dynamic::{
    DeclaredFilm, DeclaredSystem, EnsembleSettings, FitSettings, MethodChoice, RunSettings, SearchSettings,
    Source,
};
use numpy::{PyArray1, PyArray2, PyArrayDyn, PyArrayMethods, ToPyArray};
use pyo3::exceptions::{PyKeyError, PyOSError, PyValueError};
use pyo3::types::{PyAnyMethods, PyDict, PyDictMethods};
use pyo3::{Bound, Py, PyAny, PyRef, PyResult, Python, pyclass, pymethods};
use quote::quote;

use crate::derivation::{Derivatives, compiler, copy_values, derive, runnable};
use crate::ensemble::{PyEnsemble, motions};
use crate::error::{declaration_error, with_results};
use crate::fit::{self, PyFit};
use crate::interrupt::interruptible;
use crate::linear::{PyEquilibrium, PyLinearModel};
use crate::motion::PyTrajectory;
use crate::picture::PyFilm;
use crate::product::{entries_of, evaluated, product_named};
use crate::simulation::{DrivenRun, FreeRun, SampledInputs, SampledRun, chosen};
use crate::values::{check_values, names, numbers, pairs, start_of};

#[doc = described!(System)]
///
#[doc = described!(System.__init__)]
#[pyclass(name = "System", module = "lagrange", frozen)]
pub(crate) struct PySystem {
    source: Source,
    declared: DeclaredSystem,
    derivatives: Arc<Derivatives>,
}

#[pymethods]
impl PySystem {
    #[new]
    #[pyo3(signature = (text, *, compile = true))]
    fn new(py: Python<'_>, text: String, compile: bool) -> PyResult<Self> {
        let folder = std::env::current_dir().unwrap_or_default();
        PySystem::of(py, Source { name: "<text>".to_owned(), text, folder }, compile)
    }

    #[doc = described!(System.read)]
    #[staticmethod]
    #[pyo3(signature = (path, *, compile = true))]
    fn read(py: Python<'_>, path: PathBuf, compile: bool) -> PyResult<Self> {
        PySystem::of(py, Source::read(&path).map_err(PyOSError::new_err)?, compile)
    }

    #[doc = described!(System.is_compiled)]
    #[getter]
    fn is_compiled(&self) -> bool {
        self.declared.numeric().backend().is_some()
    }

    #[doc = described!(System.parameters)]
    #[getter]
    fn parameters<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let values = PyDict::new(py);
        for (name, value) in self.declared.variables().fields.iter().zip(self.declared.numeric().fields()) {
            values.set_item(name, value)?;
        }
        Ok(values)
    }

    #[doc = described!(System.with_parameters)]
    #[pyo3(signature = (**values))]
    fn with_parameters(&self, values: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut declared = self.declared.clone();
        for (name, value) in pairs(values)? {
            declared.set(&name, value).map_err(|error| PyKeyError::new_err(error.to_string()))?;
        }
        Ok(self.around(declared))
    }

    #[doc = described!(System.inputs)]
    #[getter]
    fn inputs(&self) -> Vec<String> {
        self.declared.variables().fields[self.declared.programs().layout.parameters..].to_vec()
    }

    #[doc = described!(System.state_names)]
    #[getter]
    fn state_names(&self) -> Vec<String> {
        self.declared.state_names()
    }

    #[doc = described!(System.units)]
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let units = PyDict::new(py);
        for (name, unit) in &self.declared.variables().units {
            units.set_item(name, unit)?;
        }
        Ok(units)
    }

    #[doc = described!(System.start)]
    #[pyo3(signature = (**values))]
    fn start<'py>(
        &self,
        py: Python<'py>,
        values: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        Ok(start_of(&self.declared, &pairs(values)?)?.to_pyarray(py))
    }

    #[doc = described!(System.rhs)]
    fn rhs<'py>(&self, py: Python<'py>, t: f64, y: &Bound<'_, PyAny>) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let y = self.entries("`y`", y)?;
        Ok(self.declared.rates(t, &y).to_pyarray(py))
    }

    #[doc = described!(System.accelerations)]
    fn accelerations<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let y = self.entries("`y`", y)?;
        let positions = self.declared.programs().layout.positions;
        Ok(self.declared.rates(t, &y)[positions..].to_pyarray(py))
    }

    #[doc = described!(System.energy)]
    fn energy(&self, t: f64, y: &Bound<'_, PyAny>) -> PyResult<f64> {
        let y = self.entries("`y`", y)?;
        let energy = entries_of(&self.declared, Product::Energy, (t, &y, None))?;
        Ok(energy.first().copied().unwrap_or(f64::NAN))
    }

    #[doc = described!(System.mass_matrix)]
    fn mass_matrix<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        evaluated(py, &self.declared, Product::MassMatrix, (t, &self.entries("`y`", y)?, None))
    }

    #[doc = described!(System.product)]
    #[pyo3(signature = (name, t, y, a=None))]
    fn product<'py>(
        &self,
        py: Python<'py>,
        name: &str,
        t: f64,
        y: &Bound<'_, PyAny>,
        a: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
        let y = self.entries("`y`", y)?;
        let a = a.map(|a| numbers("`a`", a)).transpose()?;
        let product = product_named(name)?;
        evaluated(py, &self.with(py, product)?, product, (t, &y, a.as_deref()))
    }

    #[doc = described!(System.jacobian)]
    fn jacobian<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let y = self.entries("`y`", y)?;
        let (q, v) = y.split_at(self.declared.programs().layout.positions);
        let system = self.with(py, Product::Jacobian)?;
        let program = system.programs().jacobian.as_ref();
        let program = program.ok_or_else(|| PyValueError::new_err("the rates have no derivatives"))?;
        system.numeric().evaluate(program, t, q, v).to_pyarray(py).reshape([y.len(), y.len()])
    }

    #[doc = described!(System.parameter_jacobian)]
    fn parameter_jacobian<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        self.by_fields(py, t, y, |parameters| 0..parameters)
    }

    #[doc = described!(System.input_jacobian)]
    fn input_jacobian<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'_, PyAny>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let fields = self.declared.variables().fields.len();
        self.by_fields(py, t, y, |parameters| parameters..fields)
    }

    #[doc = described!(System.outputs)]
    fn outputs<'py>(&self, py: Python<'py>, t: f64, y: &Bound<'_, PyAny>) -> PyResult<Bound<'py, PyDict>> {
        let y = self.entries("`y`", y)?;
        let outputs = PyDict::new(py);
        let programs = self.declared.programs().outputs.iter();
        for (columns, (_, output)) in self.declared.variables().outputs.iter().zip(programs) {
            let values = self.declared.evaluate(output, t, &y);
            for (column, value) in columns.iter().zip(values) {
                outputs.set_item(column, value)?;
            }
        }
        Ok(outputs)
    }

    #[doc = described!(System.simulate)]
    #[pyo3(signature = (start=None, *, until, every=None, begin=0.0, method=None, tolerance=None, step=None, seed=None, inputs=None, energy=false))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords of Python")]
    fn simulate(
        &self,
        py: Python<'_>,
        start: Option<&Bound<'_, PyAny>>,
        until: f64,
        every: Option<f64>,
        begin: f64,
        method: Option<&str>,
        tolerance: Option<f64>,
        step: Option<f64>,
        seed: Option<u64>,
        inputs: Option<Bound<'_, PyAny>>,
        energy: bool,
    ) -> PyResult<Py<PyTrajectory>> {
        let method = chosen(method, tolerance, step, seed)?;
        if energy && self.declared.programs().product(Product::Energy).is_none() {
            return Err(PyValueError::new_err("the declaration excludes the energy"));
        }
        let settings = RunSettings {
            start: self.state("`start`", start)?,
            from: begin,
            until,
            every,
            method,
            has_energy: energy,
        };
        let (motion, raised) = match inputs {
            Some(law) if law.is_callable() => {
                return self.declared.visit(DrivenRun::new(settings, law, &self.declared))?.share(py);
            }
            Some(samples) => {
                let inputs = SampledInputs::new(&samples, self.declared.programs().layout.inputs)?;
                interruptible(py, |watch| self.declared.visit(SampledRun { settings, inputs, watch }))
            }
            None => {
                self.check_values()?;
                let system = self.for_method(py, method)?;
                interruptible(py, |watch| system.visit(FreeRun(settings, watch)))
            }
        };
        let motion = motion.map_err(|failure| failure.exception(py))?.share(py);
        match raised {
            Some(error) => Err(with_results(py, error, "trajectory", motion)),
            None => motion,
        }
    }

    #[doc = described!(System.film)]
    #[pyo3(signature = (motion, *, energy=true, forces=false, height=640))]
    fn film(
        &self,
        py: Python<'_>,
        motion: PyRef<'_, PyTrajectory>,
        energy: bool,
        forces: bool,
        height: u32,
    ) -> PyResult<PyFilm> {
        let columns = motion.as_super();
        if columns.names[1..=columns.entries] != self.declared.state_names() {
            return Err(PyValueError::new_err("the motion is that of another system"));
        }
        let (times, states) = (columns.column(py, 0).as_array().to_vec(), columns.states(py));
        let without = |_| PyValueError::new_err("a film needs bodies, and the declaration has none");
        let system = self.with(py, Product::Drawing).map_err(without)?;
        let film = DeclaredFilm::new(&system, &times, states.iter().map(Vec::as_slice), forces);
        let film = film.and_then(|film| match columns.place("energy") {
            Ok(place) if energy => film.with_column("energy", &columns.column(py, place).as_array().to_vec()),
            _ => Ok(film),
        });
        let film = film.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(PyFilm::new(film, height))
    }

    #[doc = described!(System.ensemble)]
    #[pyo3(signature = (starts=None, *, until, parameters=None, begin=0.0, method=None, tolerance=None, step=None, seed=None, threads=None))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords of Python")]
    fn ensemble(
        &self,
        py: Python<'_>,
        starts: Option<&Bound<'_, PyAny>>,
        until: f64,
        parameters: Option<&Bound<'_, PyDict>>,
        begin: f64,
        method: Option<&str>,
        tolerance: Option<f64>,
        step: Option<f64>,
        seed: Option<u64>,
        threads: Option<usize>,
    ) -> PyResult<Py<PyEnsemble>> {
        let method = chosen(method, tolerance, step, seed)?;
        let (starts, varied) = motions(&self.declared, starts, parameters)?;
        let settings = EnsembleSettings { starts, varied, from: begin, until, method, threads };
        let system = self.for_method(py, method)?;
        PyEnsemble::compute(py, &system, &settings)
    }

    #[doc = described!(System.fit)]
    #[pyo3(signature = (data, *, vary, start=None, noise=None, begin=None, tolerance=1e-9, starts=1, max_iterations=200))]
    #[expect(clippy::too_many_arguments, reason = "they are keywords of Python")]
    fn fit(
        &self,
        py: Python<'_>,
        data: &Bound<'_, PyAny>,
        vary: &Bound<'_, PyAny>,
        start: Option<&Bound<'_, PyAny>>,
        noise: Option<&Bound<'_, PyDict>>,
        begin: Option<f64>,
        tolerance: f64,
        starts: usize,
        max_iterations: usize,
    ) -> PyResult<PyFit> {
        self.check_values()?;
        let settings = FitSettings {
            start: self.state("`start`", start)?,
            data: fit::data(data)?,
            varied: fit::varied(vary)?,
            noise: pairs(noise)?,
            from: begin,
            tolerance,
            starts,
            max_iterations,
        };
        PyFit::search(py, &self.declared, &settings, &|fields| {
            let mut declared = self.declared.clone();
            copy_values(&mut declared, fields)?;
            Ok(Py::new(py, self.around(declared))?.into_any())
        })
    }

    #[doc = described!(System.equilibrium)]
    #[pyo3(signature = (near=None, *, hold=None, trim=None, time=0.0))]
    fn equilibrium(
        &self,
        py: Python<'_>,
        near: Option<&Bound<'_, PyAny>>,
        hold: Option<&Bound<'_, PyAny>>,
        trim: Option<&Bound<'_, PyAny>>,
        time: f64,
    ) -> PyResult<PyEquilibrium> {
        let settings = SearchSettings {
            time,
            near: self.state("`near`", near)?,
            hold: names("`hold`", hold)?,
            trim: names("`trim`", trim)?,
        };
        PyEquilibrium::search(py, &self.with_derivatives(py)?, settings)
    }

    #[doc = described!(System.linearise)]
    #[pyo3(signature = (state=None, *, time=0.0))]
    fn linearise(
        &self,
        py: Python<'_>,
        state: Option<&Bound<'_, PyAny>>,
        time: f64,
    ) -> PyResult<PyLinearModel> {
        PyLinearModel::new(py, &self.with_derivatives(py)?, time, &self.state("`state`", state)?)
    }

    #[doc = described!(System.equations)]
    fn equations(&self, py: Python<'_>) -> PyResult<String> {
        Ok(self.derived(py)?.documentation().join("\n"))
    }

    #[doc = described!(System.latex)]
    fn latex(&self, py: Python<'_>) -> PyResult<String> {
        Ok(self.derived(py)?.equations_latex())
    }

    /// Returns the equations for Jupyter.
    fn _repr_latex_(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("$${}$$", self.latex(py)?))
    }

    #[doc = described!(System.c)]
    fn c(&self) -> PyResult<(String, String)> {
        let module = Module::new(self.declared.programs(), None);
        let module = module.map_err(|refusal| PyValueError::new_err(refusal.to_string()))?;
        Ok((module.header, module.source))
    }

    #[doc = described!(System.rust)]
    fn rust(&self, py: Python<'_>) -> PyResult<String> {
        let items = self.derived(py)?.emit(&quote!(::lagrange));
        let items = items.map_err(|report| declaration_error(py, &report))?;
        let file = syn::parse2(items).map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(prettyplease::unparse(&file))
    }

    fn __repr__(&self) -> String {
        format!("<System of {}>", self.declared.state_names().join(", "))
    }
}

impl PySystem {
    fn of(py: Python<'_>, source: Source, compile: bool) -> PyResult<Self> {
        let backend = compile.then(compiler).transpose()?;
        let declared = runnable(&derive(py, source.system())?, backend)?;
        Ok(PySystem { source, declared, derivatives: Arc::default() })
    }

    /// Returns the system with other values.
    fn around(&self, declared: DeclaredSystem) -> PySystem {
        PySystem { declared, source: self.source.clone(), derivatives: self.derivatives.clone() }
    }

    /// Returns the system with its system matrix.
    fn with_derivatives(&self, py: Python<'_>) -> PyResult<DeclaredSystem> {
        self.check_values()?;
        self.with(py, Product::SystemMatrix)
    }

    /// Returns the derivatives of the rates by a range of parameters and inputs, in this order.
    fn by_fields<'py>(
        &self,
        py: Python<'py>,
        t: f64,
        y: &Bound<'_, PyAny>,
        chosen: impl Fn(usize) -> Range<usize>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let y = self.entries("`y`", y)?;
        let (q, v) = y.split_at(self.declared.programs().layout.positions);
        let (count, parameters) =
            (self.declared.variables().fields.len(), self.declared.programs().layout.parameters);
        let columns = chosen(parameters);
        if columns.is_empty() {
            return Ok(PyArray2::zeros(py, [y.len(), 0], false));
        }
        let system = self.with(py, Product::ParameterJacobian)?;
        let program = system.programs().parameter_jacobian.as_ref();
        let program = program.ok_or_else(|| PyValueError::new_err("the rates have no derivatives"))?;
        let entries = system.numeric().evaluate(program, t, q, v);
        let rows = entries.chunks(count).flat_map(|row| row[columns.clone()].to_vec());
        PyArray1::from_iter(py, rows).reshape([y.len(), columns.len()])
    }

    /// Returns the system with a product.
    fn with(&self, py: Python<'_>, product: Product) -> PyResult<DeclaredSystem> {
        self.derivatives.with(py, (&self.source, &self.declared), product)
    }

    /// Returns the system with the product of a method, or the system itself if it needs none.
    fn for_method(&self, py: Python<'_>, method: MethodChoice) -> PyResult<DeclaredSystem> {
        method.product().map_or_else(|| Ok(self.declared.clone()), |product| self.with(py, product))
    }

    fn derived(&self, py: Python<'_>) -> PyResult<Derived> {
        derive(py, self.source.system())
    }

    /// Returns the state from an array or from a dictionary of entries, or the declared initial
    /// state.
    fn state(&self, argument: &str, start: Option<&Bound<'_, PyAny>>) -> PyResult<Vec<f64>> {
        let Some(start) = start else { return start_of(&self.declared, &[]) };
        if let Ok(values) = start.cast::<PyDict>() {
            return start_of(&self.declared, &pairs(Some(values))?);
        }
        let state = self.entries(argument, start)?;
        let checked = self.declared.check_state(&state);
        checked.map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(state)
    }

    /// Returns the entries of a state.
    fn entries(&self, argument: &str, state: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
        let (state, names) = (numbers(argument, state)?, self.declared.state_names());
        match state.len() == names.len() {
            true => Ok(state),
            false => Err(PyValueError::new_err(format!(
                "a state has {} entries, {}, but {} are given",
                names.len(),
                names.join(", "),
                state.len()
            ))),
        }
    }

    fn check_values(&self) -> PyResult<()> {
        check_values(&self.declared)
    }
}
