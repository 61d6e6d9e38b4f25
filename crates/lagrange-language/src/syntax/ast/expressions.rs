//! Expressions, in an arena.

use std::collections::BTreeSet;

use proc_macro2::Span;

use super::Name;
use super::array_shapes::ArrayShape;
use super::conditions::{CombinedCondition, Comparison};
use super::id::AstId;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::number::Number;
use lagrange_expr::units::Unit;

/// A binary operator.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BinaryOperator {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`
    Power,
    /// `%`, only in indices
    Remainder,
}

/// One `if` condition `left relation right`.
#[derive(Clone, Copy, Debug)]
pub struct Condition {
    /// Left operand.
    pub left: AstId,
    /// Comparison sign.
    pub relation: Comparison,
    /// Right operand.
    pub right: AstId,
}

/// The function that represents `v in body`: components of a vector in the axes of a body. It is a
/// keyword, so no call has this name.
pub const IN_AXES: &str = "in";

/// The function of contact points of two blocks, which no identifier is called. In a contact it
/// takes a body and the number of a point. In plain statements it takes the place of a number, how
/// many there are, and the centre, axes, half sizes and radius of both blocks.
pub const CONTACT_POINT: &str = "contact point";

/// The function of the end of a cylinder, a circle, which no identifier is called. It takes a body
/// and the number of the end.
pub const END: &str = "end of a cylinder";

/// Numbers of a contact point: its places in both blocks, its normal, a tangent and a distance.
pub const CONTACT_POINT_LENGTH: usize = 13;

/// An expression.
#[derive(Clone, Debug)]
pub enum Expression {
    /// A literal with its exact value.
    Number(Number),
    /// A number with the unit after it, `30 deg` or `9.81 [m/s^2]`.
    Quantity(AstId, Box<Unit>),
    /// A name, not yet resolved.
    Name(String),
    /// `(a, b)`: a vector, or a matrix of vectors as rows.
    Tuple(Vec<AstId>),
    /// `-a`
    Negate(AstId),
    /// `a + b` and similar; the span is that of the operator.
    Binary(BinaryOperator, Span, AstId, AstId),
    /// `f(a, b)`, or `a.f(b)` with the receiver as first argument.
    Call(Name, Vec<AstId>),
    /// `a.x`, or `a.k[1]` of a part
    Component(AstId, Name),
    /// `v[0]` or `(A * B)[i][j]`: a component of a vector, a row or an entry of a matrix.
    Entry {
        /// The vector or matrix.
        of: AstId,
        /// Indices, which are numbers after the expansion of arrays.
        indices: Vec<AstId>,
        /// The shape that the value must have, if another item determines it.
        shape: Option<ArrayShape>,
    },
    /// `if c { a } else { b }`; longer chains nest in `otherwise`.
    If {
        /// The condition.
        condition: Condition,
        /// Value if the condition holds.
        then: AstId,
        /// Value otherwise.
        otherwise: AstId,
    },
    /// An expression with arrays.
    Array(ArrayExpression),
    /// Placeholder for an item whose error was reported.
    Invalid,
}

impl Expression {
    /// Returns its operands, in source order.
    pub fn operands(&self) -> Vec<AstId> {
        match self {
            Expression::Number(_) | Expression::Name(_) | Expression::Invalid => Vec::new(),
            Expression::Tuple(parts) | Expression::Call(_, parts) => parts.clone(),
            Expression::Array(array) => array.operands(),
            Expression::Negate(of) | Expression::Quantity(of, _) => vec![*of],
            Expression::Component(of, name) => {
                [*of].into_iter().chain(name.indices.iter().copied()).collect()
            }
            Expression::Entry { of, indices, .. } => {
                [*of].into_iter().chain(indices.iter().copied()).collect()
            }
            Expression::Binary(_, _, a, b) => vec![*a, *b],
            Expression::If { condition, then, otherwise } => {
                vec![condition.left, condition.right, *then, *otherwise]
            }
        }
    }

