//! Types of the receivers of calls, as far as declarations show them: `self`, parameters and
//! variables, fields, and results of functions. The content of a reference, a box, an option or a
//! result counts as the type itself.

use std::collections::BTreeMap;

use syn::{Expr, Fields, FnArg, GenericArgument, ImplItem, ItemImpl, Pat, PathArguments, ReturnType};
use syn::{Signature, Type};

use crate::methods::self_type;
use crate::names::{Names, Target};
use crate::sources::{Module, Sources};

/// Wrapper types that are ignored.
const AROUND: [&str; 6] = ["Arc", "Box", "Cow", "Option", "Rc", "Result"];

/// The crate's own types of fields, functions and parameters.
pub(crate) struct Declared<'a> {
    names: &'a Names,
    fields: BTreeMap<(usize, String), usize>,
    methods: BTreeMap<(usize, String), usize>,
    functions: BTreeMap<usize, usize>,
}

/// Variables in scope with their types, where these are known, the innermost last.
pub(crate) type Variables = Vec<(String, Option<usize>)>;

/// Module, block and scope in which an expression stands.
#[derive(Clone, Copy)]
pub(crate) struct Position<'a> {
    pub(crate) module: usize,
    pub(crate) self_type: Option<usize>,
    pub(crate) variables: &'a Variables,
}

impl<'a> Declared<'a> {
    pub(crate) fn of(sources: &Sources, names: &'a Names) -> Self {
        let (fields, methods, functions) = Default::default();
        let mut declared = Self { names, fields, methods, functions };
        for (index, module) in sources.modules.iter().enumerate() {
            declared.module(index, module);
        }
        declared
    }

    /// Returns the type of a receiver.
    pub(crate) fn receiver(&self, expression: &Expr, position: Position) -> Option<usize> {
        match expression {
            Expr::Call(call) => match call.func.as_ref() {
                Expr::Path(function) => self.returned(&path(&function.path), position),
                _ => None,
            },
            Expr::Field(field) => {
                let base = self.receiver(&field.base, position)?;
                let name = match &field.member {
                    syn::Member::Named(name) => name.to_string(),
                    syn::Member::Unnamed(index) => index.index.to_string(),
                };
                self.fields.get(&(base, name)).copied()
            }
            Expr::MethodCall(call) => {
                let receiver = self.receiver(&call.receiver, position)?;
                self.methods.get(&(receiver, call.method.to_string())).copied()
            }
            Expr::Paren(inner) => self.receiver(&inner.expr, position),
            Expr::Path(variable) => self.variable(&variable.path.get_ident()?.to_string(), position),
            Expr::Reference(inner) => self.receiver(&inner.expr, position),
            Expr::Struct(literal) => self.named(&path(&literal.path), position.module, position.self_type),
            Expr::Try(inner) => self.receiver(&inner.expr, position),
            Expr::Unary(inner) => self.receiver(&inner.expr, position),
            _ => None,
        }
    }

    pub(crate) fn variable(&self, name: &str, position: Position) -> Option<usize> {
        if name == "self" {
            return position.self_type;
        }
        position.variables.iter().rev().find(|(variable, _)| variable == name)?.1
    }

    /// Returns the parameters of a function whose types are known.
    pub(crate) fn parameters(
        &self,
        signature: &Signature,
        module: usize,
        self_type: Option<usize>,
    ) -> Variables {
        let parameters = signature.inputs.iter().filter_map(|input| match input {
            FnArg::Typed(parameter) => Some((variable_of(&parameter.pat)?, &*parameter.ty)),
            FnArg::Receiver(_) => None,
        });
        parameters.map(|(name, of_type)| (name, self.written(of_type, module, self_type))).collect()
    }

    /// Returns the variables of known types that a `let` brings into scope.
    pub(crate) fn variables(&self, pattern: &Pat, value: Option<&Expr>, position: Position) -> Variables {
        match (pattern, value) {
            (Pat::Ident(variable), Some(value)) => {
                vec![(variable.ident.to_string(), self.receiver(value, position))]
            }
            (Pat::Type(typed), _) => {
                let of_type = self.written(&typed.ty, position.module, position.self_type);
                variable_of(&typed.pat).map(|name| (name, of_type)).into_iter().collect()
            }
            (Pat::Tuple(patterns), Some(Expr::Tuple(values))) => {
                let pairs = patterns.elems.iter().zip(&values.elems);
                pairs.flat_map(|(pattern, value)| self.variables(pattern, Some(value), position)).collect()
            }
            _ => Variables::new(),
        }
    }

