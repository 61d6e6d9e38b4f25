//! Inlining of user-defined functions at their calls.
//!
//! After `let f(x, y) = e;`, every `f(a, b)` is replaced by e with the arguments for x and y. This
//! precedes all other analysis. Arguments may therefore be numbers, vectors, points or bodies, and
//! later phases are unaware of such functions. Inside a function, its parameters shadow names of
//! the declaration.
//!
//! A function may only call previous functions, and never itself. A chain of n functions that each
//! call the previous one twice expands to 2ⁿ terms, which is limited.

mod delays;
mod messages;

#[cfg(test)]
mod tests;

pub use self::delays::name_delays;
use std::collections::BTreeSet;

use crate::syntax::ast::{
    AstId, Declaration, Expression, Expressions, FunctionDefinition, Name, StatementKind,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::{Origin, Report, nearest};
use lagrange_expr::limits::MAX_INLINED;

/// Inlines the functions that a declaration defines. Errors in their calls are reported here,
/// errors in their bodies later.
pub fn without_functions(mut declaration: Declaration, report: &mut Report) -> Declaration {
    let is_function = |kind: &StatementKind| matches!(kind, StatementKind::Function(_));
    if declaration.statements.iter().all(|statement| statement.kind.declared_function().is_none()) {
        return declaration;
    }
    report_repeated(&declaration, report);
    let expressions = std::mem::take(&mut declaration.expressions);
    let known = names_of(&declaration);
    let mut inliner = Inliner {
        expressions,
        report,
        defined: HashMap::default(),
        all: Vec::new(),
        known,
        added: 0,
        sizes: HashMap::default(),
        is_too_long: false,
    };
    inliner.all = functions(&declaration).map(|function| function.name.clone()).collect();
    for statement in &mut declaration.statements {
        if let StatementKind::Function(function) = &statement.kind {
            inliner.define(function);
            continue;
        }
        for id in statement.kind.expressions_mut() {
            *id = inliner.inlined(*id);
        }
    }
    inliner.report_unused();
    declaration.expressions = inliner.expressions;
    declaration.statements.retain(|statement| !is_function(&statement.kind));
    declaration
}

fn functions(declaration: &Declaration) -> impl Iterator<Item = &FunctionDefinition> {
    declaration.statements.iter().filter_map(|statement| match &statement.kind {
        StatementKind::Function(function) => Some(&**function),
        _ => None,
    })
}

/// Returns the names that expressions may refer to anywhere.
fn names_of(declaration: &Declaration) -> BTreeSet<String> {
    let names = declaration.statements.iter().flat_map(|statement| statement.kind.declared_names());
    names.map(|name| name.text.clone()).chain(["t", "pi", "ground"].map(str::to_owned)).collect()
}

/// Reports functions and parameters whose names are already in use.
fn report_repeated(declaration: &Declaration, report: &mut Report) {
    let mut first: HashMap<String, (Origin, bool)> = HashMap::default();
    for statement in &declaration.statements {
        let function = statement.kind.declared_function();
        let names = function.map_or_else(|| statement.kind.declared_names(), |name| vec![name]);
        for name in names {
            match first.get(&name.text) {
                // Two plain names are reported during name resolution.
                Some((before, is_function)) if *is_function || function.is_some() => {
                    report_twice(report, name, *before);
                }
                _ => drop(first.insert(name.text.clone(), (name.span.into(), function.is_some()))),
            }
        }
        let mut own: HashMap<String, Origin> = HashMap::default();
        let parameters = match &statement.kind {
            StatementKind::Function(function) => &function.parameters[..],
            _ => &[],
        };
        for name in parameters {
            if let Some(before) = own.insert(name.text.clone(), name.span.into()) {
                report_twice(report, name, before);
            }
        }
    }
}

fn report_twice(report: &mut Report, name: &Name, before: Origin) {
    let error = report.error(name.span, messages::declared_twice(&name.text));
    error.related(before, messages::FIRST_DECLARED).help(messages::OTHER_NAME_HELP);
}

/// A function with inlined calls.
struct Defined {
    function: FunctionDefinition,
    /// Positions of parameters in its text; names in functions that it calls are separate.
    places: HashMap<AstId, usize>,
    /// Parts of its value, operands first.
    parts: Vec<AstId>,
    is_called: bool,
}

struct Inliner<'a> {
    expressions: Expressions,
    report: &'a mut Report,
    /// Functions so far.
    defined: HashMap<String, Defined>,
    /// The names of all functions.
    all: Vec<Name>,
    /// Names of everything else.
    known: BTreeSet<String>,
    /// Number of terms added, and number of expressions written out.
    added: u64,
    sizes: HashMap<AstId, u64>,
    is_too_long: bool,
}

