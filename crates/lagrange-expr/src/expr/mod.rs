//! Expressions as a hash-consed directed acyclic graph.
//!
//! A [`Graph`] owns every expression of one system; an [`ExprId`] is a handle into it. Equal
//! expressions have equal ids, and children have smaller ids than their parents. A loop over
//! ascending ids therefore proceeds from the leaves to the roots without a stack.
//!
//! Nodes are only created by the constructors in [`sum`](Graph::sum), [`product`](Graph::product)
//! and [`choose`](Graph::choose), and for elementary functions from [`crate::functions`]. They fold
//! numbers, collect equal terms and equal bases and sort operands. They do *not* expand products,
//! and they keep the nesting in which a formula was built unless a term cancels. Shared parts stay
//! shared, which keeps derived equations small. The graph itself contains no algorithms; these are
//! functions that take the graph.

mod combine;
mod evaluate;
mod facts;
mod reach;
mod unknown;
mod weighted;

use indexmap::IndexSet;
use rustc_hash::FxBuildHasher;

pub use crate::elementary::Function;
pub use evaluate::{evaluate, node_value};
pub use facts::Dependencies;
pub use unknown::AlgebraicUnknowns;

use crate::collections::HashMap;
use crate::number::Number;
use crate::opaque::Opaque;
use crate::symbol::{Role, Symbol, SymbolId, Symbols};
use facts::Facts;

/// Identifies an expression of one [`Graph`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ExprId(u32);

impl ExprId {
    fn index(self) -> usize {
        self.0 as usize
    }
}

/// An order relation between two real numbers.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Relation {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`; the graph swaps operands and stores `<`.
    Greater,
    /// `>=`; the graph swaps operands and stores `<=`.
    GreaterEqual,
}

impl Relation {
    /// True if it holds between two values; never with NaN.
    pub fn holds<T: PartialOrd + Copy>(self, left: T, right: T) -> bool {
        match self {
            Relation::Less => left < right,
            Relation::LessEqual => left <= right,
            Relation::Greater => left > right,
            Relation::GreaterEqual => left >= right,
        }
    }

    /// Returns the symbol of the relation.
    pub fn symbol(self) -> &'static str {
        match self {
            Relation::Less => "<",
            Relation::LessEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterEqual => ">=",
        }
    }
}

/// One expression; operands are ids of the same graph.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Node {
    /// An exact number.
    Number(Number),
    /// The circle constant.
    Pi,
    /// A symbol.
    Symbol(SymbolId),
    /// `constant + Σ coefficient · term`. With a single term and no constant it is a scaled
    /// expression.
    Sum {
        /// The number added.
        constant: Number,
        /// Terms with their coefficients, in ascending order of ids.
        terms: Box<[(ExprId, Number)]>,
    },
    /// `Π base ^ exponent` with numeric exponents, in ascending order of ids.
    Product(Box<[(ExprId, Number)]>),
    /// An elementary function; square roots and powers with numeric exponents are products instead.
    Call(Function, Box<[ExprId]>),
    /// The value or a derivative of a function without a formula.
    Opaque(Opaque, Box<[ExprId]>),
    /// `if left relation right { then } else { otherwise }`, where the relation is `<` or `<=`.
    Choose {
        /// `<` or `<=`.
        relation: Relation,
        /// Left operand of the relation.
        left: ExprId,
        /// Right operand of the relation.
        right: ExprId,
        /// Value where the relation holds.
        then: ExprId,
        /// Value elsewhere.
        otherwise: ExprId,
    },
}

impl Node {
    /// Calls `visit` with every operand.
    pub fn for_each_child(&self, mut visit: impl FnMut(ExprId)) {
        match self {
            Node::Number(_) | Node::Pi | Node::Symbol(_) => {}
            Node::Sum { terms, .. } => terms.iter().for_each(|(term, _)| visit(*term)),
            Node::Product(factors) => factors.iter().for_each(|(base, _)| visit(*base)),
            Node::Call(_, arguments) | Node::Opaque(_, arguments) => {
                arguments.iter().copied().for_each(visit);
            }
            Node::Choose { left, right, then, otherwise, .. } => {
                [*left, *right, *then, *otherwise].into_iter().for_each(visit);
            }
        }
    }
}

/// All expressions and symbols of one system.
#[derive(Clone, Default, Debug)]
pub struct Graph {
    nodes: IndexSet<Node, FxBuildHasher>,
    facts: Vec<Facts>,
    symbols: Symbols,
    /// Rates of positions that are not the velocities with the same index.
    rates: HashMap<ExprId, ExprId>,
    /// Nonzero powers of the unit of inertia in which symbols are measured.
    grades: HashMap<ExprId, Number>,
    /// Implicit definitions by equations.
    unknowns: Vec<AlgebraicUnknowns>,
    /// Number of the operands of these equations.
    operands: u32,
}

impl Graph {
    /// Creates an empty graph.
    pub fn new() -> Graph {
        Graph::default()
    }

    /// Returns the node behind an id.
    pub fn node(&self, id: ExprId) -> &Node {
        &self.nodes[id.index()]
    }

    /// Returns the number of distinct expressions created so far.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// True if no expression has been created.
    pub fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Returns the symbols in expressions.
    pub fn symbols(&self) -> &Symbols {
        &self.symbols
    }

    /// Returns the symbol, if the expression is one.
    pub fn symbol_of(&self, id: ExprId) -> Option<&Symbol> {
        match self.node(id) {
            Node::Symbol(symbol) => Some(self.symbols.get(*symbol)),
            _ => None,
        }
    }

