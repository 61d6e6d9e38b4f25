//! The whole of it on one screen: text or tokens → declaration → model → equations → items.

mod numeric;

use proc_macro2::TokenStream;

use crate::diagnostics::Report;
use crate::emit;
use crate::mechanics::{Equations, Model, RoadChoice, elaborate};
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
    let declaration = parse_text(text, &mut report);
    check(declaration, report).map_err(|(_, report)| report)
}

impl System {
    /// Derives the equations of motion.
    ///
    /// # Errors
    /// If the mass matrix is singular whatever the parameters are.
    pub fn derive(self, road: RoadChoice) -> Result<Derived, Report> {
        derive(self, road).map_err(|(_, report)| report)
    }
}

impl Derived {
    /// The emitted items. `krate` is the path of the crate `lagrange` where they will stand.
    ///
    /// # Errors
    /// If a constant is too large for the scalar.
    pub fn emit(mut self, krate: &TokenStream) -> Result<TokenStream, Report> {
        emit::system(&self.declaration, &mut self.model, &self.equations, krate).map_err(|constants| {
            emit::report_too_large(&self.declaration, &constants, &mut self.report);
            self.report
        })
    }
}

/// The macro: everything emitted for a declaration, mistakes included.
pub fn expand(tokens: TokenStream, krate: &TokenStream) -> TokenStream {
    let mut report = Report::default();
    let declaration = parse_tokens(tokens, &mut report);
    let items = check(declaration, report).and_then(|system| derive(system, RoadChoice::Cheapest)).and_then(
        |derived| {
            let (declaration, warnings) = (Box::new(derived.declaration.clone()), derived.report.clone());
            match derived.emit(krate) {
                Ok(items) => Ok((items, declaration, warnings)),
                Err(report) => Err((Some(declaration), report)),
            }
        },
    );
    let (items, attributes, report) = match items {
        Ok((items, declaration, report)) => (items, declaration.attributes, report),
        Err((None, report)) => (TokenStream::new(), TokenStream::new(), report),
        Err((Some(declaration), report)) => {
            (emit::skeleton(&declaration, krate), declaration.attributes, report)
        }
    };
    let diagnostics = emit::diagnostics(report.diagnostics(), &attributes);
    quote::quote!(#diagnostics #items)
}

type Failure = (Option<Box<Declaration>>, Report);

fn check(declaration: Option<Declaration>, mut report: Report) -> Result<System, Failure> {
    let Some(declaration) = declaration else { return Err((None, report)) };
    match elaborate(&declaration, &mut report) {
        Some(model) if !report.has_errors() => Ok(System { declaration, model, report }),
        _ => Err((Some(Box::new(declaration)), report)),
    }
}

fn derive(system: System, road: RoadChoice) -> Result<Derived, Failure> {
    let System { declaration, mut model, mut report } = system;
    match Equations::derive(&mut model, road) {
        Ok(equations) => Ok(Derived { declaration, model, equations, report }),
        Err(singular) => {
            report.error(declaration.name.span, singular.to_string()).help(singular.help());
            Err((Some(Box::new(declaration)), report))
        }
    }
}
