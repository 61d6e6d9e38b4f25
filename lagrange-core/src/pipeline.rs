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
    check(declaration, report).map_err(|failure| failure.1)
}

impl System {
    /// Derives the equations of motion.
    ///
    /// # Errors
    /// If the mass matrix is singular whatever the parameters are.
    pub fn derive(self, road: RoadChoice) -> Result<Derived, Report> {
        derive(self, road).map_err(|failure| failure.1)
    }
}

impl Derived {
    /// The emitted items. `krate` is the path of the crate `lagrange` where they will stand.
    ///
    /// # Errors
    /// If a constant is too large for the scalar.
    pub fn emit(mut self, krate: &TokenStream) -> Result<TokenStream, Report> {
        emit::system(&self.declaration, &mut self.model, &self.equations, krate).map_err(|constants| {
            let message = format!("number too large for the scalar: {}", constants.join(", "));
            self.report.error(self.declaration.name.span, message);
            self.report
        })
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
    let declaration = parse_tokens(tokens, &mut report);
    let items = check(declaration, report).and_then(|system| derive(system, RoadChoice::Cheapest)).and_then(
        |derived| {
            let (declaration, warnings) = (derived.declaration.clone(), derived.report.clone());
            let items = derived.emit(krate).map_err(|report| Box::new((Some(declaration), report)))?;
            Ok((items, warnings))
        },
    );
    let (items, report) = match items {
        Ok(emitted) => emitted,
        Err(failure) => {
            let (declaration, report) = *failure;
            let skeleton = declaration.map(|declaration| emit::skeleton(&declaration, krate));
            (skeleton.unwrap_or_default(), report)
        }
    };
    let diagnostics = emit::diagnostics(report.diagnostics());
    quote::quote!(#diagnostics #items)
}

/// The declaration, as far as it could be read, with its mistakes.
type Failure = Box<(Option<Declaration>, Report)>;

fn check(declaration: Option<Declaration>, mut report: Report) -> Result<System, Failure> {
    let Some(declaration) = declaration else { return Err(Box::new((None, report))) };
    match elaborate(&declaration, &mut report) {
        Some(model) if !report.has_errors() => Ok(System { declaration, model, report }),
        _ => Err(Box::new((Some(declaration), report))),
    }
}

fn derive(system: System, road: RoadChoice) -> Result<Derived, Failure> {
    let System { declaration, mut model, mut report } = system;
    match Equations::derive(&mut model, road) {
        Ok(equations) => Ok(Derived { declaration, model, equations, report }),
        Err(singular) => {
            report.error(declaration.name.span, singular.to_string());
            Err(Box::new((Some(declaration), report)))
        }
    }
}
