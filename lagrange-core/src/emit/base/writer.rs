//! Methods of a derived system: expressions lowered to programs, and programs written as bodies.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::bindings::{Bindings, EmittedType};
use super::lints::looks_rounded;
use super::members::{Members, PreparedFields};
use super::method::{ArgumentNames, Arguments, Method, Returns};
use super::refusal::Refusal;
use super::shape::{Shape, doc};
use super::sides::{NamedRoots, on_sides};
use super::size::Size;
use crate::derive::Equations;
use crate::model::Model;
use lagrange_algebra::code::{FunctionBody, Names, Scalar, body};
use lagrange_algebra::program::{Labels, Op, OperationCounts, Preparation, Program, lower, optimise};
use lagrange_expr::expr::ExprId;

/// Names of variables that features declare after the values of a method.
const LOCALS: [&str; 4] = ["terms", "inertia", "forced", "step"];

/// Writes the methods of one system. Features add to its members.
pub(in crate::emit) struct MethodWriter<'a> {
    pub(in crate::emit) shape: &'a Shape<'a>,
    pub(in crate::emit) model: &'a mut Model,
    pub(in crate::emit) equations: &'a Equations,
    pub(in crate::emit) members: Members,
    labels: Labels,
    /// Size of all methods so far.
    size: Size,
    /// Constants that are too large, as text.
    unrepresentable: BTreeSet<String>,
}

