//! Readable layout of sums and products: flat, with leading signs, and factors and terms in a
//! conventional order.
//!
//! This is shared by the writers of plain text and LaTeX. It determines order and structure, not
//! notation.

use std::borrow::Cow;
use std::cmp::Reverse;

use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::{Role, Symbol};

/// An expression with names for some of its parts.
pub(super) struct View<'v, 'n> {
    pub(super) graph: &'v Graph,
    /// Expression that is expanded even if it has a name.
    pub(super) root: ExprId,
    pub(super) names: &'v dyn Fn(ExprId) -> Option<&'n str>,
}

/// A term `coefficient · Π base ^ exponent`, with factors in reading order.
pub(super) struct WrittenTerm {
    pub(super) coefficient: Number,
    pub(super) factors: Vec<(ExprId, Number)>,
}

/// Binding strength of the outermost operation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Strength {
    /// A choice.
    Choice,
    /// A sum or something with a sign.
    Sum,
    /// A product or a quotient.
    Product,
    /// A power.
    Power,
    /// A name, a number, a call.
    Atom,
}

/// A part of a text that is being written.
pub(super) enum Piece {
    /// Finished text.
    Text(Cow<'static, str>),
    /// An expression, in parentheses if it binds less tightly than this.
    Expr(ExprId, Strength),
}

impl Piece {
    pub(super) fn text(text: impl Into<Cow<'static, str>>) -> Piece {
        Piece::Text(text.into())
    }
}

/// Writes `root`, each expression through `expand`, without recursion.
pub(super) fn write(root: ExprId, expand: impl Fn(ExprId, Strength) -> Vec<Piece>) -> String {
    let mut text = String::new();
    let mut pending = vec![Piece::Expr(root, Strength::Choice)];
    while let Some(piece) = pending.pop() {
        match piece {
            Piece::Text(piece) => text.push_str(&piece),
            Piece::Expr(id, least) => pending.extend(expand(id, least).into_iter().rev()),
        }
    }
    text
}

/// Joins terms with their signs; `product` writes a term without its sign.
pub(super) fn sum(
    terms: &[WrittenTerm],
    product: impl Fn(&WrittenTerm) -> (Strength, Vec<Piece>),
) -> (Strength, Vec<Piece>) {
    let mut pieces = Vec::new();
    let mut strength = Strength::Sum;
    for (position, term) in terms.iter().enumerate() {
        let sign = match (position, term.coefficient.is_negative()) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        pieces.push(Piece::text(sign));
        let (own, term_pieces) = product(term);
        pieces.extend(term_pieces);
        if terms.len() == 1 && sign.is_empty() {
            strength = own;
        }
    }
    (strength, pieces)
}

impl<'v, 'n> View<'v, 'n> {
    pub(super) fn name(&self, id: ExprId) -> Option<&'n str> {
        if id == self.root { None } else { (self.names)(id) }
    }

