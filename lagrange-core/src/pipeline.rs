//! The whole of it on one screen: text or tokens → declaration → plain statements → model → equations → items.

mod numeric;
mod second_way;

use proc_macro2::{Span, TokenStream};
use quote::quote;

use crate::bodies::plain;
use crate::derive::{Equations, RoadChoice, undetermined};
use crate::diagnostics::Report;
use crate::elaborate::elaborate;
use crate::emit::{self, Emitted, Refusal};
use crate::model::{Model, Product, Reduced};
use crate::syntax::ast::{Declaration, StatementKind};
use crate::syntax::{parse_text, parse_tokens, print};

pub use numeric::NumericSystem;

/// A declaration with its checked model.
#[derive(Clone, Debug)]
pub struct System {
    /// What the user wrote, in plain statements.
    pub declaration: Declaration,
    /// What it means.
    pub model: Model,
    /// Warnings.
    pub report: Report,
}

/// A system with its equations of motion.
#[derive(Clone, Debug)]
pub struct Derived {
    /// What the user wrote, in plain statements.
    pub declaration: Declaration,
    /// What it means.
    pub model: Model,
    /// What follows.
    pub equations: Equations,
    /// The reduced types.
    pub reduced: Vec<DerivedPart>,
    /// Warnings.
    pub report: Report,
}

/// A reduced type with its equations of motion.
#[derive(Clone, Debug)]
pub struct DerivedPart {
    /// The declaration of the whole system, without the frozen coordinates.
    pub declaration: Declaration,
    /// What is reduced, and the model that remains.
    pub reduced: Reduced,
    /// What follows.
    pub equations: Equations,
}

/// Reads and checks a system from text: a whole declaration, or only its statements.
///
/// # Errors
/// Everything that is wrong with the declaration.
pub fn parse(text: &str) -> Result<System, Report> {
    let mut report = Report::default();
    let Some(declaration) = parse_text(text, &mut report) else { return Err(report) };
    let plain = plain(declaration, &mut report);
    match elaborate(&plain, &mut report) {
        Some(model) => Ok(System { declaration: plain.without(&model.implied), model, report }),
        None => Err(report),
    }
}

impl System {
    /// The statements, one on each line; those about rigid bodies in plain words.
    pub fn statements(&self) -> String {
        statements(&self.declaration)
    }

    /// Derives the equations of motion.
    ///
    /// # Errors
    /// If the mass matrix is singular whatever the parameters are.
    pub fn derive(self, road: RoadChoice) -> Result<Derived, Report> {
        let System { declaration, mut model, mut report } = self;
        let equations = derive(&declaration, None, &mut model, road, &mut report);
        let reduced = equations.is_some().then(|| derive_parts(&declaration, &mut model, road, &mut report));
        match equations.zip(reduced.flatten()) {
            Some((equations, reduced)) => Ok(Derived { declaration, model, equations, reduced, report }),
            None => Err(report),
        }
    }
}

