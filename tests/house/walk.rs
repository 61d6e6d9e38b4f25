//! The dependencies of a crate's code, found by a walk through all its modules.

use std::collections::BTreeSet;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Arm, Attribute, Block, ExprClosure, ExprMethodCall, ImplItemFn, ItemFn, ItemImpl, ItemUse};
use syn::{Local, Macro, PatIdent, Path, Signature};

use crate::imports::{Import, Mention};
use crate::methods::{MethodFile, Methods, self_type};
use crate::names::{Found, Item, Names, Target};
use crate::receivers::{self, Declared, Variables};
use crate::sources::Sources;
use crate::standard::is_standard;
use crate::tokens::{TokenPath, paths};
use crate::uses::{Use, uses};

/// Macros whose arguments are code for somewhere else.
const QUOTATIONS: [&str; 2] = ["quote", "quote_spanned"];

/// Knowledge about a crate before its code is read.
pub(crate) struct Known<'a> {
    pub(crate) sources: &'a Sources,
    pub(crate) names: &'a Names,
    pub(crate) methods: Methods,
    pub(crate) declared: Declared<'a>,
}

/// Dependencies of the code of a crate.
#[derive(Default)]
pub(crate) struct Needs {
    pub(crate) imports: Vec<Import>,
    pub(crate) mentions: Vec<Mention>,
    /// Number of calls that might refer to methods in several files.
    pub(crate) ambiguous_calls: usize,
}

/// Walks through all modules.
pub(crate) fn needs(known: &Known) -> Needs {
    let mut walk = Walk::new(known);
    (0..known.sources.modules.len()).for_each(|module| walk.module(module));
    walk.calls();
    walk.needs
}

/// Visitor of all code of a crate, module by module.
struct Walk<'a> {
    known: &'a Known<'a>,
    module: usize,
    self_type: Option<usize>,
    variables: Variables,
    /// Types that each file names, including its own.
    named: BTreeSet<(usize, usize)>,
    calls: Vec<Call>,
    needs: Needs,
}

/// A call of a method on something whose type the syntax does not show.
struct Call {
    from: usize,
    method: String,
    line: usize,
}

impl<'a> Walk<'a> {
    fn new(known: &'a Known) -> Self {
        let named = known.names.items.iter().enumerate().map(|(index, item)| (item.file, index)).collect();
        let (module, self_type, variables, calls, needs) = Default::default();
        Self { known, module, self_type, variables, named, calls, needs }
    }

    fn module(&mut self, module: usize) {
        self.module = module;
        for item in &self.known.sources.modules[module].items {
            self.visit_item(item);
        }
    }
}

impl<'ast> Visit<'ast> for Walk<'_> {
    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        for found in uses(item) {
            if !self.passes_on(&found) {
                self.path(&found.path, found.line);
            }
        }
    }

    fn visit_item_impl(&mut self, block: &'ast ItemImpl) {
        let outer = std::mem::replace(&mut self.self_type, self_type(block, self.module, self.known.names));
        visit::visit_item_impl(self, block);
        self.self_type = outer;
    }

    fn visit_path(&mut self, path: &'ast Path) {
        let names = receivers::path(path);
        if path.leading_colon.is_none() && !names.is_empty() {
            self.path(&names, path.span().start().line);
        }
        visit::visit_path(self, path);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        let receiver = self.known.declared.receiver(&call.receiver, self.position());
        self.call(&call.method.to_string(), receiver, call.method.span().start().line);
        visit::visit_expr_method_call(self, call);
    }

    fn visit_macro(&mut self, call: &'ast Macro) {
        self.visit_path(&call.path);
        if QUOTATIONS.iter().any(|quotation| call.path.is_ident(quotation)) {
            return;
        }
        for TokenPath { names, line, receiver } in paths(&call.tokens) {
            match receiver {
                Some(receiver) => {
                    let receiver = self.known.declared.variable(&receiver, self.position());
                    self.call(&names[0], receiver, line);
                }
                None => self.path(&names, line),
            }
        }
    }

    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_item_fn(&mut self, function: &'ast ItemFn) {
        self.scope(|walk| visit::visit_item_fn(walk, function));
    }

    fn visit_impl_item_fn(&mut self, function: &'ast ImplItemFn) {
        self.scope(|walk| visit::visit_impl_item_fn(walk, function));
    }

    fn visit_expr_closure(&mut self, closure: &'ast ExprClosure) {
        self.scope(|walk| visit::visit_expr_closure(walk, closure));
    }

    fn visit_block(&mut self, block: &'ast Block) {
        self.scope(|walk| visit::visit_block(walk, block));
    }

    fn visit_arm(&mut self, arm: &'ast Arm) {
        self.scope(|walk| visit::visit_arm(walk, arm));
    }

    fn visit_signature(&mut self, signature: &'ast Signature) {
        visit::visit_signature(self, signature);
        self.variables.extend(self.known.declared.parameters(signature, self.module, self.self_type));
    }

    fn visit_local(&mut self, local: &'ast Local) {
        let value = local.init.as_ref().map(|value| value.expr.as_ref());
        let variables = self.known.declared.variables(&local.pat, value, self.position());
        visit::visit_local(self, local);
        self.variables.extend(variables);
    }

    /// Hides earlier variables of the same name.
    fn visit_pat_ident(&mut self, variable: &'ast PatIdent) {
        self.variables.push((variable.ident.to_string(), None));
        visit::visit_pat_ident(self, variable);
    }
}

