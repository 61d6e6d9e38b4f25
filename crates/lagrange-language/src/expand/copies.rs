//! Expressions with values instead of variables, elements instead of indices and terms instead of
//! sums.
//!
//! Remaining expressions wait on a stack, so that chains of any length are copied without
//! recursion. Expressions in which nothing changes are not copied.

use super::complaints::Complaints;
use super::counting::Counting;
use super::elements::ElementNames;
use super::indices::{counted_indices, indices_of};
use super::messages;
use super::paths::{Path, Segment, Target};
use super::scopes::{BUILT_IN, Meaning, PlacedId, ScopeId, Scopes};
use super::unrolling::{origin_of, values};
use crate::syntax::ast::{
    ArrayExpression, AstId, BinaryOperator, Expression, Expressions, ExternalFunction, Name, Range,
};
use crate::syntax::is_function;
use lagrange_expr::collections::{HashMap, HashSet};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_WRITTEN_OUT;
use lagrange_expr::number::Number;

/// Writes expressions and names out.
pub(super) struct Copier<'a> {
    pub(super) expressions: &'a mut Expressions,
    pub(super) scopes: Scopes,
    pub(super) elements: &'a ElementNames,
    pub(super) complaints: Complaints<'a>,
    constants: &'a HashMap<String, Number>,
    /// For each expression in the text, if anything in it can change.
    changes: HashMap<AstId, Change>,
    /// Functions of the user's crate that parts declare.
    external: HashSet<String>,
    /// Terms so far.
    terms: u64,
    is_too_long: bool,
}

/// The places in which an expression can change.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Change {
    Nowhere,
    /// In parts, which do not know the names in it.
    InParts,
    Anywhere,
}

/// Something that is still to be done.
enum Task {
    /// Copy an expression.
    Copy(AstId, ScopeId),
    /// Make an expression like this one of the copies of its operands.
    Make(AstId),
    /// Make a call like this one, but of a function of this name.
    Call(AstId, String),
    /// Add up that many copies.
    Total(usize, Origin),
}