    /// Returns the expression with other operands, in the order of
    /// [`operands`](Expression::operands).
    pub fn with_operands(self, parts: &[AstId]) -> Expression {
        match self {
            Expression::Tuple(_) => Expression::Tuple(parts.to_vec()),
            Expression::Call(function, _) => Expression::Call(function, parts.to_vec()),
            Expression::Array(array) => Expression::Array(array.with_operands(parts)),
            Expression::Negate(_) => Expression::Negate(parts[0]),
            Expression::Quantity(_, unit) => Expression::Quantity(parts[0], unit),
            Expression::Component(_, name) => {
                Expression::Component(parts[0], Name { indices: parts[1..].to_vec(), ..name })
            }
            Expression::Entry { shape, .. } => {
                Expression::Entry { of: parts[0], indices: parts[1..].to_vec(), shape }
            }
            Expression::Binary(operator, span, ..) => Expression::Binary(operator, span, parts[0], parts[1]),
            Expression::If { mut condition, .. } => {
                (condition.left, condition.right) = (parts[0], parts[1]);
                Expression::If { condition, then: parts[2], otherwise: parts[3] }
            }
            leaf => leaf,
        }
    }
}

/// The array syntax of expressions, which is expanded before expressions have a meaning.
#[derive(Clone, Debug)]
pub enum ArrayExpression {
    /// `p[i + 1]`
    Element(Name),
    /// `sum(i in 0..n, e)`, `product(…)`, `min(…)` or `max(…)`
    Fold {
        /// Function of all terms.
        fold: Fold,
        /// Variable of the range.
        variable: Name,
        /// Values of the variable.
        range: Range,
        /// Term for each value.
        term: AstId,
    },
    /// `if i == 0 { a } else { b }`, decided by indices.
    Select {
        /// Deciding condition.
        condition: CombinedCondition,
        /// Value if the condition holds.
        then: AstId,
        /// Value otherwise.
        otherwise: AstId,
    },
    /// `[a, b]`, defaults of the elements of an array; for a grid, the elements are lists.
    List(Vec<AstId>),
}

impl ArrayExpression {
    /// Returns its operands, in source order.
    fn operands(&self) -> Vec<AstId> {
        match self {
            ArrayExpression::Element(name) => name.indices.clone(),
            ArrayExpression::Fold { range, term, .. } => vec![range.from, range.to, *term],
            ArrayExpression::List(elements) => elements.clone(),
            ArrayExpression::Select { condition, then, otherwise } => {
                condition.expressions().into_iter().chain([*then, *otherwise]).collect()
            }
        }
    }

    /// Replaces the operands.
    fn with_operands(mut self, parts: &[AstId]) -> ArrayExpression {
        match &mut self {
            ArrayExpression::Element(name) => name.indices = parts.to_vec(),
            ArrayExpression::List(elements) => *elements = parts.to_vec(),
            ArrayExpression::Select { condition, then, otherwise } => {
                let places = condition.expressions_mut().into_iter().chain([then, otherwise]);
                places.zip(parts).for_each(|(place, part)| *place = *part);
            }
            ArrayExpression::Fold { range, term, .. } => {
                (range.from, range.to, *term) = (parts[0], parts[1], parts[2]);
            }
        }
        self
    }
}

/// A function of the terms of a range.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Fold {
    /// Sum of the terms.
    Sum,
    /// Product of the terms.
    Product,
    /// Minimum of the terms.
    Minimum,
    /// Maximum of the terms.
    Maximum,
}

impl Fold {
    /// All functions.
    pub const ALL: [Fold; 4] = [Fold::Sum, Fold::Product, Fold::Minimum, Fold::Maximum];

    /// Returns the word for the function.
    pub fn word(self) -> &'static str {
        match self {
            Fold::Sum => "sum",
            Fold::Product => "product",
            Fold::Minimum => "min",
            Fold::Maximum => "max",
        }
    }
}

/// `a..b` or `a..=b`
#[derive(Clone, Copy, Debug)]
pub struct Range {
    /// The first value.
    pub from: AstId,
    /// The end.
    pub to: AstId,
    /// True if the end is included.
    pub is_inclusive: bool,
}