impl<'a> MethodWriter<'a> {
    pub(in crate::emit) fn new(
        shape: &'a Shape<'a>,
        model: &'a mut Model,
        equations: &'a Equations,
    ) -> MethodWriter<'a> {
        let mut labels = Labels::default();
        for (expression, name) in &equations.labels {
            labels.insert(*expression, name.as_str());
        }
        let members = Members::new(ArgumentNames::beside(&shape.user_names()));
        let (size, unrepresentable) = (Size::default(), BTreeSet::new());
        MethodWriter { shape, model, equations, members, labels, size, unrepresentable }
    }

    /// Returns the members with their size, if the compiler can process them and the scalar can
    /// represent their constants.
    pub(in crate::emit) fn finish(self) -> Result<(Members, Size), Refusal> {
        if self.size.is_hopeless() {
            return Err(Refusal::Size);
        }
        if !self.unrepresentable.is_empty() {
            return Err(Refusal::Constants(self.unrepresentable.into_iter().collect()));
        }
        Ok((self.members, self.size))
    }

    /// True if the methods so far are too large for the compiler.
    pub(in crate::emit) fn is_hopeless(&self) -> bool {
        self.size.is_hopeless()
    }

    /// Adds a method of the state that returns a vector.
    pub(in crate::emit) fn push_method(
        &mut self,
        name: &str,
        docs: &[&str],
        count: usize,
        body: TokenStream,
        counts: OperationCounts,
    ) {
        let lines = docs.iter().map(|line| doc(line)).collect::<TokenStream>();
        let returns = Returns::Vector(count);
        let docs = self.shape.method_docs((name, returns), &lines, counts);
        let name = format_ident!("{name}");
        self.members.methods.push(Method { name, docs, arguments: Arguments::State, returns, body });
    }

    /// Adds a method of `ConstrainedSystem`.
    pub(in crate::emit) fn push_constrained(
        &mut self,
        name: &str,
        arguments: Arguments,
        returns: Returns,
        body: TokenStream,
    ) {
        let name = format_ident!("{name}");
        self.members.constrained.push(Method { name, docs: TokenStream::new(), arguments, returns, body });
    }

    /// Adds a method of the state that only other methods call.
    pub(in crate::emit) fn push_hidden(&mut self, name: &str, returns: Returns, body: TokenStream) {
        let (name, docs) = (format_ident!("{name}"), TokenStream::new());
        let method = Method { name, docs, arguments: Arguments::State, returns, body };
        self.members.hidden.extend(method.of_trait(self.shape, &self.members.names));
    }

    /// Returns a body that computes `roots` on the current sides of the switches, and forms its
    /// result from them. `None` if the methods before it are already too large.
    pub(in crate::emit) fn lowered(
        &mut self,
        roots: &[ExprId],
        arguments: Arguments,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        let roots = self.on_sides(roots);
        self.lowered_for(EmittedType::System, &roots, arguments, collect)
    }

    /// Returns expressions on the current sides of the switches.
    pub(in crate::emit) fn on_sides(&mut self, roots: &[ExprId]) -> NamedRoots {
        let switches = &self.equations.switches[..self.shape.switches.len()];
        on_sides(&mut self.model.graph, &self.labels, switches, roots)
    }

    /// Returns expressions with conditions, kinks and jumps as declared.
    pub(in crate::emit) fn as_declared(&self, roots: &[ExprId]) -> NamedRoots {
        NamedRoots { roots: roots.to_vec(), labels: self.labels.clone() }
    }

    /// Lowers expressions with conditions, kinks and jumps as declared.
    pub(in crate::emit) fn lowered_as_declared(
        &mut self,
        roots: &[ExprId],
        arguments: Arguments,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        self.lowered_for(EmittedType::System, &self.as_declared(roots), arguments, collect)
    }

    /// Lowers to a body of the type for numbers in lanes.
    pub(in crate::emit) fn lowered_in_lanes(
        &mut self,
        roots: &NamedRoots,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        self.lowered_for(EmittedType::Lanes, roots, Arguments::Whole, collect)
    }

    fn lowered_for(
        &mut self,
        emitted_type: EmittedType<'_>,
        NamedRoots { roots, labels }: &NamedRoots,
        arguments: Arguments,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        if self.size.is_hopeless() {
            return (TokenStream::new(), OperationCounts::default());
        }
        let program = optimise(&lower(&self.model.graph, roots, labels), self.model.accuracy);
        let counts = OperationCounts::of(&program);
        self.size.add(counts, roots.len());
        (self.body(&program, arguments, emitted_type, collect), counts)
    }

    /// Lowers to a body of the prepared type, which obtains a field for each new value.
    pub(in crate::emit) fn lowered_prepared(
        &mut self,
        roots: &[ExprId],
        arguments: Arguments,
        (preparation, fields): (&mut Preparation, &mut PreparedFields),
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> (TokenStream, OperationCounts) {
        if self.size.is_hopeless() {
            return (TokenStream::new(), OperationCounts::default());
        }
        let program = preparation.prepare(&lower(&self.model.graph, roots, &self.labels));
        for index in fields.names.len()..preparation.len() {
            let name = fields.push(preparation.name(index));
            self.model.graph.symbol(&name, preparation.role(index));
        }
        let program = optimise(&program, self.model.accuracy);
        let counts = OperationCounts::of(&program);
        self.size.add(counts, roots.len());
        (self.body(&program, arguments, EmittedType::Prepared(&fields.names), collect), counts)
    }

    /// Returns the statements and values of the preparation.
    pub(in crate::emit) fn prepared_values(
        &mut self,
        preparation: Preparation,
    ) -> (TokenStream, Vec<TokenStream>, OperationCounts) {
        let program = optimise(&preparation.finish(), self.model.accuracy);
        let counts = OperationCounts::of(&program);
        self.size.add(counts, program.outputs().len());
        let mut values = Vec::new();
        let statements = self.body(&program, Arguments::None, EmittedType::System, |results| {
            values = results.to_vec();
            TokenStream::new()
        });
        (statements, values, counts)
    }

    fn body(
        &mut self,
        program: &Program,
        arguments: Arguments,
        emitted_type: EmittedType<'_>,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let argument_names = &self.members.names;
        let reserved = arguments
            .vectors(argument_names)
            .into_iter()
            .chain([&argument_names.visit, &argument_names.place]);
        let reserved = reserved.map(ToString::to_string).collect::<Vec<_>>();
        let mut names = Names::new(reserved.iter().map(String::as_str).chain(LOCALS));
        let scalar = match emitted_type {
            EmittedType::Lanes => self.shape.lanes_computed_with(),
            _ => self.shape.computed_with(),
        };
        let Some(body) = self.written(program, &scalar, &mut names) else { return TokenStream::new() };
        let bindings =
            Bindings { shape: self.shape, model: self.model, arguments: &self.members.names, emitted_type };
        let bindings = bindings.of(&body.used, &mut names, arguments);
        let (statements, result) = (&body.statements, collect(&body.outputs));
        quote!(#bindings #statements #result)
    }

    /// Writes a program as the body of a method of the state, of the system or of the type for
    /// numbers in lanes.
    pub(in crate::emit) fn lowered_program(
        &mut self,
        program: &Program,
        is_in_lanes: bool,
        collect: impl FnOnce(&[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        self.size.add(OperationCounts::of(program), program.outputs().len());
        let emitted_type = if is_in_lanes { EmittedType::Lanes } else { EmittedType::System };
        self.body(program, Arguments::Whole, emitted_type, collect)
    }

    /// Writes a program as a separate function.
    pub(in crate::emit) fn lowered_apart(
        &mut self,
        program: &Program,
        scalar: &Scalar,
        names: &mut Names,
    ) -> Option<FunctionBody> {
        self.size.add(OperationCounts::of(program), program.outputs().len());
        self.written(program, scalar, names)
    }

    /// Writes a program as statements and results; `None` if it contains constants that are too
    /// large, which are recorded.
    fn written(&mut self, program: &Program, scalar: &Scalar, names: &mut Names) -> Option<FunctionBody> {
        self.members.has_rounded_constants |= program.values().any(|(_, op)| looks_rounded(op));
        self.shape.callees.iter().for_each(|callee| names.place_callee(&callee.text, callee.span));
        self.note_callees(program);
        match body(program, self.model.graph.symbols(), scalar, names) {
            Ok(body) => {
                self.members.functions.extend(&body.functions);
                Some(body)
            }
            Err(error) => {
                self.unrepresentable.extend(error.constants);
                None
            }
        }
    }

    /// Records the functions without a formula that are called.
    fn note_callees(&mut self, program: &Program) {
        for (_, op) in program.values() {
            if let Op::Opaque(function, _) = op
                && !self.members.callees.contains(function)
            {
                // The coefficients of a table may contain any number.
                self.members.has_rounded_constants |= function.table().is_some();
                self.members.callees.push(function.clone());
            }
        }
    }

    /// Writes statements and values of constant expressions with separate names.
    pub(in crate::emit) fn constants(&mut self, values: &[ExprId]) -> Option<FunctionBody> {
        let program = optimise(&lower(&self.model.graph, values, &Labels::default()), self.model.accuracy);
        self.written(&program, &self.shape.computed_with(), &mut Names::default())
    }
}
