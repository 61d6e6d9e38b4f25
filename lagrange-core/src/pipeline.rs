//! The whole of it on one screen: text or tokens → declaration → model → equations → items.

mod numeric;

use proc_macro2::TokenStream;
use quote::quote;

use crate::diagnostics::Report;
use crate::emit;
use crate::emit::{Emitted, Refusal};
use crate::mechanics::{Equations, Model, RoadChoice, SingularMassMatrix, elaborate};
use crate::syntax::ast::Declaration;
use crate::syntax::{parse_text, parse_tokens};

pub use numeric::NumericSystem;

/// A declaration with its checked model.
#[derive(Clone, Debug)]
pub struct System {
    /// What the user wrote.
    pub declaration: Declaration,
    /// What it means.
    pub model: Model,
    /// Warnings.
    pub report: Report,
}

/// A system with its equations of motion.
#[derive(Clone, Debug)]
pub struct Derived {
    /// What the user wrote.
    pub declaration: Declaration,
    /// What it means.
    pub model: Model,
    /// What follows.
    pub equations: Equations,
    /// Warnings.
    pub report: Report,
}

/// Reads and checks a system from text: a whole declaration, or only its statements.
///
/// # Errors
/// Everything that is wrong with the declaration.
pub fn parse(text: &str) -> Result<System, Report> {
    let mut report = Report::default();
    let Some(declaration) = parse_text(text, &mut report) else { return Err(report) };
    match elaborate(&declaration, &mut report) {
        Some(model) => Ok(System { declaration, model, report }),
        None => Err(report),
    }
}

impl System {
    /// Derives the equations of motion.
    ///
    /// # Errors
    /// If the mass matrix is singular whatever the parameters are.
    pub fn derive(mut self, road: RoadChoice) -> Result<Derived, Report> {
        match derive(&self.declaration, &mut self.model, road, &mut self.report) {
            Some(equations) => {
                let System { declaration, model, report } = self;
                Ok(Derived { declaration, model, equations, report })
            }
            None => Err(self.report),
        }
    }
}

impl Derived {
    /// The emitted items. `krate` is the path of the crate `lagrange` where they will stand.
    ///
    /// # Errors
    /// If a constant is too large for the scalar.
    pub fn emit(mut self, krate: &TokenStream) -> Result<TokenStream, Report> {
        emit(&self.declaration, &mut self.model, &self.equations, krate, &mut self.report).ok_or(self.report)
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
        let items = elaborate(&declaration, &mut report).and_then(|mut model| {
            emit::report_hopeless_model(&declaration, &model, &mut report)?;
            let equations = derive(&declaration, &mut model, RoadChoice::Cheapest, &mut report)?;
            emit(&declaration, &mut model, &equations, krate, &mut report)
        });
        let items = items.unwrap_or_else(|| emit::skeleton(&declaration, krate));
        (items, declaration.attributes)
    });
    let (items, attributes) = items.unwrap_or_default();
    let diagnostics = emit::diagnostics(report.diagnostics(), &attributes);
    quote!(#diagnostics #items)
}

fn derive(
    declaration: &Declaration,
    model: &mut Model,
    road: RoadChoice,
    report: &mut Report,
) -> Option<Equations> {
    let is_singular = |error: &SingularMassMatrix| {
        report.error(declaration.name.span, error.to_string()).help(error.help());
    };
    Equations::derive(model, road).inspect_err(is_singular).ok()
}

fn emit(
    declaration: &Declaration,
    model: &mut Model,
    equations: &Equations,
    krate: &TokenStream,
    report: &mut Report,
) -> Option<TokenStream> {
    let emitted = emit::system(declaration, model, equations, krate);
    let refused = |refusal: &Refusal| emit::report_refusal(declaration, refusal, report);
    let Emitted { items, size } = emitted.inspect_err(refused).ok()?;
    emit::report_cost(declaration, size, report);
    Some(items)
}

#[cfg(test)]
mod tests;
