//! Expressions with values instead of variables, elements instead of indices and terms instead of
//! sums.
//!
//! Remaining expressions wait on a stack, so that chains of any length are copied without
//! recursion. Expressions in which nothing changes are not copied.

use super::complaints::Complaints;
use super::counting::Counting;
use super::elements::{ElementNames, indices_of};
use super::messages;
use super::scopes::{ScopeId, Scopes};
use super::unrolling::{origin_of, values};
use crate::syntax::ast::{
    ArrayExpression, AstId, BinaryOperator, Condition, Expression, Expressions, Name, Range,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::Relation;
use lagrange_expr::limits::MAX_WRITTEN_OUT;
use lagrange_expr::number::Number;

/// Writes expressions and names out.
pub(super) struct Copier<'a> {
    pub(super) expressions: &'a mut Expressions,
    pub(super) scopes: Scopes,
    pub(super) elements: &'a ElementNames,
    pub(super) complaints: Complaints<'a>,
    constants: &'a HashMap<String, Number>,
    /// For each expression in the text, true if anything in it can change.
    changes: HashMap<AstId, bool>,
    /// Terms so far.
    terms: u64,
    is_too_long: bool,
}

/// Something that is still to be done.
enum Task {
    /// Copy an expression.
    Copy(AstId, ScopeId),
    /// Make an expression like this one of the copies of its operands.
    Make(AstId),
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
            let is_changing = match expression {
                // A variable, a parameter of a function or an array.
                Expression::Name(name) => !complaints.names.contains(name) || elements.is_array(name),
                Expression::Array(_) => true,
                other => other.operands().iter().any(|operand| changes.get(operand) == Some(&true)),
            };
            changes.insert(id, is_changing);
        }
        Copier { expressions, scopes, elements, complaints, constants, changes, terms: 0, is_too_long: false }
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
        if self.changes.get(&id) == Some(&false) {
            return Some(id);
        }
        match self.expressions.get(id).clone() {
            Expression::Name(name) => Some(self.name(id, &name, scope)),
            Expression::Array(ArrayExpression::Element(name)) => {
                let element = self.element(&name, scope).map(Expression::Name);
                Some(self.expressions.add(element.unwrap_or(Expression::Invalid), origin))
            }
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
            Expression::If { condition, then, otherwise } if self.is_of_indices(&condition, scope) => {
                let branch = if self.holds(&condition, scope) { then } else { otherwise };
                tasks.push(Task::Copy(branch, scope));
                None
            }
            other => {
                tasks.push(Task::Make(id));
                tasks.extend(other.operands().into_iter().rev().map(|operand| Task::Copy(operand, scope)));
                None
            }
        }
    }

    fn name(&mut self, id: AstId, name: &str, scope: ScopeId) -> AstId {
        let origin = self.expressions.origin(id);
        match self.scopes.find(scope, name) {
            Some(Some(value)) => self.expressions.add(Expression::Number(Number::from(value)), origin),
            None => match self.objection(name) {
                Some((message, help)) => {
                    // A list of values may have been meant as a vector.
                    if !(self.elements.is_array(name) && self.complaints.is_partial())
                        && let Some(error) = self.complaints.once(id, origin, message)
                    {
                        error.help(help);
                    }
                    self.expressions.add(Expression::Invalid, origin)
                }
                None => id,
            },
            Some(None) => id,
        }
    }

    /// Returns the name of an element. An element that does not exist is reported.
    pub(super) fn element(&mut self, name: &Name, scope: ScopeId) -> Option<String> {
        let counting =
            Counting { expressions: self.expressions, scopes: &self.scopes, constants: self.constants };
        let (first, last) = (name.indices.first()?, name.indices.last()?);
        let origin = self.expressions.origin(*first).to(self.expressions.origin(*last));
        let is_hidden = self.scopes.find(scope, &name.text).is_some();
        if is_hidden || !self.elements.is_indexed(&name.text) {
            if !is_hidden && !self.complaints.names.contains(&name.text) {
                self.complaints.unknown_array(&name.text, *first, name.span.into());
            } else if let Some(error) = self.complaints.once(*first, origin, messages::no_array(&name.text)) {
                error.help(messages::no_array_help(&name.text));
            }
            return None;
        }
        let indices = indices_of(name, scope, counting, &mut self.complaints)?;
        if let Some(text) = self.elements.text(&name.text, &indices) {
            return Some(text.to_owned());
        }
        let (message, help) = self.elements.objection(&name.text, &indices)?;
        let message = format!("{message}{}", self.scopes.place(scope));
        if let Some(error) = self.complaints.once(*first, origin, message) {
            error.help(help);
        }
        None
    }

    /// The numbers of elements behind the name of an array that is declared as a whole.
    pub(super) fn sizes(&mut self, name: &Name, scope: ScopeId) -> Option<Vec<i64>> {
        if !self.elements.is_indexed(&name.text) {
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

    /// True if a condition is made of numbers that are known here, of variables among them, and not
    /// of the motion.
    fn is_of_indices(&self, condition: &Condition, scope: ScopeId) -> bool {
        let sides = [condition.left, condition.right];
        let is_variable = |id: &AstId| match self.expressions.get(*id) {
            Expression::Name(name) => matches!(self.scopes.find(scope, name), Some(Some(_))),
            _ => false,
        };
        let parts = |side: &AstId| self.expressions.parts(*side);
        sides.iter().any(|side| parts(side).iter().any(is_variable))
            && sides.iter().all(|side| self.counting().number(*side, scope).is_ok())
    }

    fn holds(&self, condition: &Condition, scope: ScopeId) -> bool {
        let number = |side| self.counting().number(side, scope).ok();
        let order = number(condition.left).cmp(&number(condition.right));
        match condition.relation {
            Relation::Less => order.is_lt(),
            Relation::LessEqual => order.is_le(),
            Relation::Greater => order.is_gt(),
            Relation::GreaterEqual => order.is_ge(),
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