impl<'a> Copier<'a> {
    pub(super) fn new(
        expressions: &'a mut Expressions,
        scopes: Scopes,
        constants: &'a HashMap<String, Number>,
        elements: &'a ElementNames,
        complaints: Complaints<'a>,
    ) -> Copier<'a> {
        let mut changes = HashMap::default();
        for (id, expression) in expressions.iter() {
            let of_operands = || expression.operands().iter().filter_map(|id| changes.get(id)).max().copied();
            let change = match expression {
                Expression::Name(name) => {
                    // A variable, a parameter of a function, an array or something in a part.
                    let is_known = complaints.names.contains(name) && !elements.is_array(name);
                    match (is_known && !scopes.is_scoped(name), BUILT_IN.contains(&name.as_str())) {
                        (true, true) => Change::Nowhere,
                        (true, false) => Change::InParts,
                        (false, _) => Change::Anywhere,
                    }
                }
                Expression::Array(_) => Change::Anywhere,
                Expression::Component(_, name) if !name.indices.is_empty() => Change::Anywhere,
                Expression::Call(function, _) if scopes.is_scoped(&function.text) => Change::Anywhere,
                Expression::Call(..) => of_operands().max(Some(Change::InParts)).unwrap_or(Change::InParts),
                _ => of_operands().unwrap_or(Change::Nowhere),
            };
            changes.insert(id, change);
        }
        let external = HashSet::default();
        Copier {
            expressions,
            scopes,
            elements,
            complaints,
            constants,
            changes,
            external,
            terms: 0,
            is_too_long: false,
        }
    }

    pub(super) fn counting(&self) -> Counting<'_> {
        Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants }
    }

    /// Returns the copy of an expression in a scope.
    pub(super) fn copied(&mut self, root: AstId, scope: ScopeId) -> AstId {
        let mut tasks = vec![Task::Copy(root, scope)];
        let mut copies = Vec::new();
        while let Some(task) = tasks.pop() {
            match task {
                Task::Copy(id, scope) => copies.extend(self.begun(id, scope, &mut tasks)),
                Task::Make(id) => {
                    let (expression, origin) =
                        (self.expressions.get(id).clone(), self.expressions.origin(id));
                    let operands = copies.split_off(copies.len().saturating_sub(expression.operands().len()));
                    copies.push(self.expressions.add(expression.with_operands(&operands), origin));
                }
                Task::Call(id, name) => {
                    let (expression, origin) =
                        (self.expressions.get(id).clone(), self.expressions.origin(id));
                    let Expression::Call(mut function, arguments) = expression else { continue };
                    let operands = copies.split_off(copies.len().saturating_sub(arguments.len()));
                    function.text = name;
                    copies.push(self.expressions.add(Expression::Call(function, operands), origin));
                }
                Task::Total(count, origin) => {
                    let terms = copies.split_off(copies.len().saturating_sub(count));
                    copies.push(self.total(&terms, origin));
                }
            }
        }
        copies.pop().unwrap_or(root)
    }

    /// The copy of an expression, or nothing if that takes what is left to do.
    fn begun(&mut self, id: AstId, scope: ScopeId, tasks: &mut Vec<Task>) -> Option<AstId> {
        let origin = self.expressions.origin(id);
        self.terms += 1;
        if self.terms > MAX_WRITTEN_OUT {
            return Some(self.too_long(origin));
        }
        let limit = if self.scopes.part_of(scope).is_some() { Change::Nowhere } else { Change::InParts };
        if self.changes.get(&id).is_some_and(|change| *change <= limit) {
            return Some(id);
        }
        match self.expressions.get(id).clone() {
            Expression::Name(_)
            | Expression::Component(..)
            | Expression::Array(ArrayExpression::Element(_)) => self.path(id, scope, tasks),
            Expression::Array(ArrayExpression::Sum { variable, range, term }) => {
                self.sum((&variable, &range, term), (scope, origin), tasks)
            }
            // Only definitions of arrays have lists.
            Expression::Array(ArrayExpression::List(_)) => {
                Some(self.expressions.add(Expression::Invalid, origin))
            }
            Expression::Array(ArrayExpression::Select { condition, then, otherwise }) => {
                let branch = match self.counting().holds(&condition, scope) {
                    Ok(true) => then,
                    Ok(false) => otherwise,
                    Err(fault) => {
                        self.complaints.unequal(self.expressions, &fault, (&self.scopes, scope));
                        return Some(self.expressions.add(Expression::Invalid, origin));
                    }
                };
                tasks.push(Task::Copy(branch, scope));
                None
            }
            Expression::If { condition, then, otherwise } => {
                let Some(holds) = self.counting().decided(&condition, scope) else {
                    return self.operands(id, scope, tasks);
                };
                tasks.push(Task::Copy(if holds { then } else { otherwise }, scope));
                None
            }
            Expression::Call(function, arguments) => {
                let function = self.function(id, &function, scope);
                tasks.push(Task::Call(id, function));
                tasks.extend(arguments.into_iter().rev().map(|argument| Task::Copy(argument, scope)));
                None
            }
            _ => self.operands(id, scope, tasks),
        }
    }

    /// The copy of a name or a member of a part, or nothing if that takes what is left to do.
    fn path(&mut self, id: AstId, scope: ScopeId, tasks: &mut Vec<Task>) -> Option<AstId> {
        let origin = self.expressions.origin(id);
        let Some(path) = Path::of(self.expressions, id, scope) else {
            return self.operands(id, scope, tasks);
        };
        match path.target(self.counting()) {
            Ok(Target::Value(value)) => {
                Some(self.expressions.add(Expression::Number(Number::from(value)), origin))
            }
            Ok(Target::Hidden) => Some(id),
            Ok(Target::Expression(value, scope)) => {
                tasks.push(Task::Copy(value, scope));
                None
            }
            Ok(Target::Declared(segment)) => Some(self.declared(id, &segment, scope)),
            Ok(Target::Beyond) => self.operands(id, scope, tasks),
            Ok(Target::Part(part)) => {
                let (message, help) = self.part_as_value(part);
                Some(self.invalid(id, message, &help))
            }
            Err(fault) => {
                self.complaints.path(&fault, self.expressions, Some(id), (&self.scopes, scope));
                Some(self.expressions.add(Expression::Invalid, origin))
            }
        }
    }

    /// Copies the operands of an expression.
    fn operands(&mut self, id: AstId, scope: ScopeId, tasks: &mut Vec<Task>) -> Option<AstId> {
        // The index of something that has no elements, which is reported.
        if let Expression::Array(ArrayExpression::Element(name)) = self.expressions.get(id).clone() {
            let message = messages::no_array(&name.text);
            return Some(self.invalid(id, message, &messages::no_array_help(&name.text)));
        }
        if let Expression::Component(_, name) = self.expressions.get(id).clone()
            && let Some(first) = name.indices.first()
        {
            let origin = self.expressions.origin(*first);
            if let Some(error) = self.complaints.once(*first, origin, messages::no_array(&name.text)) {
                error.help(messages::no_array_help(&name.text));
            }
            return Some(self.expressions.add(Expression::Invalid, self.expressions.origin(id)));
        }
        let operands = self.expressions.get(id).operands();
        tasks.push(Task::Make(id));
        tasks.extend(operands.into_iter().rev().map(|operand| Task::Copy(operand, scope)));
        None
    }

    /// The copy of something declared.
    fn declared(&mut self, id: AstId, segment: &Segment, scope: ScopeId) -> AstId {
        let origin = self.expressions.origin(id);
        if !segment.indices.is_empty() {
            let element = self.element(segment, scope).map(Expression::Name);
            return self.expressions.add(element.unwrap_or(Expression::Invalid), origin);
        }
        let name = segment.text.as_str();
        match self.objection(name) {
            Some((message, help)) => {
                // A list of values may have been meant as a vector.
                if self.elements.is_array(name) && self.complaints.is_partial() {
                    return self.expressions.add(Expression::Invalid, origin);
                }
                self.invalid(id, message, &help)
            }
            None if matches!(self.expressions.get(id), Expression::Name(same) if same == name) => id,
            None => self.expressions.add(Expression::Name(name.to_owned()), origin),
        }
    }

    /// True of a function of the user's crate that no part declared before.
    pub(super) fn is_first_of(&mut self, function: &ExternalFunction) -> bool {
        let key = format!("{} {}", function.name.text, function.parameters.len());
        self.external.insert(key) || function.derivatives.is_some()
    }

    /// Reports an expression, which has no meaning.
    fn invalid(&mut self, id: AstId, message: String, help: &str) -> AstId {
        let origin = self.expressions.origin(id);
        if let Some(error) = self.complaints.once(id, origin, message) {
            error.help(help);
        }
        self.expressions.add(Expression::Invalid, origin)
    }

    /// The message for a part where a value is needed, and what to do.
    pub(super) fn part_as_value(&self, part: PlacedId) -> (String, String) {
        let part = self.scopes.placed(part);
        let name = part.written.trim_end_matches('.');
        let members = messages::members_are(&part.interior.name.text, part.interior.names());
        (messages::part_as_value(name), members)
    }

    /// Returns the name of an element. An element that does not exist is reported.
    pub(super) fn element(&mut self, array: &Segment, scope: ScopeId) -> Option<String> {
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        let ((first, _), (last, _)) = (array.indices.first()?, array.indices.last()?);
        let origin = self.expressions.origin(*first).to(self.expressions.origin(*last));
        if !self.elements.is_indexed(&array.text) {
            if !self.elements.is_declared(&array.text, self.complaints.names) {
                self.complaints.unknown_array(
                    &array.text,
                    (*first, array.span.into()),
                    (&self.scopes, scope),
                );
            } else if let Some(error) = self.complaints.once(*first, origin, messages::no_array(&array.text))
            {
                error.help(messages::no_array_help(&array.text));
            }
            return None;
        }
        let indices = counted_indices(&array.indices, counting, &mut self.complaints)?;
        if let Some(text) = self.elements.text(&array.text, &indices) {
            return Some(text.to_owned());
        }
        let (message, help) = self.elements.objection(&array.text, &indices)?;
        let message = format!("{message}{}", self.scopes.place_of(scope));
        if let Some(error) = self.complaints.once(*first, origin, message) {
            error.help(help);
        }
        None
    }

    /// The name of the function that a call in a scope means. One that is not known is reported.
    fn function(&mut self, call: AstId, function: &Name, scope: ScopeId) -> String {
        let (mut name, mut place) = (function.text.clone(), scope);
        loop {
            match self.scopes.member(self.scopes.part_of(place), &name) {
                Meaning::Declared(text) => return text,
                Meaning::Argument(value, outer) => match self.expressions.get(value) {
                    Expression::Name(other) => (name, place) = (other.clone(), outer),
                    _ => return name,
                },
                Meaning::Outside => {
                    let is_external =
                        self.scopes.around(place).is_some_and(|part| part.interior.external.contains(&name));
                    if is_external || is_function(&name) || !self.complaints.names.contains(&name) {
                        return name;
                    }
                    self.complaints.unknown(&name, (call, function.span.into()), (&self.scopes, place));
                    return name;
                }
                Meaning::Placed | Meaning::Value(_) | Meaning::Hidden => return name,
            }
        }
    }

    /// The numbers of elements behind the name of an array that is declared as a whole.
    pub(super) fn sizes(&mut self, name: &Name, scope: ScopeId) -> Option<Vec<i64>> {
        if !self.elements.is_indexed(&self.scopes.prefixed(scope, &name.text)) {
            return None;
        }
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        indices_of(name, scope, counting, &mut self.complaints)
    }

    /// Why a name without an index means nothing, and what to do.
    pub(super) fn objection(&self, name: &str) -> Option<(String, String)> {
        if self.elements.is_array(name) {
            return Some((messages::no_index(name), messages::written_help(self.elements.example(name))));
        }
        let written = self.elements.as_written(name).filter(|_| !self.complaints.names.contains(name))?;
        Some((messages::unknown_name(name), messages::write(written)))
    }

    fn sum(
        &mut self,
        (variable, range, term): (&Name, &Range, AstId),
        (scope, origin): (ScopeId, Origin),
        tasks: &mut Vec<Task>,
    ) -> Option<AstId> {
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        let Some(values) = values(variable, range, (counting, scope), &mut self.complaints) else {
            return Some(self.expressions.add(Expression::Invalid, origin));
        };
        let count = values.end.saturating_sub(values.start).max(0).unsigned_abs();
        if count > MAX_WRITTEN_OUT {
            let place = origin_of(self.expressions, range);
            return Some(self.too_long(place));
        }
        tasks.push(Task::Total(count as usize, origin));
        for value in values.rev() {
            let scope = self.scopes.within(scope, &variable.text, value);
            tasks.push(Task::Copy(term, scope));
        }
        None
    }

    /// a + b + c, as it would be written.
    fn total(&mut self, terms: &[AstId], origin: Origin) -> AstId {
        let add = |left, right| Expression::Binary(BinaryOperator::Add, origin.start, left, right);
        match terms {
            [] => self.expressions.add(Expression::Number(Number::ZERO), origin),
            [first, others @ ..] => {
                others.iter().fold(*first, |sum, term| self.expressions.add(add(sum, *term), origin))
            }
        }
    }

    /// Once is enough.
    fn too_long(&mut self, origin: Origin) -> AstId {
        if !std::mem::replace(&mut self.is_too_long, true) {
            let error = self.complaints.report.error(origin, messages::too_many_terms(MAX_WRITTEN_OUT));
            error.help(messages::TOO_LONG_HELP);
        }
        self.expressions.add(Expression::Invalid, origin)
    }
}