impl Walk<'_> {
    fn file(&self) -> usize {
        self.known.sources.modules[self.module].file
    }

    fn path(&mut self, path: &[String], line: usize) {
        self.mention(path, line);
        if path[0] == "Self" {
            return self.associated(self.self_type, path.get(1), line);
        }
        for found in self.known.names.resolve(self.module, path) {
            self.import(&found, line);
        }
    }

    /// Records a top-level module that the path names explicitly.
    fn mention(&mut self, path: &[String], line: usize) {
        let is_relative = ["crate", "self", "super"].contains(&path[0].as_str());
        let names = path.iter().take_while(|_| is_relative);
        let ends = (1..=names.count()).map(|end| self.known.names.resolve(self.module, &path[..end]));
        let is_top = |target: &Target| match target {
            Target::Module(module) => self.known.sources.modules[*module].parent == Some(0),
            Target::Item(_) => false,
        };
        let top = ends.flatten().map(|(target, _)| target).find(is_top);
        if let Some(Target::Module(module)) = top {
            let module = self.known.sources.modules[module].name.clone();
            self.needs.mentions.push(Mention { from: self.file(), module, line });
        }
    }

    fn import(&mut self, (target, member): &Found, line: usize) {
        let Target::Item(index) = *target else { return };
        let Item { name, file, .. } = &self.known.names.items[index];
        self.named.insert((self.file(), index));
        self.import_from(*file, name, line);
        self.associated(Some(index), member.as_ref(), line);
    }

    /// Imports a function of a type, which may be in another file than the type.
    fn associated(&mut self, item: Option<usize>, member: Option<&String>, line: usize) {
        let (Some(item), Some(member)) = (item, member) else { return };
        if let MethodFile::One(file) = self.known.methods.file(member, |candidate| candidate == item) {
            let name = format!("{}::{member}", self.known.names.items[item].name);
            self.import_from(file, &name, line);
        }
    }

    fn import_from(&mut self, to: usize, item: &str, line: usize) {
        let from = self.file();
        if to != from {
            self.needs.imports.push(Import { from, to, line, item: item.to_owned() });
        }
    }

    fn call(&mut self, method: &str, receiver: Option<usize>, line: usize) {
        match receiver {
            Some(item) => self.associated(Some(item), Some(&method.to_owned()), line),
            None if is_standard(method) => {}
            None => self.calls.push(Call { from: self.file(), method: method.to_owned(), line }),
        }
    }

    fn position(&self) -> receivers::Position<'_> {
        receivers::Position { module: self.module, self_type: self.self_type, variables: &self.variables }
    }

    /// Forgets the variables of a scope at its end.
    fn scope(&mut self, visit: impl FnOnce(&mut Self)) {
        let before = self.variables.len();
        visit(self);
        self.variables.truncate(before);
    }

    /// Imports methods with a single definition of their name, if the file names their type. Counts
    /// calls that may be of methods in several files.
    fn calls(&mut self) {
        for Call { from, method, line } in std::mem::take(&mut self.calls) {
            let is_named = |item| self.named.contains(&(from, item));
            match (self.known.methods.file(&method, |_| true), self.known.methods.file(&method, is_named)) {
                (MethodFile::One(to), MethodFile::One(_)) if to != from => {
                    self.needs.imports.push(Import { from, to, line, item: format!(".{method}()") });
                }
                (MethodFile::Ambiguous, _) => self.needs.ambiguous_calls += 1,
                _ => {}
            }
        }
    }

    /// True if a `use` item only re-exports items of the module's own folder, which it may do
    /// without depending on it.
    fn passes_on(&self, found: &Use) -> bool {
        let own = self.known.sources.path(self.module);
        let is_within = |(target, _): &Found| {
            let module = match target {
                Target::Module(module) => *module,
                Target::Item(item) => self.known.names.items[*item].module,
            };
            self.known.sources.path(module).starts_with(&own)
        };
        found.is_reexport && self.known.names.resolve(self.module, &found.path).iter().all(is_within)
    }
}