    /// Returns the crate's own type in a type expression.
    fn written(&self, of_type: &Type, module: usize, self_type: Option<usize>) -> Option<usize> {
        match of_type {
            Type::Reference(inner) => self.written(&inner.elem, module, self_type),
            Type::Paren(inner) => self.written(&inner.elem, module, self_type),
            Type::Path(named) => {
                let last = named.path.segments.last()?;
                match &last.arguments {
                    PathArguments::AngleBracketed(around) if AROUND.iter().any(|name| last.ident == name) => {
                        around.args.iter().find_map(|argument| match argument {
                            GenericArgument::Type(inner) => self.written(inner, module, self_type),
                            _ => None,
                        })
                    }
                    _ => self.named(&path(&named.path), module, self_type),
                }
            }
            _ => None,
        }
    }

    fn named(&self, path: &[String], module: usize, self_type: Option<usize>) -> Option<usize> {
        if path == ["Self"] {
            return self_type;
        }
        self.names.resolve(module, path).into_iter().find_map(|(target, member)| match target {
            Target::Item(item) if self.names.items[item].is_type && member.is_none() => Some(item),
            _ => None,
        })
    }

    /// Returns the type that a function returns, or that a tuple constructor makes.
    fn returned(&self, path: &[String], position: Position) -> Option<usize> {
        if let ["Self", method] = path.iter().map(String::as_str).collect::<Vec<_>>()[..] {
            return self.methods.get(&(position.self_type?, method.to_owned())).copied();
        }
        let found = self.names.resolve(position.module, path);
        let mut types = found.into_iter().filter_map(|(target, member)| match (target, member) {
            (Target::Item(item), Some(method)) => self.methods.get(&(item, method)).copied(),
            (Target::Item(item), None) if self.names.items[item].is_type => Some(item),
            (Target::Item(item), None) => self.functions.get(&item).copied(),
            (Target::Module(_), _) => None,
        });
        types.next()
    }

    fn module(&mut self, index: usize, module: &Module) {
        for item in &module.items {
            match item {
                syn::Item::Struct(item) => {
                    let own = self.named(&[item.ident.to_string()], index, None);
                    own.into_iter().for_each(|own| self.fields(own, &item.fields, index));
                }
                syn::Item::Fn(item) => self.function(&item.sig, index),
                syn::Item::Impl(block) => self.block(block, index),
                _ => {}
            }
        }
    }

    fn fields(&mut self, own: usize, fields: &Fields, module: usize) {
        for (index, field) in fields.iter().enumerate() {
            let name = field.ident.as_ref().map_or_else(|| index.to_string(), ToString::to_string);
            if let Some(of_type) = self.written(&field.ty, module, Some(own)) {
                self.fields.insert((own, name), of_type);
            }
        }
    }

    fn function(&mut self, signature: &Signature, module: usize) {
        let name = [signature.ident.to_string()];
        let mut items =
            self.names.resolve(module, &name).into_iter().filter_map(|(target, _)| match target {
                Target::Item(item) if !self.names.items[item].is_type => Some(item),
                _ => None,
            });
        if let (Some(item), Some(returned)) = (items.next(), self.output(signature, module, None)) {
            self.functions.insert(item, returned);
        }
    }

    fn block(&mut self, block: &ItemImpl, module: usize) {
        let Some(own) = self_type(block, module, self.names) else { return };
        for item in &block.items {
            let ImplItem::Fn(method) = item else { continue };
            if let Some(returned) = self.output(&method.sig, module, Some(own)) {
                self.methods.insert((own, method.sig.ident.to_string()), returned);
            }
        }
    }

    fn output(&self, signature: &Signature, module: usize, self_type: Option<usize>) -> Option<usize> {
        match &signature.output {
            ReturnType::Type(_, of_type) => self.written(of_type, module, self_type),
            ReturnType::Default => None,
        }
    }
}

/// Returns the name of the variable in a pattern that consists of it.
fn variable_of(pattern: &Pat) -> Option<String> {
    match pattern {
        Pat::Ident(variable) => Some(variable.ident.to_string()),
        _ => None,
    }
}

pub(crate) fn path(path: &syn::Path) -> Vec<String> {
    path.segments.iter().map(|segment| segment.ident.to_string()).collect()
}
