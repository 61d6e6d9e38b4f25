//! Declared systems as a Python module.
//!
//! The module reads declarations as text, compiles them by `lagrange-jit` and runs them by
//! `lagrange-dynamic`: motions have the bits of compiled Rust. `lagrange.pyi` documents it for
//! those who use it.
#![forbid(unsafe_code)]

include!(concat!(env!("OUT_DIR"), "/described.rs"));

mod columns;
mod derivation;
mod ensemble;
mod error;
mod fit;
mod interrupt;
mod linear;
mod motion;
mod picture;
mod product;
mod simulation;
mod system;
mod values;

use pyo3::types::{PyModule, PyModuleMethods};
use pyo3::{Bound, PyResult, pymodule};

#[doc = described!(lagrange)]
#[pymodule(name = "lagrange")]
fn contents(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<system::PySystem>()?;
    module.add_class::<columns::PyColumns>()?;
    module.add_class::<motion::PyTrajectory>()?;
    module.add_class::<picture::PyPlot>()?;
    module.add_class::<picture::PyFilm>()?;
    module.add_class::<ensemble::PyEnsemble>()?;
    module.add_class::<fit::PyFit>()?;
    module.add_class::<linear::PyEquilibrium>()?;
    module.add_class::<linear::PyLinearModel>()?;
    module.add_class::<linear::PyMode>()?;
    module.add("DeclarationError", module.py().get_type::<error::DeclarationError>())?;
    module.add("EquilibriumError", module.py().get_type::<error::EquilibriumError>())?;
    module.add("FitError", module.py().get_type::<error::FitError>())?;
    module.add("SimulationError", module.py().get_type::<error::SimulationError>())
}
