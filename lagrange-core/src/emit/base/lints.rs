//! Exceptions from lints that emitted items need.

use std::f64::consts;

use proc_macro2::TokenStream;
use quote::quote;

use super::shape::Shape;
use lagrange_algebra::program::Op;

/// Constants of the standard library that numbers can be mistaken for.
const NAMED: [f64; 10] = [
    consts::PI,
    consts::E,
    consts::SQRT_2,
    consts::FRAC_1_SQRT_2,
    consts::LN_2,
    consts::LN_10,
    consts::LOG2_E,
    consts::LOG10_E,
    consts::LOG2_10,
    consts::LOG10_2,
];
/// Relative distance beyond which a number is not mistaken for a constant or its multiples by
/// powers of two.
const UNLIKE: f64 = 1e-3;

/// True for constants that are rounded or resemble those of the standard library.
pub(in crate::emit) fn looks_rounded(op: &Op) -> bool {
    let is_near = |number: f64| {
        let is_like = |named: f64| (number.abs() / named - 1.0).abs() < UNLIKE;
        NAMED.iter().any(|named| [0.125, 0.25, 0.5, 1.0, 2.0].iter().any(|factor| is_like(named * factor)))
    };
    match op {
        Op::Float(_) => true,
        Op::Constant(number) => is_near(number.to_f64()),
        _ => false,
    }
}

/// Lets rounded constants resemble those of the standard library.
pub(in crate::emit) fn rounded_exception(is_needed: bool) -> Option<TokenStream> {
    is_needed.then(
        || quote!(#[allow(clippy::approx_constant, reason = "constants are rounded to the scalar once")]),
    )
}

/// Lets type names follow the name of the struct, so that only the latter causes a warning.
pub(in crate::emit) fn type_name_exception(shape: &Shape<'_>) -> Option<TokenStream> {
    let name = shape.declaration.name.text.trim_matches('_');
    let is_camel_case = !name.starts_with(char::is_lowercase) && !name.contains('_');
    let exception = quote!(#[allow(non_camel_case_types, reason = "the name goes with that of the system")]);
    (!is_camel_case).then_some(exception)
}

/// Lets names keep their letters from formulas.
pub(in crate::emit) fn name_exception(shape: &Shape<'_>) -> Option<TokenStream> {
    let touching = shape.touching.iter().map(|(name, _)| name);
    let outputs = shape.outputs.iter().map(|(name, _)| name);
    let velocities = shape.velocities.iter().map(|velocity| &velocity.name);
    let names = shape.fields.iter().chain(&shape.coordinates).copied().chain(velocities);
    let names = names.chain(touching.copied()).chain(outputs);
    // The names of their methods continue with an underscore.
    let bodies = shape.bodies.iter().chain(&shape.frames).chain(&shape.frames_with_jacobian);
    let names = names.map(|name| name.text.clone()).chain(bodies.map(|name| format!("{}_", name.text)));
    let names = names.chain(shape.callees.iter().map(|name| name.text.clone()));
    let is_snake_case = |name: &str| !name.contains(char::is_uppercase) && !name.contains("__");
    let exception =
        quote!(#[allow(non_snake_case, reason = "symbols keep the letters they have in formulas")]);
    (!{ names }.all(|name| is_snake_case(&name))).then_some(exception)
}

/// Lets public fields begin with an underscore.
pub(in crate::emit) fn unused_exception(shape: &Shape<'_>) -> Option<TokenStream> {
    let touching = shape.touching.iter().map(|(name, _)| name);
    let is_unused = shape.fields.iter().chain(touching).any(|name| name.text.starts_with('_'));
    is_unused.then(|| {
        quote!(#[allow(clippy::pub_underscore_fields, reason = "the user marked the parameter as unused")])
    })
}