impl Inliner<'_> {
    fn define(&mut self, function: &FunctionDefinition) {
        let mut function = function.clone();
        let mut places = HashMap::default();
        let mut is_used = vec![false; function.parameters.len()];
        for id in self.expressions.parts(function.value) {
            let Expression::Name(name) = self.expressions.get(id) else { continue };
            if let Some(place) = function.parameters.iter().position(|parameter| parameter.text == *name) {
                places.insert(id, place);
                is_used[place] = true;
            }
        }
        let unused = function
            .parameters
            .iter()
            .zip(is_used)
            .filter(|(name, is_used)| !is_used && !name.text.starts_with('_'));
        for (name, _) in unused {
            let warning = self.report.unused(&name.text, name.span, messages::unused_parameter(&name.text));
            warning.help(messages::UNUSED_PARAMETER_HELP);
        }
        function.value = self.inlined(function.value);
        let parts = self.expressions.parts(function.value);
        let name = function.name.text.clone();
        self.defined.insert(name, Defined { function, places, parts, is_called: false });
    }

    /// Replaces calls of functions in an expression by their values.
    fn inlined(&mut self, root: AstId) -> AstId {
        let mut replaced: HashMap<AstId, AstId> = HashMap::default();
        for id in self.expressions.parts(root) {
            let rebuilt = self.rebuilt(id, &replaced);
            let new = match self.expressions.get(rebuilt) {
                Expression::Call(function, arguments) => {
                    let (function, arguments) = (function.clone(), arguments.clone());
                    self.called(&function, &arguments, rebuilt)
                }
                _ => rebuilt,
            };
            if new != id {
                replaced.insert(id, new);
            }
        }
        replaced.get(&root).copied().unwrap_or(root)
    }

    /// Returns an expression with its operands replaced.
    fn rebuilt(&mut self, id: AstId, replaced: &HashMap<AstId, AstId>) -> AstId {
        let expression = self.expressions.get(id);
        let operands = expression.operands();
        if !operands.iter().any(|operand| replaced.contains(operand)) {
            return id;
        }
        let operands: Vec<AstId> =
            operands.iter().map(|operand| replaced.get(operand).copied().unwrap_or(*operand)).collect();
        let (expression, origin) = (expression.clone().with_operands(&operands), self.expressions.origin(id));
        self.added += 1;
        self.expressions.add(expression, origin)
    }

    /// Returns the inlined body of a call; calls to other functions are returned unchanged.
    fn called(&mut self, name: &Name, arguments: &[AstId], call: AstId) -> AstId {
        let origin = self.expressions.origin(call);
        let Some(defined) = self.defined.get_mut(&name.text) else {
            return if self.report_too_early(name) {
                self.expressions.add(Expression::Invalid, origin)
            } else {
                call
            };
        };
        defined.is_called = true;
        let (function, places, parts) =
            (defined.function.clone(), defined.places.clone(), defined.parts.clone());
        if function.parameters.len() != arguments.len() {
            let message = messages::wrong_count(&name.text, function.parameters.len(), arguments.len());
            let error = self.report.error(origin, message);
            error.related(function.name.span.into(), messages::DEFINED_HERE).help(messages::usage(&function));
            return self.expressions.add(Expression::Invalid, origin);
        }
        let value = self.instance(&function, (&places, &parts), arguments, origin);
        if self.added > MAX_INLINED || self.size(value) > MAX_INLINED {
            self.report_too_long(&function.name, origin);
            return self.expressions.add(Expression::Invalid, origin);
        }
        value
    }

    /// Returns the value of a function for arguments. Errors about the whole value are located at
    /// the call.
    fn instance(
        &mut self,
        function: &FunctionDefinition,
        (places, parts): (&HashMap<AstId, usize>, &[AstId]),
        arguments: &[AstId],
        call: Origin,
    ) -> AstId {
        let mut replaced: HashMap<AstId, AstId> = HashMap::default();
        for &id in parts {
            if let Some(&place) = places.get(&id) {
                replaced.insert(id, arguments[place]);
                continue;
            }
            let rebuilt = self.rebuilt(id, &replaced);
            if rebuilt != id {
                replaced.insert(id, rebuilt);
            }
        }
        let Some(&value) = replaced.get(&function.value) else { return function.value };
        if arguments.contains(&value) {
            return value;
        }
        let expression = self.expressions.get(value).clone();
        self.expressions.add(expression, call)
    }

    /// Returns the number of terms of the expanded expression.
    fn size(&mut self, root: AstId) -> u64 {
        for id in self.expressions.parts(root) {
            if !self.sizes.contains(&id) {
                let operands = self.expressions.get(id).operands();
                let sizes = operands.iter().map(|operand| self.sizes.get(operand).copied().unwrap_or(1));
                let size = sizes.fold(1, u64::saturating_add);
                self.sizes.insert(id, size);
            }
        }
        self.sizes.get(&root).copied().unwrap_or(1)
    }

    fn report_too_early(&mut self, name: &Name) -> bool {
        let Some(function) = self.all.iter().find(|function| function.text == name.text) else {
            return false;
        };
        let error = self.report.error(name.span, messages::called_too_early(&name.text));
        error.related(function.span.into(), messages::DEFINED_HERE).help(messages::ORDER_HELP);
        true
    }

    /// Reports an expression that is too long, but only once.
    fn report_too_long(&mut self, name: &Name, origin: Origin) {
        if !std::mem::replace(&mut self.is_too_long, true) {
            let error = self.report.error(origin, messages::too_long(&name.text, MAX_INLINED));
            error.help(messages::TOO_LONG_HELP);
        }
    }

    /// Reports functions that are never called, and undefined names in them.
    fn report_unused(&mut self) {
        for name in std::mem::take(&mut self.all) {
            let Some(Defined { function, parts, is_called: false, .. }) = self.defined.get(&name.text) else {
                continue;
            };
            let is_known = |name: &String| {
                self.known.contains(name)
                    || function.parameters.iter().any(|parameter| parameter.text == *name)
            };
            let mut unknown = None;
            for &id in parts {
                if let Expression::Name(name) = self.expressions.get(id)
                    && !is_known(name)
                {
                    unknown = unknown.or(Some((id, name.clone())));
                }
            }
            match unknown {
                Some((id, unknown)) => {
                    let names = self.known.iter().map(String::as_str);
                    let parameters = function.parameters.iter().map(|parameter| parameter.text.as_str());
                    let help = nearest(&unknown, parameters.chain(names)).map(messages::did_you_mean);
                    let error =
                        self.report.error(self.expressions.origin(id), messages::unknown_name(&unknown));
                    error.help(help.unwrap_or_else(|| messages::DECLARE_HELP.to_owned()));
                }
                None if name.text.starts_with('_') => {}
                None => {
                    let warning =
                        self.report.unused(&name.text, name.span, messages::never_called(&name.text));
                    warning.help(messages::NEVER_CALLED_HELP);
                }
            }
        }
    }
}
