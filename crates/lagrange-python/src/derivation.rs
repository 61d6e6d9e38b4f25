//! Systems from declarations, with additional products derived on demand.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use lagrange_core::derive::StrategyChoice;
use lagrange_core::diagnostics::Report;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{Backend, Derived, Programs, System};
use lagrange_dynamic::{DeclaredSystem, Source};
use lagrange_jit::Compiler;
use pyo3::exceptions::{PyKeyError, PyValueError};
use pyo3::{PyResult, Python};

use crate::error::declaration_error;

/// A system with additional products, each derived when it is first used.
#[derive(Default)]
pub(crate) struct Derivatives {
    known: Mutex<BTreeMap<Product, DeclaredSystem>>,
}

impl Derivatives {
    /// Returns the system with a product, and with the values of another. Its programs are compiled
    /// if those of the other are.
    pub(crate) fn with(
        &self,
        py: Python<'_>,
        (source, values): (&Source, &DeclaredSystem),
        product: Product,
    ) -> PyResult<DeclaredSystem> {
        let known = self.known().get(&product).cloned();
        let mut system = match known {
            Some(known) => known,
            None => {
                let backend = values.numeric().backend().cloned();
                let found = runnable(&derive(py, source.system_with(product.name()))?, backend)?;
                self.known().entry(product).or_insert(found).clone()
            }
        };
        copy_values(&mut system, values.numeric().fields())?;
        Ok(system)
    }

    fn known(&self) -> MutexGuard<'_, BTreeMap<Product, DeclaredSystem>> {
        self.known.lock().unwrap_or_else(PoisonError::into_inner)
    }
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
