//! A derived system as items: every wanted product lowered and written as a method.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::base::docs;
use super::base::method::{ArgumentNames, Arguments, Method, Returns};
use super::base::shape::{Shape, doc, identifier};
use super::base::size::Size;
use super::features::contacts::default_modes;
use super::features::jacobian::parameter_names;
use super::features::product::{Plan, plan};
use super::features::scene::statements_constant;
use super::features::sparse::Sparse;
use super::features::switches::free_switches;
use super::item::{Parts, argument_names, items};
use crate::code::{Names, Scalar, body};
use crate::derive::Equations;
use crate::expr::ExprId;
use crate::model::{Model, Product};
use crate::program::{Labels, Op, OperationCounts, Program, lower, optimise};
use crate::syntax::ast::Declaration;

/// The items of a derived system.
#[derive(Clone, Debug)]
pub struct Emitted {
    /// The items.
    pub items: TokenStream,
    /// How large the methods are.
    pub size: Size,
}

/// Why a system cannot be written.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Refusal {
    /// These constants, in words, cannot be represented by the scalar.
    Constants(Vec<String>),
    /// No compiler would get through it.
    Size,
}

/// Writes a derived system, if that can be done.
///
/// `statements` are the plain statements, if others stand for rigid bodies; `krate` is the path of the crate `lagrange` where the
/// items will stand.
pub fn system(
    declaration: &Declaration,
    model: &mut Model,
    equations: &Equations,
    statements: Option<&str>,
    krate: &TokenStream,
) -> Result<Emitted, Refusal> {
    let shape = Shape::new(declaration, krate).with_switches(&model.graph, equations);
    let mut writer = Writer::new(&shape, model, equations, statements);
    writer.write_methods();
    let size = writer.size;
    let parts = writer.finish()?;
    Ok(Emitted { items: items(&shape, &parts), size })
}

pub(super) struct Writer<'a> {
    pub(super) shape: &'a Shape<'a>,
    pub(super) model: &'a mut Model,
    pub(super) equations: &'a Equations,
    /// The plain statements, if others stand for rigid bodies.
    statements: Option<&'a str>,
    pub(super) labels: Labels,
    scalar: Scalar,
    pub(super) names: ArgumentNames,
    pub(super) methods: Vec<Method>,
    /// Methods of `ConstrainedSystem`.
    pub(super) constrained: Vec<Method>,
    /// Methods of `CanonicalSystem` that only constrained systems have of their own.
    pub(super) canonical: Vec<Method>,
    /// The body of `ContactSystem::terms`.
    pub(super) terms: TokenStream,
    /// The body of `SwitchedSystem::switch_times`, if there is a time to tell.
    pub(super) switch_times: Option<TokenStream>,
    /// Of each reaction, whether it has a coefficient of restitution that depends on time or the state.
    pub(super) restitutions_vary: Vec<bool>,
    /// Methods that only others call.
    pub(super) hidden: TokenStream,
    /// Methods that say how bodies move.
    pub(super) motions: TokenStream,
    /// The body of `Scene::items`.
    pub(super) items: Option<TokenStream>,
    /// Operations of `acceleration`.
    counts: OperationCounts,
    /// All methods so far.
    size: Size,
    /// Functions that the bodies call.
    functions: BTreeSet<&'static str>,
    /// Whether a body holds the rounded value of an irrational constant.
    has_rounded_constants: bool,
    /// Constants that are too large, in words.
    unrepresentable: BTreeSet<String>,
}

