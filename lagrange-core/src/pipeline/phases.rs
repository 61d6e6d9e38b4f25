//! The phases after parsing, for a system and for its reduced types.

use proc_macro2::TokenStream;
use quote::quote;

use crate::derive::{Equations, StrategyChoice, derive};
use crate::elaborate::elaborate;
use crate::emit;
use crate::model::{Model, Product, Reduced};
use lagrange_expr::diagnostics::Report;
use lagrange_expr::units::{NamedUnits, momentum_name};
use lagrange_language::bodies::plain;
use lagrange_language::dimensions::{check_dimensions, in_coherent_units};
use lagrange_language::expand::{
    has_arrays, name_elements, once_for_each_array, without_arrays, without_repetitions,
};
use lagrange_language::inline::{name_delays, without_functions};
use lagrange_language::syntax::ast::{Declaration, Name, momentum_of};
use lagrange_language::tables::name_files;

/// A reduced type with its equations of motion.
#[derive(Clone, Debug)]
pub struct DerivedPart {
    /// Declaration of the whole system, without the frozen coordinates.
    pub declaration: Declaration,
    /// Reduction and remaining model.
    pub reduced: Reduced,
    /// Equations of the remaining model.
    pub equations: Equations,
}

/// Returns the declaration in plain statements and its model; no model after an error.
pub(super) fn model_of(declaration: Declaration, report: &mut Report) -> (Declaration, Option<Model>) {
    let (declaration, model) = checked(declaration, report);
    name_files(&declaration, report);
    (declaration, model)
}

fn checked(mut declaration: Declaration, report: &mut Report) -> (Declaration, Option<Model>) {
    let (mistakes, is_written_out) = (report.diagnostics().len(), has_arrays(&mut declaration));
    let declaration = without_arrays(declaration, report);
    if report.diagnostics().len() > mistakes {
        // Errors caused by statements that could not be expanded are not reported.
        return (declaration, None);
    }
    if emit::report_too_many(&declaration, report).is_none() {
        return (declaration, None);
    }
    let mut declaration = without_functions(declaration, report);
    name_delays(&mut declaration);
    let measured = in_coherent_units(&mut declaration, report);
    let plain = plain(declaration, report);
    if emit::report_too_many(&plain.declaration, report).is_none() {
        return (plain.without(&[]), None);
    }
    let mut model = elaborate(&plain, report);
    if let Some(model) = &mut model {
        name_units(model, &check_dimensions(&plain.declaration, measured, report));
    }
    let model = model.filter(|_| !report.has_errors());
    without_repetitions(report);
    if is_written_out {
        once_for_each_array(&plain.declaration, report);
        name_elements(&plain.declaration, report);
    }
    let mut declaration = plain.without(model.as_ref().map_or(&[], |model| &model.implied));
    declaration.attributes = emit::attributes_of_struct(&declaration, report.diagnostics());
    (declaration, model)
}

fn name_units(model: &mut Model, units: &NamedUnits) {
    for Reduced { reduction, model: part } in &mut model.reduced {
        part.units = units.clone();
        for pinned in &reduction.ignored {
            let coordinate = &model.coordinates[pinned.coordinate].name;
            let unit = units.get(&momentum_name(coordinate)).cloned();
            let name = momentum_of(&Name::new(coordinate.clone(), pinned.span)).text;
            unit.into_iter().for_each(|unit| part.units.insert(&name, unit));
        }
    }
    model.units = units.clone();
}

/// Returns the equations of a model and of its reduced types, which are removed from the model.
pub(super) fn equations_of(
    declaration: &Declaration,
    model: &mut Model,
    choice: StrategyChoice,
    report: &mut Report,
) -> Option<(Equations, Vec<DerivedPart>)> {
    let equations = derived(declaration, model, choice, report);
    name_elements(declaration, report);
    name_files(declaration, report);
    equations
}

fn derived(
    declaration: &Declaration,
    model: &mut Model,
    choice: StrategyChoice,
    report: &mut Report,
) -> Option<(Equations, Vec<DerivedPart>)> {
    emit::report_hopeless_model(declaration, model, report)?;
    let equations = derive(declaration, None, model, choice, report)?;
    let reduced = std::mem::take(&mut model.reduced);
    let declarations = emit::reduced_declarations(declaration, &reduced);
    let parts = declarations.into_iter().zip(reduced).map(|(declaration, mut reduced)| {
        emit::report_hopeless_model(&declaration, &reduced.model, report)?;
        let place = Some(declaration.name.span);
        let equations = derive(&declaration, place, &mut reduced.model, choice, report)?;
        Some(DerivedPart { declaration, reduced, equations })
    });
    let parts = parts.collect::<Option<Vec<_>>>()?;
    Some((equations, parts))
}

/// Returns the items of a system, then those of its reduced types with their conversions.
pub(super) fn items_of(
    system: (&Declaration, &mut Model, &Equations),
    parts: Vec<DerivedPart>,
    krate: &TokenStream,
    report: &mut Report,
) -> Option<TokenStream> {
    let declaration = system.0;
    let items = emitted(system, parts, krate, report);
    name_elements(declaration, report);
    name_files(declaration, report);
    items
}

fn emitted(
    (declaration, model, equations): (&Declaration, &mut Model, &Equations),
    parts: Vec<DerivedPart>,
    krate: &TokenStream,
    report: &mut Report,
) -> Option<TokenStream> {
    let has_statements = !declaration.bodies.is_empty()
        || !declaration.placed.is_empty()
        || model.products.contains(&Product::Statements);
    let statements = has_statements.then(|| emit::statements(declaration));
    let mut items = emit::system(declaration, model, equations, statements.as_deref(), krate, report)?;
    for DerivedPart { declaration: of_part, mut reduced, equations: reduced_equations } in parts {
        // The plain statements are only documented for the whole system.
        let part = emit::system(&of_part, &mut reduced.model, &reduced_equations, None, krate, report)?;
        let (full, reduced) = ((declaration, &*model, equations), (&of_part, &reduced, &reduced_equations));
        let conversions = emit::conversions(full, reduced, krate, report)?;
        items.extend(quote!(#part #conversions));
    }
    Some(items)
}
