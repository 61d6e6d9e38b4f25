//! Expressions with values instead of variables, elements instead of indices and terms instead of
//! sums.
//!
//! Remaining expressions wait on a stack, so that chains of any length are copied without
//! recursion. Expressions in which nothing changes are not copied.

use super::copier::{Change, Copier, Task};
use super::counting::Counting;
use super::messages;
use super::paths::{Path, Segment, Target};
use super::scopes::ScopeId;
use super::unrolling::{origin_of, values};
use crate::syntax::ast::{ArrayExpression, AstId, BinaryOperator, Expression, Fold, Name, Range};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::limits::MAX_WRITTEN_OUT;
use lagrange_expr::number::Number;

impl Copier<'_> {
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
                    function.indices.clear();
                    copies.push(self.expressions.add(Expression::Call(function, operands), origin));
                }
                Task::Fold(fold, count, origin) => {
                    let terms = copies.split_off(copies.len().saturating_sub(count));
                    copies.push(self.folded(fold, &terms, origin));
                }
                Task::Entry(indices, origin) => {
                    let whole = copies.pop();
                    copies.extend(whole.map(|whole| self.entry(whole, &indices, None, origin)));
                }
            }
        }
        copies.pop().unwrap_or(root)
    }

    /// Returns the copy of an expression, or schedules the tasks that are needed first.
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
            Expression::Array(ArrayExpression::Fold { fold, variable, range, term }) => {
                self.fold(fold, (&variable, &range, term), (scope, origin), tasks)
            }
            Expression::Entry { of, indices, .. } => {
                let indices = indices.into_iter().map(|index| (index, scope)).collect::<Vec<_>>();
                self.behind(of, &indices, (scope, origin), tasks)
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

    /// Returns the copy of a name or a member of a part, or schedules the tasks that are needed
    /// first.
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
            Ok(Target::Entry(of, inner, indices)) => self.behind(of, &indices, (inner, origin), tasks),
            Ok(Target::HiddenEntry(segment)) => {
                let parameter = self.expressions.add(Expression::Name(segment.text), origin);
                self.behind(parameter, &segment.indices, (scope, origin), tasks)
            }
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
        // An index of something without elements is reported.
        if let Expression::Array(ArrayExpression::Element(name)) = self.expressions.get(id).clone() {
            let message = messages::no_array(&name.text);
            return Some(self.invalid(id, message, &messages::no_array_help(&name.text)));
        }
        if let Expression::Component(of, name) = self.expressions.get(id).clone()
            && !name.indices.is_empty()
        {
            let origin = self.expressions.origin(id);
            let indices = name.indices.iter().map(|index| (*index, scope)).collect::<Vec<_>>();
            let whole = Expression::Component(of, Name { indices: Vec::new(), ..name });
            let whole = self.expressions.add(whole, origin);
            return self.behind(whole, &indices, (scope, origin), tasks);
        }
        let operands = self.expressions.get(id).operands();
        tasks.push(Task::Make(id));
        tasks.extend(operands.into_iter().rev().map(|operand| Task::Copy(operand, scope)));
        None
    }

    /// Returns the copy of a declared name.
    fn declared(&mut self, id: AstId, segment: &Segment, scope: ScopeId) -> AstId {
        let origin = self.expressions.origin(id);
        if segment.indices.is_empty() && self.elements.is_array(&segment.text) && self.complaints.is_partial()
        {
            // A list of values may have been intended as a vector.
            return self.expressions.add(Expression::Invalid, origin);
        }
        if let Some(whole) = self.part_of_whole(segment, (scope, origin)) {
            return whole.unwrap_or_else(|| self.expressions.add(Expression::Invalid, origin));
        }
        if !segment.indices.is_empty() {
            let element = self.element(segment, scope).map(Expression::Name);
            return self.expressions.add(element.unwrap_or(Expression::Invalid), origin);
        }
        let name = segment.text.as_str();
        let is_as_written = matches!(self.expressions.get(id), Expression::Name(same) if same == name);
        let objection = self.objection(name, is_as_written);
        match objection {
            Some((message, help)) => self.invalid(id, message, &help),
            None if is_as_written => id,
            None => self.expressions.add(Expression::Name(name.to_owned()), origin),
        }
    }

    fn fold(
        &mut self,
        fold: Fold,
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
        tasks.push(Task::Fold(fold, count as usize, origin));
        for value in values.rev() {
            let scope = self.scopes.within(scope, &variable.text, value);
            tasks.push(Task::Copy(term, scope));
        }
        None
    }

    /// Returns a + b + c, a * b * c, `min(a, b, c)` or `max(a, b, c)`, as it would be written.
    fn folded(&mut self, fold: Fold, terms: &[AstId], origin: Origin) -> AstId {
        let operator = match (fold, terms) {
            (_, &[single]) => return single,
            (Fold::Sum, []) => return self.expressions.add(Expression::Number(Number::ZERO), origin),
            (Fold::Product, []) => return self.expressions.add(Expression::Number(Number::ONE), origin),
            (Fold::Minimum | Fold::Maximum, []) => {
                let error = self.complaints.report.error(origin, messages::nothing_to_compare(fold.word()));
                error.help(messages::NOTHING_TO_COMPARE_HELP);
                return self.expressions.add(Expression::Invalid, origin);
            }
            (Fold::Minimum | Fold::Maximum, terms) => {
                let call = Expression::Call(Name::new(fold.word(), origin.start), terms.to_vec());
                return self.expressions.add(call, origin);
            }
            (Fold::Sum, _) => BinaryOperator::Add,
            (Fold::Product, _) => BinaryOperator::Multiply,
        };
        let both = |left, right| Expression::Binary(operator, origin.start, left, right);
        let [first, others @ ..] = terms else { return self.expressions.add(Expression::Invalid, origin) };
        others.iter().fold(*first, |all, term| self.expressions.add(both(all, *term), origin))
    }
}