    /// Returns the quantities that the value may change with.
    pub fn dependencies(&self, id: ExprId) -> Dependencies {
        self.facts[id.index()].dependencies
    }

    /// True if the value is known to be zero or positive wherever it is defined.
    pub fn is_nonnegative(&self, id: ExprId) -> bool {
        self.facts[id.index()].nonnegative
    }

    /// True if the value may be undefined for some arguments, such as the root of a possibly
    /// negative expression.
    pub fn is_partial(&self, id: ExprId) -> bool {
        self.facts[id.index()].partial
    }

    /// Counts the names, numbers and function signs of the expression when written out; the count
    /// saturates.
    pub fn written_size(&self, id: ExprId) -> u64 {
        self.facts[id.index()].written_size
    }

    /// Returns the number, if the expression is one.
    pub fn as_number(&self, id: ExprId) -> Option<&Number> {
        match self.node(id) {
            Node::Number(value) => Some(value),
            _ => None,
        }
    }

    /// True if the expression is the number zero.
    pub fn is_zero(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(Number::is_zero)
    }

    /// True if the expression is the number one.
    pub fn is_one(&self, id: ExprId) -> bool {
        self.as_number(id).is_some_and(Number::is_one)
    }

    /// Returns `(c, x)` such that the expression is `c · x` and `x` has no numeric factor.
    pub fn split_coefficient(&self, id: ExprId) -> (Number, ExprId) {
        match self.node(id) {
            Node::Sum { constant, terms } if constant.is_zero() && terms.len() == 1 => {
                (terms[0].1.clone(), terms[0].0)
            }
            _ => (Number::ONE, id),
        }
    }

    fn intern(&mut self, node: Node) -> ExprId {
        let (index, new) = self.nodes.insert_full(node);
        if new {
            let facts = Facts::of(self, &self.nodes[index]);
            self.facts.push(facts);
        }
        ExprId(u32::try_from(index).expect("fewer than 2^32 expressions fit in memory"))
    }

    /// Creates an exact number.
    pub fn number(&mut self, value: impl Into<Number>) -> ExprId {
        self.intern(Node::Number(value.into()))
    }

    /// Creates the circle constant.
    pub fn pi(&mut self) -> ExprId {
        self.intern(Node::Pi)
    }

    /// Returns the symbol in `role`, named on first use.
    pub fn symbol(&mut self, name: &str, role: Role) -> ExprId {
        let id = self.symbols.intern(name, role);
        self.intern(Node::Symbol(id))
    }

    /// Returns the symbol in `role`, with its name and this many dots if it is new.
    pub fn dotted_symbol(&mut self, name: &str, role: Role, dots: u8) -> ExprId {
        let id = self.symbols.intern_dotted(name, role, dots);
        self.intern(Node::Symbol(id))
    }

    /// Sets the rate of a position to a function of positions and velocities, instead of the
    /// velocity with the same index.
    pub fn set_rate(&mut self, position: ExprId, rate: ExprId) {
        self.rates.insert(position, rate);
    }

    /// Removes the rate of a position set by [`set_rate`](Graph::set_rate).
    pub fn remove_rate(&mut self, position: ExprId) {
        self.rates.remove(&position);
    }

    /// Returns the rate of a position if it differs from the velocity with the same index.
    pub fn rate_of_position(&self, position: ExprId) -> Option<ExprId> {
        self.rates.get(&position).copied()
    }

    /// Sets the powers of the unit of inertia in which symbols are measured.
    pub fn set_grades(&mut self, grades: impl IntoIterator<Item = (ExprId, Number)>) {
        self.grades = grades.into_iter().collect();
    }

    /// True if a symbol is known to be measured in the unit of inertia.
    pub fn is_graded(&self) -> bool {
        !self.grades.is_empty()
    }

    /// Returns the power of the unit of inertia in which a symbol is measured; zero if none is
    /// known.
    pub fn grade_of_symbol(&self, symbol: ExprId) -> Number {
        self.grades.get(&symbol).cloned().unwrap_or(Number::ZERO)
    }

    /// Creates a function call as it is; [`crate::functions::apply`] is the simplifying
    /// constructor.
    pub fn call(&mut self, function: Function, arguments: &[ExprId]) -> ExprId {
        self.intern(Node::Call(function, arguments.into()))
    }

    /// Creates the value or a derivative of a function without a formula, for all of its arguments.
    pub fn opaque(&mut self, function: Opaque, arguments: &[ExprId]) -> ExprId {
        if function.vanishes() {
            return self.number(0);
        }
        self.intern(Node::Opaque(function, arguments.into()))
    }

    /// Creates `if left relation right { then } else { otherwise }`. The condition is evaluated if
    /// both sides are numbers, and dropped if both values are the same expression.
    pub fn choose(
        &mut self,
        relation: Relation,
        left: ExprId,
        right: ExprId,
        then: ExprId,
        otherwise: ExprId,
    ) -> ExprId {
        let (relation, left, right) = match relation {
            Relation::Greater => (Relation::Less, right, left),
            Relation::GreaterEqual => (Relation::LessEqual, right, left),
            _ => (relation, left, right),
        };
        if then == otherwise {
            return then;
        }
        if let (Some(a), Some(b)) = (self.as_number(left), self.as_number(right)) {
            let holds = if relation == Relation::Less { a < b } else { a <= b };
            return if holds { then } else { otherwise };
        }
        self.intern(Node::Choose { relation, left, right, then, otherwise })
    }
}

#[cfg(test)]
mod tests;