impl<'a> Writer<'a> {
    fn new(
        shape: &'a Shape<'a>,
        model: &'a mut Model,
        equations: &'a Equations,
        statements: Option<&'a str>,
    ) -> Writer<'a> {
        let mut labels = Labels::default();
        for (expression, name) in &equations.labels {
            labels.insert(*expression, name.as_str());
        }
        let mut arguments = Names::new(user_names(shape).iter().map(String::as_str));
        Writer {
            shape,
            model,
            equations,
            statements,
            labels,
            scalar: shape.computed_with(),
            names: argument_names(|wish| arguments.fresh(wish)),
            methods: Vec::new(),
            constrained: Vec::new(),
            canonical: Vec::new(),
            terms: TokenStream::new(),
            switch_times: None,
            restitutions_vary: Vec::new(),
            hidden: TokenStream::new(),
            motions: TokenStream::new(),
            items: None,
            counts: OperationCounts::default(),
            size: Size::default(),
            functions: BTreeSet::new(),
            has_rounded_constants: false,
            unrepresentable: BTreeSet::new(),
        }
    }

    fn finish(mut self) -> Result<Parts, Refusal> {
        if self.size.is_hopeless() {
            return Err(Refusal::Size);
        }
        let default = self.default_body();
        let constants = self.constants();
        let mut docs = docs::system_docs(self.model, self.equations, self.counts);
        docs.extend(self.statements.into_iter().flat_map(docs::statements));
        if !self.unrepresentable.is_empty() {
            return Err(Refusal::Constants(self.unrepresentable.into_iter().collect()));
        }
        let is_separable = self.equations.is_separable(self.model);
        let are_holonomic = self.model.constraints.iter().map(|constraint| constraint.is_holonomic).collect();
        let Writer {
            methods,
            constrained,
            canonical,
            terms,
            switch_times,
            restitutions_vary,
            hidden,
            motions,
            items,
            names,
            functions,
            has_rounded_constants,
            ..
        } = self;
        Ok(Parts {
            docs,
            default,
            methods,
            constrained,
            canonical,
            are_holonomic,
            terms,
            switch_times,
            restitutions_vary,
            hidden,
            motions,
            items,
            constants,
            names,
            functions,
            is_separable,
            has_rounded_constants,
        })
    }

    fn write_methods(&mut self) {
        let n = Returns::Vector(self.model.coordinates.len());
        let accelerations = self.equations.accelerations.clone();
        let docs = ["Accelerations in the order of the coordinates."];
        self.counts = match (self.model.constraints.is_empty(), self.model.reactions.is_empty()) {
            (true, true) => match self.equations.pivot_growth {
                Some(growth) => self.write_indefinite(&docs, growth),
                None => self.add("acceleration", &docs, Arguments::State, n, &accelerations),
            },
            (false, true) => self.write_constrained(&docs),
            (_, false) => self.write_touching(&docs),
        };
        self.write_events();
        self.write_switches();
        for product in self.model.products.clone() {
            let fields = self.shape.fields.len();
            if let Some(Plan { docs, arguments, returns, roots }) =
                plan(product, self.model, self.equations, fields)
            {
                self.add(product.name(), docs, arguments, returns, &roots);
            }
        }
        for output in self.model.outputs.clone() {
            let returns = match output.components.len() {
                1 => Returns::Scalar,
                count => Returns::Vector(count),
            };
            let docs = [format!("Output `{}`.", output.name)];
            let docs = docs.each_ref().map(String::as_str);
            self.add(&output.name, &docs, Arguments::State, returns, &output.components);
        }
        self.write_scene();
    }

    /// Lowers and writes one method, unless those before it are too large already.
    fn add(
        &mut self,
        name: &str,
        docs: &[&str],
        arguments: Arguments,
        returns: Returns,
        roots: &[ExprId],
    ) -> OperationCounts {
        let (body, counts) = match Sparse::of(&self.model.graph, returns, roots) {
            Some(sparse) => self.lowered_sparse(&sparse, arguments),
            None => self.lowered(roots, arguments, |results| returns.collect(results)),
        };
        let output = self.shape.outputs.iter().find(|(output, _)| output.text == name);
        let (name, docs) = match output {
            Some((output, _)) => (identifier(output), self.shape.docs(output, &docs.concat())),
            None => (format_ident!("{name}"), docs.iter().map(|line| doc(line)).collect()),
        };
        let docs = docs::with_counts(docs, counts);
        self.methods.push(Method { name, docs, arguments, returns, body });
        counts
    }

    /// A body that computes `roots` on the sides of the switches that the system is on, and makes its result of them, unless those
    /// before it are too large already.
    pub(super) fn lowered(
        &mut self,
        roots: &[ExprId],
        arguments: Arguments,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        let roots = self.on_sides(roots);
        self.lowered_as_declared(&roots, arguments, collect)
    }

    /// The same with conditions, kinks and jumps as they are declared.
    pub(super) fn lowered_as_declared(
        &mut self,
        roots: &[ExprId],
        arguments: Arguments,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        if self.size.is_hopeless() {
            return (TokenStream::new(), OperationCounts::default());
        }
        let program = optimise(&lower(&self.model.graph, roots, &self.labels), self.model.accuracy);
        let counts = OperationCounts::of(&program);
        self.size.add(counts, roots.len());
        (self.body(&program, arguments, collect), counts)
    }

    fn body(
        &mut self,
        program: &Program,
        arguments: Arguments,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let symbols = self.model.graph.symbols();
        let reserved = arguments.vectors(&self.names).into_iter().chain([&self.names.visit]);
        let reserved = reserved.map(ToString::to_string).collect::<Vec<_>>();
        let mut names = Names::new(reserved.iter().map(String::as_str));
        self.has_rounded_constants |= program.values().any(|(_, op)| matches!(op, Op::Float(_)));
        match body(program, symbols, &self.scalar, &mut names) {
            Ok(body) => {
                self.functions.extend(&body.functions);
                let bindings = self.bindings(&body.used, &mut names, arguments);
                let (statements, result) = (&body.statements, collect(&body.outputs));
                quote!(#bindings #statements #result)
            }
            Err(error) => {
                self.unrepresentable.extend(error.constants);
                TokenStream::new()
            }
        }
    }

    /// A value of the struct with its defaults, if every field has one.
    fn default_body(&mut self) -> Option<TokenStream> {
        let fields = self.model.parameters.iter().chain(&self.model.inputs);
        let defaults = fields.map(|field| field.default).collect::<Option<Vec<_>>>()?;
        let program = lower(&self.model.graph, &defaults, &Labels::default());
        let program = optimise(&program, self.model.accuracy);
        self.has_rounded_constants |= program.values().any(|(_, op)| matches!(op, Op::Float(_)));
        let symbols = self.model.graph.symbols();
        match body(&program, symbols, &self.scalar, &mut Names::default()) {
            Ok(body) => {
                self.functions.extend(&body.functions);
                let (names, statements) = (self.shape.fields.iter().map(|n| identifier(n)), body.statements);
                let (modes, switches) = (default_modes(self.shape), free_switches(self.shape));
                let (values, marker) = (body.outputs, self.shape.needs_marker());
                let marker = marker.then(|| quote!(scalar: ::core::marker::PhantomData));
                Some(quote!(#statements Self { #(#names: #values,)* #modes #switches #marker }))
            }
            Err(error) => {
                self.unrepresentable.extend(error.constants);
                None
            }
        }
    }

    fn constants(&mut self) -> TokenStream {
        let wants = |product: Product| self.model.products.contains(&product);
        let (latex, parameters) = (wants(Product::Latex), wants(Product::ParameterJacobian));
        let statements = self.statements.filter(|_| wants(Product::Statements)).map(statements_constant);
        let latex = latex.then(|| equations_latex(&docs::equations_latex(self.model, self.equations)));
        let parameters = parameters.then(|| parameter_names(self.shape));
        quote!(#latex #parameters #statements)
    }
}

/// The constant that holds the equations.
pub(super) fn equations_latex(equations: &str) -> TokenStream {
    quote! {
        /// The equations of motion in LaTeX, one line for each coordinate after the definitions of
        /// abbreviations, if they need any.
        pub const EQUATIONS_LATEX: &'static ::core::primitive::str = #equations;
    }
}

/// Names of the user that stand in the methods' bodies beside the arguments.
pub(super) fn user_names(shape: &Shape<'_>) -> Vec<String> {
    let coordinates = shape.coordinates.iter();
    let rates = coordinates.clone().map(|name| format!("{}_dot", name.text));
    shape.fields.iter().chain(coordinates).map(|name| name.text.clone()).chain(rates).collect()
}
