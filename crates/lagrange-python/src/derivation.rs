//! Systems from declarations, with additional products derived on demand.

use std::sync::{Arc, OnceLock};

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::pipeline::{Backend, Derived, Programs, System};
use lagrange_dynamic::{DeclaredSystem, MethodChoice, Source};
use lagrange_jit::Compiler;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::{PyResult, Python};

use crate::error::declaration_error;

/// A system with additional products, each empty until first used.
#[derive(Default)]
pub(crate) struct Derivatives {
    linearised: OnceLock<DeclaredSystem>,
    differentiated: OnceLock<DeclaredSystem>,
    parametric: OnceLock<DeclaredSystem>,
    drawn: OnceLock<DeclaredSystem>,
    expanded: OnceLock<DeclaredSystem>,
}

impl Derivatives {
    /// Returns the system with its system matrix.
    pub(crate) fn linearised(
        &self,
        py: Python<'_>,
        source: &Source,
        system: &DeclaredSystem,
    ) -> PyResult<DeclaredSystem> {
        with_product(py, &self.linearised, (source, "system_matrix"), system)
    }

    /// Returns the system with the derivatives of its rates by the state.
    pub(crate) fn differentiated(
        &self,
        py: Python<'_>,
        source: &Source,
        system: &DeclaredSystem,
    ) -> PyResult<DeclaredSystem> {
        with_product(py, &self.differentiated, (source, "jacobian"), system)
    }

    /// Returns the system with the derivatives of its rates by parameters and inputs.
    pub(crate) fn parametric(
        &self,
        py: Python<'_>,
        source: &Source,
        system: &DeclaredSystem,
    ) -> PyResult<DeclaredSystem> {
        with_product(py, &self.parametric, (source, "parameter_jacobian"), system)
    }

    /// Returns the system with the product of a method, or the system itself if it needs none.
    pub(crate) fn for_method(
        &self,
        py: Python<'_>,
        source: &Source,
        system: &DeclaredSystem,
        method: MethodChoice,
    ) -> PyResult<DeclaredSystem> {
        match method.product() {
            Some(product) => with_product(py, &self.expanded, (source, product.name()), system),
            None => Ok(system.clone()),
        }
    }

    /// Returns the system with its drawing.
    ///
    /// # Errors
    /// `ValueError` if it has no bodies.
    pub(crate) fn drawn(
        &self,
        py: Python<'_>,
        source: &Source,
        system: &DeclaredSystem,
    ) -> PyResult<DeclaredSystem> {
        let without = |_| PyValueError::new_err("a film needs bodies, and the declaration has none");
        with_product(py, &self.drawn, (source, "drawing"), system).map_err(without)
    }
}

/// The system with a product, and with the values of another. Its programs are compiled if those of
/// the other are.
fn with_product(
    py: Python<'_>,
    known: &OnceLock<DeclaredSystem>,
    (source, product): (&Source, &str),
    values: &DeclaredSystem,
) -> PyResult<DeclaredSystem> {
    let mut system = match known.get() {
        Some(known) => known.clone(),
        None => {
            let backend = values.numeric().backend().cloned();
            let found = runnable(&derive(py, source.system_with(product))?, backend)?;
            known.get_or_init(|| found).clone()
        }
    };
    copy_values(&mut system, values.numeric().fields())?;
    Ok(system)
}

/// Sets all parameters and inputs except delayed signals, whose values runs compute.
///
/// # Errors
/// `KeyError` if the system has fewer values.
pub(crate) fn copy_values(system: &mut DeclaredSystem, values: &[f64]) -> PyResult<()> {
    let names = system.variables().fields.clone();
    let settable = system.settable().map(str::to_owned).collect::<Vec<_>>();
    let mut pairs = names.iter().zip(values).filter(|(name, _)| settable.contains(name));
    let set = pairs.try_for_each(|(name, value)| system.set(name, *value));
    set.map_err(|error| PyKeyError::new_err(error.to_string()))
}

/// Derives equations.
///
/// # Errors
/// `DeclarationError` with all errors.
pub(crate) fn derive(py: Python<'_>, system: Result<System, Report>) -> PyResult<Derived> {
    let derived = system.and_then(|system| system.derive(StrategyChoice::Cheapest));
    derived.map_err(|report| declaration_error(py, &report))
}

/// Returns a system that can be run, as machine code if there is a compiler.
///
/// # Errors
/// `ValueError` for what only compiled Rust can run.
pub(crate) fn runnable(derived: &Derived, backend: Option<Arc<dyn Backend>>) -> PyResult<DeclaredSystem> {
    let declared = DeclaredSystem::new(Programs::new(derived));
    let declared = declared.map_err(|refusal| PyValueError::new_err(refusal.to_string()))?;
    Ok(match backend {
        Some(backend) => declared.compiled_by(backend),
        None => declared,
    })
}

/// Returns the compiler of machine code, one for all systems.
///
/// # Errors
/// `ValueError` if it does not know the processor.
pub(crate) fn compiler() -> PyResult<Arc<dyn Backend>> {
    static COMPILER: OnceLock<Arc<Compiler>> = OnceLock::new();
    if let Some(known) = COMPILER.get() {
        return Ok(known.clone());
    }
    let unknown = |error| PyValueError::new_err(format!("{error}; `compile=False` interprets the system"));
    let compiler = Compiler::for_this_processor().map_err(unknown)?;
    Ok(COMPILER.get_or_init(|| compiler).clone())
}