    pub(super) fn symbol(&self, id: ExprId) -> Option<&'v Symbol> {
        self.graph.symbol_of(id)
    }

    /// Returns the terms of an expression in reading order. Nested sums without a factor are
    /// flattened.
    pub(super) fn terms(&self, id: ExprId) -> Vec<WrittenTerm> {
        let mut number = Number::ZERO;
        let mut terms = Vec::new();
        let mut pending = vec![(id, Number::ONE)];
        while let Some((id, coefficient)) = pending.pop() {
            match self.graph.node(id) {
                _ if self.name(id).is_some() => {
                    terms.push(WrittenTerm { coefficient, factors: vec![(id, Number::ONE)] });
                }
                Node::Number(value) => number = &number + &(value * &coefficient),
                Node::Sum { constant, terms } if opens(constant, terms, &coefficient) => {
                    number = &number + &(constant * &coefficient);
                    pending.extend(terms.iter().map(|(term, c)| (*term, c * &coefficient)));
                }
                _ => terms.push(self.term(id, coefficient)),
            }
        }
        terms.sort_by_cached_key(|term| self.place_of_term(term));
        let mut terms = collected(terms);
        if !number.is_zero() || terms.is_empty() {
            terms.push(WrittenTerm { coefficient: number, factors: Vec::new() });
        }
        lead_with_positive(&mut terms);
        terms
    }

    /// Returns a product with nested products flattened.
    fn term(&self, id: ExprId, coefficient: Number) -> WrittenTerm {
        let mut coefficient = coefficient;
        let mut factors = Vec::new();
        let mut pending = vec![(id, Number::ONE)];
        while let Some((id, exponent)) = pending.pop() {
            let (inner, core) = self.graph.split_coefficient(id);
            match self.graph.node(id) {
                _ if self.name(id).is_some() => factors.push((id, exponent)),
                Node::Product(inner) if exponent.is_integer() => {
                    pending.extend(inner.iter().map(|(base, e)| (*base, e * &exponent)));
                }
                _ => match exponent.to_i32().and_then(|exponent| inner.power(exponent)) {
                    Some(number) if core != id => {
                        coefficient = &coefficient * &number;
                        pending.push((core, exponent));
                    }
                    _ => factors.push((id, exponent)),
                },
            }
        }
        factors.sort_by_cached_key(|(base, exponent)| (self.place_of_factor(*base), exponent.clone()));
        WrittenTerm { coefficient, factors: merge(factors) }
    }

    /// Returns the sort key of a factor: numbers, parameters, coordinates, functions, velocities,
    /// accelerations. Symbols of a kind are in declaration order.
    fn place_of_factor(&self, id: ExprId) -> (u8, u32, ExprId) {
        let (class, index) = match self.symbol(id).map(|symbol| symbol.role) {
            Some(Role::Parameter(index)) => (2, index),
            Some(Role::Input(index) | Role::Noise(index)) => (3, index),
            Some(Role::Time) => (4, 0),
            Some(Role::Coordinate(index) | Role::State(index) | Role::Discrete(index)) => (5, index),
            Some(Role::Velocity(index)) => (7, index),
            Some(Role::Acceleration(index)) => (8, index),
            Some(Role::Multiplier(index)) => (9, index),
            Some(Role::Reaction(index)) => (10, index),
            Some(Role::Side(index)) => (11, index),
            Some(Role::Operand(index) | Role::Placeholder(index)) => (12, index),
            None => (self.class_of_composite(id), u32::MAX),
        };
        (class, index, id)
    }

    fn class_of_composite(&self, id: ExprId) -> u8 {
        let dependencies = self.graph.dependencies(id);
        match self.graph.node(id) {
            Node::Number(_) => 0,
            Node::Pi | Node::Sum { .. } if dependencies.is_constant_in_motion() => 1,
            _ if dependencies.is_constant_in_motion() => 2,
            _ if dependencies.intersects(Dependencies::ACCELERATION) => 8,
            _ if dependencies.intersects(Dependencies::VELOCITY) => 7,
            _ => 6,
        }
    }

    /// Returns the sort key of a term. Accelerations precede velocities, which precede everything
    /// else; single symbols precede products, and numbers come last.
    fn place_of_term(&self, term: &WrittenTerm) -> impl Ord + use<> {
        let class = term.factors.iter().map(|(base, _)| self.graph.dependencies(*base)).fold(
            if term.factors.is_empty() { 4 } else { 3 },
            |class, dependencies| {
                let moving = [Dependencies::ACCELERATION, Dependencies::VELOCITY];
                moving.iter().position(|&kind| dependencies.intersects(kind)).unwrap_or(class).min(class)
            },
        );
        let is_product = match term.factors.as_slice() {
            [(base, exponent)] => !(exponent.is_one() && self.symbol(*base).is_some()),
            _ => true,
        };
        let place =
            |(base, exponent): &(ExprId, Number)| (self.place_of_factor(*base), Reverse(exponent.clone()));
        let acceleration = term.factors.iter().find_map(|(base, _)| match self.symbol(*base)?.role {
            Role::Acceleration(index) => Some(index),
            _ => None,
        });
        (class, acceleration, is_product, term.factors.iter().map(place).collect::<Vec<_>>())
    }
}

/// True if a sum is written as terms of the enclosing sum.
fn opens(constant: &Number, terms: &[(ExprId, Number)], coefficient: &Number) -> bool {
    coefficient.abs().is_one() || constant.is_zero() && terms.len() == 1
}

fn lead_with_positive(terms: &mut [WrittenTerm]) {
    if let Some(first) = terms.iter().position(|term| !term.coefficient.is_negative()) {
        terms[..=first].rotate_right(1);
    }
}

/// Adds neighbouring terms that differ only in their coefficients, such as `x` and those of a
/// flattened `2*x + y`.
fn collected(terms: Vec<WrittenTerm>) -> Vec<WrittenTerm> {
    let mut collected: Vec<WrittenTerm> = Vec::with_capacity(terms.len() + 1);
    for term in terms {
        match collected.last_mut() {
            Some(last) if last.factors == term.factors => {
                last.coefficient = &last.coefficient + &term.coefficient;
            }
            _ => collected.push(term),
        }
    }
    collected.retain(|term| !term.coefficient.is_zero());
    collected
}

/// Adds integer exponents of neighbours with the same base.
fn merge(factors: Vec<(ExprId, Number)>) -> Vec<(ExprId, Number)> {
    let mut merged: Vec<(ExprId, Number)> = Vec::with_capacity(factors.len());
    for (base, exponent) in factors {
        match merged.last_mut() {
            Some((last, total)) if *last == base && total.is_integer() && exponent.is_integer() => {
                *total = &*total + &exponent;
            }
            _ => merged.push((base, exponent)),
        }
    }
    merged.retain(|(_, exponent)| !exponent.is_zero());
    merged
}