impl Derived {
    /// The emitted items. `krate` is the path of the crate `lagrange` where they will stand.
    ///
    /// # Errors
    /// If a constant is too large for the scalar.
    pub fn emit(mut self, krate: &TokenStream) -> Result<TokenStream, Report> {
        let Derived { declaration, model, equations, reduced, report } = &mut self;
        let statements = plain_statements(declaration);
        let items = emit(declaration, model, equations, krate, statements.as_deref(), report);
        let parts = emit_parts((declaration, model, equations), reduced, krate, report);
        items.zip(parts).map(|(items, parts)| quote!(#items #parts)).ok_or(self.report)
    }

    /// The equations, the structure and the cost of the system in lines of Markdown, as they stand in the
    /// documentation of the emitted struct.
    pub fn documentation(&mut self) -> Vec<String> {
        emit::documentation(&mut self.model, &self.equations)
    }

    /// M q̈ = f in LaTeX, one line for each coordinate after the definitions of abbreviations that keep them
    /// short.
    pub fn equations_latex(&mut self) -> String {
        emit::equations_latex(&mut self.model, &self.equations)
    }
}

/// The macro: everything emitted for a declaration, mistakes included.
pub fn expand(tokens: TokenStream, krate: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let items = parse_tokens(tokens, &mut report).map(|declaration| {
        let plain = plain(declaration, &mut report);
        let model = elaborate(&plain, &mut report);
        let mut declaration = plain.without(model.as_ref().map_or(&[], |model| &model.implied));
        let underivable = declaration.underivable().iter().map(|name| name.text.clone()).collect::<Vec<_>>();
        let attributes = declaration.attributes;
        declaration.attributes = emit::of_struct(&attributes, &underivable, report.diagnostics());
        let items = model.and_then(|mut model| {
            emit::report_hopeless_model(&declaration, &model, &mut report)?;
            let road = RoadChoice::Cheapest;
            let equations = derive(&declaration, None, &mut model, road, &mut report)?;
            let mut parts = derive_parts(&declaration, &mut model, road, &mut report)?;
            let statements = plain_statements(&declaration);
            let items =
                emit(&declaration, &mut model, &equations, krate, statements.as_deref(), &mut report)?;
            let parts = emit_parts((&declaration, &model, &equations), &mut parts, krate, &mut report)?;
            Some(quote!(#items #parts))
        });
        let items = items.unwrap_or_else(|| emit::skeleton(&declaration, krate));
        (items, attributes)
    });
    let (items, attributes) = items.unwrap_or_default();
    let diagnostics = emit::diagnostics(report.diagnostics(), &attributes);
    quote!(#diagnostics #items)
}

/// The equations of a model. That there are none is reported at `place`, or at a coordinate that nothing determines.
fn derive(
    declaration: &Declaration,
    place: Option<Span>,
    model: &mut Model,
    road: RoadChoice,
    report: &mut Report,
) -> Option<Equations> {
    let singular = match Equations::derive(model, road) {
        Ok(equations) => return Some(equations),
        Err(error) => error,
    };
    let coordinates = declaration.coordinates();
    let moving = undetermined(model).into_iter().filter_map(|index| coordinates.get(index).copied());
    let moving = moving.collect::<Vec<_>>();
    let is_energy =
        |kind: &StatementKind| matches!(kind, StatementKind::Kinetic(_) | StatementKind::Lagrangian(_));
    let energy = declaration.statements.iter().find(|statement| is_energy(&statement.kind));
    let place = place.or(moving.first().map(|name| name.span)).or(energy.map(|energy| energy.origin.start));
    let place = place.unwrap_or(declaration.name.span);
    let names = moving.iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
    report.error(place, singular.message(&names)).help(singular.help());
    None
}

/// The equations of the reduced types, which are taken out of the model.
fn derive_parts(
    declaration: &Declaration,
    model: &mut Model,
    road: RoadChoice,
    report: &mut Report,
) -> Option<Vec<DerivedPart>> {
    let reduced = std::mem::take(&mut model.reduced);
    let declarations = emit::reduced_declarations(declaration, &reduced);
    let parts = declarations.into_iter().zip(reduced).map(|(declaration, mut reduced)| {
        emit::report_hopeless_model(&declaration, &reduced.model, report)?;
        let place = Some(declaration.name.span);
        let equations = derive(&declaration, place, &mut reduced.model, road, report)?;
        Some(DerivedPart { declaration, reduced, equations })
    });
    parts.collect()
}

/// The items of the reduced types, with their conversions.
fn emit_parts(
    full: (&Declaration, &Model, &Equations),
    parts: &mut [DerivedPart],
    krate: &TokenStream,
    report: &mut Report,
) -> Option<TokenStream> {
    let mut items = TokenStream::new();
    for DerivedPart { declaration, reduced, equations } in parts {
        // What the statements of the whole system stand for is said there.
        items.extend(emit(declaration, &mut reduced.model, equations, krate, None, report)?);
        let refused = |refusal: &Refusal| emit::report_refusal(declaration, refusal, report);
        let part = (&*declaration, &*reduced, &*equations);
        items.extend(emit::conversions(full, part, krate).inspect_err(refused).ok()?);
    }
    Some(items)
}

/// The plain statements, if others stand for rigid bodies.
fn plain_statements(declaration: &Declaration) -> Option<String> {
    (!declaration.bodies.is_empty()).then(|| statements(declaration))
}

/// The statements without demands that only those who declare bodies can make.
fn statements(declaration: &Declaration) -> String {
    let mut declaration = declaration.clone();
    let is_of_bodies = |name: &str| Product::ALL.iter().any(|p| p.is_of_bodies() && p.name() == name);
    for statement in &mut declaration.statements {
        if let StatementKind::Emit(items) = &mut statement.kind {
            items.retain(|item| !is_of_bodies(&item.product.text));
        }
    }
    let is_empty = |kind: &StatementKind| matches!(kind, StatementKind::Emit(items) if items.is_empty());
    declaration.statements.retain(|statement| !is_empty(&statement.kind));
    print::statements(&declaration)
}

fn emit(
    declaration: &Declaration,
    model: &mut Model,
    equations: &Equations,
    krate: &TokenStream,
    statements: Option<&str>,
    report: &mut Report,
) -> Option<TokenStream> {
    let emitted = emit::system(declaration, model, equations, statements, krate);
    let refused = |refusal: &Refusal| emit::report_refusal(declaration, refusal, report);
    let Emitted { items, size } = emitted.inspect_err(refused).ok()?;
    emit::report_cost(declaration, size, report);
    emit::report_unlocated(declaration, equations, report);
    Some(items)
}

#[cfg(test)]
mod tests;
