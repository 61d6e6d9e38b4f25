//! Reasons why a derived system cannot be written.

use proc_macro2::Span;

use super::callees::{MissingDerivative, report_missing};
use super::exclusion::Exclusion;
use super::messages;
use super::size::report_hopeless;
use crate::model::Product;
use lagrange_algebra::code::Precision;
use lagrange_algebra::series::NoSeries;
use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::{Declaration, ScalarType};

/// Reason why a system cannot be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(in crate::emit) enum Refusal {
    /// These constants, as text, cannot be represented by the scalar.
    Constants(Vec<String>),
    /// These derivatives of functions of the user's crate are called but not declared.
    Derivatives(Vec<MissingDerivative>),
    /// The code is too large for the compiler.
    Size,
    /// This product is incompatible with a property of the system.
    Exclusion(Product, Exclusion),
    /// The motion has no Taylor series.
    Series(NoSeries),
    /// No parameter multiplies the inverse dynamics.
    NothingLinear,
    /// A kernel in this precision cannot represent these constants, given as text.
    KernelConstants(Precision, Vec<String>),
}

/// Reports the reason why a system cannot be written.
pub(in crate::emit) fn report_refusal(declaration: &Declaration, refusal: &Refusal, report: &mut Report) {
    match refusal {
        Refusal::Constants(constants) => report_too_large(declaration, constants, report),
        Refusal::Derivatives(missing) => report_missing(declaration, missing, report),
        Refusal::Size => report_hopeless(declaration, report),
        Refusal::Exclusion(product, exclusion) => {
            let message = messages::excluded(product.name(), exclusion.words());
            report.error(demand(declaration, *product), message).help(messages::without(*product));
        }
        Refusal::Series(cause) => {
            let message = messages::without_series(cause);
            report.error(demand(declaration, Product::Taylor), message).help(messages::WITHOUT_SERIES_HELP);
        }
        Refusal::NothingLinear => {
            let place = demand(declaration, Product::Regressor);
            report.error(place, messages::NOTHING_LINEAR).help(messages::NOTHING_LINEAR_HELP);
        }
        Refusal::KernelConstants(precision, constants) => {
            let message = messages::large_in_kernel(*precision, constants);
            report.error(demand(declaration, Product::Kernel), message).help(messages::LARGE_IN_KERNEL_HELP);
        }
    }
}

/// Returns the place where a product is requested.
fn demand(declaration: &Declaration, product: Product) -> Span {
    declaration.demand(product.name()).unwrap_or(&declaration.name).span
}

/// Reports constants from the derivation that the scalar cannot represent; constants in the
/// declaration have already been checked.
fn report_too_large(declaration: &Declaration, constants: &[String], report: &mut Report) {
    let (scalar, largest) = match &declaration.scalar {
        ScalarType::F32 => ("f32", f64::from(f32::MAX)),
        ScalarType::F64 | ScalarType::Generic(_) => ("f64", f64::MAX),
    };
    let message = format!("the equations contain numbers too large for `{scalar}`: {}", constants.join(", "));
    let help = format!("`{scalar}` holds numbers up to about {largest:.1e}: choose larger units");
    report.error(declaration.name.span, message).help(help);
}
