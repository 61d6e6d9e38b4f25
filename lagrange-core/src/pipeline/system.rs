//! Systems from text, phase by phase: for tests, tools and build scripts.

use proc_macro2::TokenStream;

use super::phases::{DerivedPart, equations_of, items_of, model_of};
use crate::derive::{Equations, StrategyChoice};
use crate::emit;
use crate::model::{Model, Product};
use lagrange_algebra::code::Precision;
use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::Declaration;
use lagrange_language::syntax::{parse_included, parse_text};
use lagrange_language::tables::{Reader, no_files, read_files};

/// A declaration with its checked model.
#[derive(Clone, Debug)]
pub struct System {
    /// Declaration in plain statements.
    pub declaration: Declaration,
    /// Checked model of the declaration.
    pub model: Model,
    /// Warnings.
    pub report: Report,
}

/// A system with its equations of motion.
#[derive(Clone, Debug)]
pub struct Derived {
    /// Declaration in plain statements.
    pub declaration: Declaration,
    /// Checked model of the declaration.
    pub model: Model,
    /// Equations of motion.
    pub equations: Equations,
    /// The reduced types.
    pub reduced: Vec<DerivedPart>,
    /// Warnings.
    pub report: Report,
}

/// Reads and checks a system from text: a whole declaration, or only its statements.
///
/// # Errors
/// With all errors in the declaration.
pub fn parse(text: &str) -> Result<System, Report> {
    parse_with(text, &no_files)
}

/// Parses a declaration whose tables may be files.
///
/// # Errors
/// With all errors in the declaration or its files.
pub fn parse_with(text: &str, read: Reader<'_>) -> Result<System, Report> {
    parse_adding((text, ""), read)
}

/// Parses a declaration, with further statements such as `emit { jacobian }`. They are added to the
/// one in a file if the text names that.
///
/// # Errors
/// With all errors in the declaration or its files.
pub fn parse_adding((text, statements): (&str, &str), read: Reader<'_>) -> Result<System, Report> {
    let mut report = Report::default();
    let Some(mut declaration) = parse_text(text, &mut report) else { return Err(report) };
    read_files(&mut declaration, read, &mut report);
    if !statements.is_empty() {
        let here = declaration.name.clone();
        let (added, _) = parse_included((&here, statements), &mut declaration, &mut report);
        declaration.statements.extend(added);
    }
    match model_of(declaration, &mut report) {
        (declaration, Some(model)) => Ok(System { declaration, model, report }),
        (_, None) => Err(report),
    }
}

impl System {
    /// Writes the statements, one per line, with rigid bodies translated to plain statements.
    pub fn statements(&self) -> String {
        emit::statements(&self.declaration)
    }

    /// Returns the hash of the declaration that emitted types contain as `FINGERPRINT`. Layout,
    /// comments and pictures do not change it.
    pub fn fingerprint(&self) -> u64 {
        emit::fingerprint(&self.declaration)
    }

    /// Adds a product to those that the declaration emits. Derivatives are not added to systems
    /// with contacts or friction, which have none.
    pub fn with(mut self, product: Product) -> System {
        let Model { products, reactions, .. } = &mut self.model;
        let is_undefined = product.is_derivative() && !reactions.is_empty();
        if !is_undefined && !products.contains(&product) {
            products.push(product);
            products.sort_unstable();
        }
        self
    }

    /// Derives the equations of motion.
    ///
    /// # Errors
    /// If the mass matrix is singular for all parameters, or the result would exceed the limits.
    pub fn derive(self, choice: StrategyChoice) -> Result<Derived, Report> {
        let System { declaration, mut model, mut report } = self;
        match equations_of(&declaration, &mut model, choice, &mut report) {
            Some((equations, reduced)) => Ok(Derived { declaration, model, equations, reduced, report }),
            None => Err(report),
        }
    }
}

impl Derived {
    /// Writes the emitted items. `krate` is the path of the crate `lagrange` in the code that will
    /// contain them.
    ///
    /// # Errors
    /// If a constant is too large for the scalar.
    pub fn emit(self, krate: &TokenStream) -> Result<TokenStream, Report> {
        let Derived { declaration, mut model, equations, reduced, mut report } = self;
        items_of((&declaration, &mut model, &equations), reduced, krate, &mut report).ok_or(report)
    }

    /// Writes the equations of motion as C, as in `emit { kernel }`.
    ///
    /// # Errors
    /// If kernels do not support the system, or a constant is too large for the precision.
    pub fn kernel(&self, precision: Precision) -> Result<String, Report> {
        let mut report = Report::default();
        let text = emit::kernel((&self.declaration, &self.model, &self.equations), precision, &mut report);
        text.ok_or(report)
    }

    /// Writes the equations, the structure and the cost of the system in lines of Markdown, as in
    /// the documentation of the emitted struct.
    pub fn documentation(&mut self) -> Vec<String> {
        emit::documentation(&mut self.model, &self.equations)
    }

    /// Returns M q̈ = f in LaTeX, one line for each coordinate, preceded by definitions of
    /// abbreviations that keep the lines short. The result is empty if M is large and was not
    /// requested.
    pub fn equations_latex(&mut self) -> String {
        emit::equations_latex(&mut self.model, &self.equations)
    }
}
