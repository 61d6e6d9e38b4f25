//! Products of a system by name.

use lagrange_core::model::{Product, ProductArguments, ProductShape};
use lagrange_dynamic::DeclaredSystem;
use numpy::{PyArrayDyn, PyArrayMethods, ToPyArray};
use pyo3::exceptions::PyValueError;
use pyo3::{Bound, PyResult, Python};

/// Returns the product of this name.
///
/// # Errors
/// `ValueError` for derivatives of the rates, which have methods of their own, and for what is no
/// function of the state.
pub(crate) fn product_named(name: &str) -> PyResult<Product> {
    let is_function = |product: &Product| product.row().method.is_some() && !product.is_derivative();
    Product::by_name(name).filter(is_function).ok_or_else(|| {
        let known = Product::ALL.into_iter().filter(is_function).map(Product::name).collect::<Vec<_>>();
        PyValueError::new_err(format!("there is no product `{name}`; known are {}", known.join(", ")))
    })
}

/// Computes a product at a time, a state and, for those that take them, accelerations.
///
/// # Errors
/// Those of [`entries_of`].
pub(crate) fn evaluated<'py>(
    py: Python<'py>,
    system: &DeclaredSystem,
    product: Product,
    at: (f64, &[f64], Option<&[f64]>),
) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let found = entries_of(system, product, at)?;
    let shape = match product.row().method.as_ref().map(|method| method.returns) {
        None | Some(ProductShape::Scalar) => Vec::new(),
        Some(returns) => system.programs().layout.shape_of(returns, found.len()),
    };
    found.to_pyarray(py).reshape(shape)
}

/// Computes the entries of a product, row by row.
///
/// # Errors
/// `ValueError` if the system excludes it, or if accelerations are missing or too many.
pub(crate) fn entries_of(
    system: &DeclaredSystem,
    product: Product,
    (t, y, a): (f64, &[f64], Option<&[f64]>),
) -> PyResult<Vec<f64>> {
    let (name, layout) = (product.name(), &system.programs().layout);
    let excluded = || PyValueError::new_err(format!("the declaration excludes `{name}`"));
    let program = system.programs().product(product).ok_or_else(excluded)?;
    let takes_accelerations =
        product.row().method.as_ref().is_some_and(|method| method.arguments == ProductArguments::Motion);
    match a {
        Some(a) if takes_accelerations && a.len() == layout.velocities => {
            let (q, v) = y.split_at(layout.positions);
            system.numeric().with_accelerations(product, (t, q, v, a)).ok_or_else(excluded)
        }
        None if !takes_accelerations => Ok(system.evaluate(program, t, y)),
        _ if takes_accelerations => {
            Err(PyValueError::new_err(format!("`{name}` needs `a`, an acceleration for each velocity")))
        }
        _ => Err(PyValueError::new_err(format!("`{name}` does not depend on accelerations"))),
    }
}