/// The arena of expressions of one declaration.
#[derive(Clone, Default, Debug)]
pub struct Expressions {
    nodes: Vec<(Expression, Origin)>,
    written: usize,
    computed: std::ops::Range<usize>,
}

impl Expressions {
    /// Adds an expression; its children must have been added before.
    pub fn add(&mut self, expression: Expression, origin: Origin) -> AstId {
        self.nodes.push((expression, origin));
        AstId((self.nodes.len() - 1) as u32)
    }

    /// Returns the number of expressions so far.
    pub fn count(&self) -> usize {
        self.nodes.len()
    }

    /// Replaces names, including those of the variables of sums, in the expressions from an index
    /// on.
    pub fn respell(&mut self, first: usize, spelling: impl Fn(&str) -> Option<String>) {
        for (expression, _) in self.nodes.iter_mut().skip(first) {
            let name = match expression {
                Expression::Name(name) => name,
                Expression::Array(ArrayExpression::Fold { variable, .. }) => &mut variable.text,
                _ => continue,
            };
            if let Some(other) = spelling(name) {
                *name = other;
            }
        }
    }

    /// Marks all expressions so far as written by the user.
    pub fn end_of_text(&mut self) {
        self.written = self.nodes.len();
    }

    /// True if the user wrote an expression in this form.
    pub fn is_written(&self, id: AstId) -> bool {
        (id.0 as usize) < self.written
    }

    /// Adds expressions that repeat others with numbers computed from theirs, and that therefore
    /// have no units.
    pub fn computed<T>(
        of: &mut T,
        expressions: impl Fn(&mut T) -> &mut Expressions,
        add: impl FnOnce(&mut T),
    ) {
        let first = expressions(of).nodes.len();
        add(of);
        let expressions = expressions(of);
        expressions.computed = first..expressions.nodes.len();
    }

    /// True for expressions added by `computed`.
    pub fn is_computed(&self, id: AstId) -> bool {
        self.computed.contains(&(id.0 as usize))
    }

    /// Returns the expression with an id.
    pub fn get(&self, id: AstId) -> &Expression {
        &self.nodes[id.0 as usize].0
    }

    /// Returns the place of an expression.
    pub fn origin(&self, id: AstId) -> Origin {
        self.nodes[id.0 as usize].1
    }

    /// Returns an expression and all its parts, each once, operands before the expressions that
    /// contain them.
    pub fn parts(&self, root: AstId) -> Vec<AstId> {
        let mut pending = vec![root];
        let mut found = BTreeSet::new();
        while let Some(id) = pending.pop() {
            if found.insert(id) {
                pending.extend(self.get(id).operands());
            }
        }
        // Operands have smaller indices than the expressions that contain them.
        found.into_iter().collect()
    }

    /// True if a condition holds for all names in an expression.
    pub fn all_names(&self, root: AstId, holds: impl Fn(&str) -> bool) -> bool {
        let is_other = |id| matches!(self.get(id), Expression::Name(name) if !holds(name));
        !self.parts(root).into_iter().any(is_other)
    }

    /// Returns the values of expanded indices.
    pub fn places(&self, indices: &[AstId]) -> Option<Vec<usize>> {
        let place = |index: &AstId| match self.get(*index) {
            Expression::Number(number) => usize::try_from(number.to_integer()?).ok(),
            _ => None,
        };
        indices.iter().map(place).collect()
    }

    /// Returns `x` for an expression `dot(x)`.
    pub fn rate_of_name(&self, id: AstId) -> Option<&str> {
        let Expression::Call(function, arguments) = self.get(id) else { return None };
        match (function.text.as_str(), arguments.as_slice()) {
            ("dot", [argument]) => match self.get(*argument) {
                Expression::Name(name) => Some(name),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns every expression with its id, children before parents.
    pub fn iter(&self) -> impl Iterator<Item = (AstId, &Expression)> {
        self.nodes.iter().enumerate().map(|(index, (expression, _))| (AstId(index as u32), expression))
    }
}
