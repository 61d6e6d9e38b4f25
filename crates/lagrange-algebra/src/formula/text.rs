//! Expressions in the syntax of the language, so that they can be read back.
//!
//! An algebraic unknown is written as its name, with its equation elsewhere. An expression is
//! written out in full unless shared parts are named. The full text can be exponentially longer
//! than the graph; [`definitions`] avoids this.

use std::borrow::Cow;

use super::layout::{Piece, Strength, View, WrittenTerm, sum, write as write_pieces};
use super::naming::define;
use super::numerals::numeral;
use lagrange_expr::elementary::row;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Writes the expression out in full.
pub fn text(graph: &Graph, expr: ExprId) -> String {
    write(graph, expr, &|_| None)
}

/// Writes the rate of the variable of this name.
pub fn rate(name: &str) -> String {
    format!("dot({name})")
}

/// Writes an expression with its named parts by their names; `expr` itself is written out.
pub fn write<'n>(graph: &Graph, expr: ExprId, names: &dyn Fn(ExprId) -> Option<&'n str>) -> String {
    let view = View { graph, root: expr, names };
    write_pieces(expr, |id, least| pieces(&view, id, least))
}

/// Writes the roots in at most about `max_length` characters if that is possible without names.
/// Otherwise shared parts get names, so that the length is proportional to the size of the graph.
///
/// The first list contains `(name, text)` in an order in which everything is defined before its
/// use. The second one contains the texts of the roots.
pub fn definitions(
    graph: &Graph,
    roots: &[ExprId],
    max_length: usize,
) -> (Vec<(String, String)>, Vec<String>) {
    define(graph, roots, max_length, |id, names| write(graph, id, names))
}

fn pieces(view: &View, id: ExprId, least: Strength) -> Vec<Piece> {
    let (strength, pieces) = match (view.name(id), view.graph.node(id)) {
        (Some(name), _) => (Strength::Atom, vec![Piece::text(name.to_owned())]),
        (_, Node::Symbol(symbol)) => {
            (Strength::Atom, vec![Piece::text(view.graph.symbols().get(*symbol).text())])
        }
        (_, Node::Pi) => (Strength::Atom, vec![Piece::text("pi")]),
        (_, Node::Call(function, arguments)) => (Strength::Atom, call(row(*function).name, arguments)),
        (_, Node::Opaque(function, _)) if function.is_solution() => {
            (Strength::Atom, vec![Piece::text(function.text())])
        }
        (_, Node::Opaque(function, arguments)) => (Strength::Atom, call(function.text(), arguments)),
        (_, Node::Choose { .. }) => (Strength::Choice, choice(view, id)),
        (_, Node::Number(_) | Node::Sum { .. } | Node::Product(_)) => sum(&view.terms(id), product),
    };
    parenthesised(strength < least, pieces)
}

fn parenthesised(needed: bool, mut pieces: Vec<Piece>) -> Vec<Piece> {
    if needed {
        pieces.insert(0, Piece::text("("));
        pieces.push(Piece::text(")"));
    }
    pieces
}

fn call(name: impl Into<Cow<'static, str>>, arguments: &[ExprId]) -> Vec<Piece> {
    let mut pieces = vec![Piece::text(name), Piece::text("(")];
    for (position, &argument) in arguments.iter().enumerate() {
        if position > 0 {
            pieces.push(Piece::text(", "));
        }
        pieces.push(Piece::Expr(argument, Strength::Choice));
    }
    pieces.push(Piece::text(")"));
    pieces
}

fn choice(view: &View, id: ExprId) -> Vec<Piece> {
    let &Node::Choose { relation, left, right, then, otherwise } = view.graph.node(id) else {
        return Vec::new();
    };
    let mut pieces = vec![
        Piece::text("if "),
        Piece::Expr(left, Strength::Sum),
        Piece::text(format!(" {} ", relation.symbol())),
        Piece::Expr(right, Strength::Sum),
        Piece::text(" { "),
        Piece::Expr(then, Strength::Choice),
        Piece::text(" } else "),
    ];
    let chains = view.name(otherwise).is_none() && matches!(view.graph.node(otherwise), Node::Choose { .. });
    let last = Piece::Expr(otherwise, Strength::Choice);
    if chains {
        pieces.push(last);
    } else {
        pieces.extend([Piece::text("{ "), last, Piece::text(" }")]);
    }
    pieces
}

/// Writes a term without its sign.
fn product(term: &WrittenTerm) -> (Strength, Vec<Piece>) {
    let (below, above): (Vec<_>, Vec<_>) = term.factors.iter().partition(|(_, e)| e.is_negative());
    let number = numeral(&term.coefficient.abs());
    let mut numerator =
        above.into_iter().map(|(base, e)| factor(*base, e, Strength::Product)).collect::<Vec<_>>();
    let mut denominator =
        below.into_iter().map(|(base, e)| factor(*base, &-e, Strength::Power)).collect::<Vec<_>>();
    let text_factor = |text: String| (Strength::Atom, vec![Piece::text(text)]);
    match number.denominator {
        Some(divisor) if denominator.is_empty() => {
            let fraction = format!("{}/{divisor}", number.numerator);
            numerator.insert(0, (Strength::Product, vec![Piece::text(fraction)]));
        }
        divisor => {
            if let Some(divisor) = divisor {
                denominator.insert(0, text_factor(divisor));
            }
            if number.numerator != "1" || numerator.is_empty() {
                numerator.insert(0, text_factor(number.numerator));
            }
        }
    }
    quotient(numerator, denominator)
}

type Factors = Vec<(Strength, Vec<Piece>)>;

fn quotient(numerator: Factors, denominator: Factors) -> (Strength, Vec<Piece>) {
    let (strength, mut pieces) = joined(numerator);
    if denominator.is_empty() {
        return (strength, pieces);
    }
    let (strength, below) = joined(denominator);
    pieces.push(Piece::text("/"));
    pieces.extend(parenthesised(strength <= Strength::Product, below));
    (Strength::Product, pieces)
}

fn joined(mut factors: Factors) -> (Strength, Vec<Piece>) {
    if factors.len() == 1 {
        return factors.remove(0);
    }
    let mut pieces = Vec::new();
    for (position, (_, factor)) in factors.into_iter().enumerate() {
        if position > 0 {
            pieces.push(Piece::text("*"));
        }
        pieces.extend(factor);
    }
    (Strength::Product, pieces)
}

/// Writes `base ^ exponent` with a positive exponent; a base without an exponent binds at least as
/// tightly as `least`.
fn factor(base: ExprId, exponent: &Number, least: Strength) -> (Strength, Vec<Piece>) {
    if exponent.is_one() {
        return (Strength::Atom, vec![Piece::Expr(base, least)]);
    }
    if (exponent * &Number::TWO).is_one() {
        return (Strength::Atom, call("sqrt", &[base]));
    }
    let power = if exponent.is_integer() { format!("^{exponent}") } else { format!("^({exponent})") };
    (Strength::Power, vec![Piece::Expr(base, Strength::Atom), Piece::text(power)])
}
