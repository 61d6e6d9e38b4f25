//! Expressions in LaTeX, for mathematics mode; choices need the `amsmath` package.
//!
//! Expressions are written out in full; [`definitions`] names shared parts if the text would be too
//! long.

mod names;

use super::layout::{Piece, Strength, View, WrittenTerm, sum, write as write_pieces};
use super::naming::define;
use super::numerals::numeral;
use lagrange_expr::elementary::row;
use lagrange_expr::expr::{ExprId, Function, Graph, Node, Relation};
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Symbol;
use names::latex_name;

/// Writes the expression out in full.
pub fn latex(graph: &Graph, expr: ExprId) -> String {
    write(graph, expr, &|_| None)
}

/// Writes definitions like [`text::definitions`](super::text::definitions), in LaTeX.
pub fn definitions(
    graph: &Graph,
    roots: &[ExprId],
    max_length: usize,
) -> (Vec<(String, String)>, Vec<String>) {
    let (definitions, texts) = define(graph, roots, max_length, |id, names| write(graph, id, names));
    (definitions.into_iter().map(|(name, text)| (latex_name(&name, None), text)).collect(), texts)
}

fn write<'n>(graph: &Graph, expr: ExprId, names: &dyn Fn(ExprId) -> Option<&'n str>) -> String {
    let view = View { graph, root: expr, names };
    write_pieces(expr, |id, least| pieces(&view, id, least))
}

fn pieces(view: &View, id: ExprId, least: Strength) -> Vec<Piece> {
    let atom = |text: String| (Strength::Atom, vec![Piece::text(text)]);
    let (strength, mut pieces) = match (view.name(id), view.graph.node(id)) {
        (Some(name), _) => atom(latex_name(name, None)),
        (_, Node::Symbol(symbol)) => atom(symbol_latex(view.graph.symbols().get(*symbol))),
        (_, Node::Pi) => atom(r"\pi".to_owned()),
        (_, Node::Call(function, arguments)) => call(*function, arguments),
        (_, Node::Opaque(function, _)) if function.is_solution() => {
            (Strength::Atom, vec![Piece::text(latex_name(&function.function().name, None))])
        }
        (_, Node::Opaque(function, arguments)) => opaque(function, arguments),
        (_, Node::Choose { .. }) => (Strength::Choice, cases(view, id)),
        (_, Node::Number(_) | Node::Sum { .. } | Node::Product(_)) => {
            sum(&view.terms(id), |term| product(view, term))
        }
    };
    if strength < least {
        pieces.insert(0, Piece::text(r"\left("));
        pieces.push(Piece::text(r"\right)"));
    }
    pieces
}

/// Writes the rate of the variable of this name.
pub fn rate(name: &str) -> String {
    latex_name(name, Some(r"\dot"))
}

fn symbol_latex(symbol: &Symbol) -> String {
    let accent = match symbol.dots {
        0 => None,
        1 => Some(r"\dot"),
        _ => Some(r"\ddot"),
    };
    latex_name(&symbol.name, accent)
}

fn call(function: Function, arguments: &[ExprId]) -> (Strength, Vec<Piece>) {
    let template = row(function).latex;
    if function == Function::Power {
        return (Strength::Power, fill(template, arguments, Strength::Atom));
    }
    (Strength::Atom, fill(template, arguments, Strength::Choice))
}

fn opaque(function: &Opaque, arguments: &[ExprId]) -> (Strength, Vec<Piece>) {
    let mut pieces = vec![Piece::text(function.latex()), Piece::text(r"\left(")];
    for (position, &argument) in arguments.iter().enumerate() {
        if position > 0 {
            pieces.push(Piece::text(", "));
        }
        pieces.push(Piece::Expr(argument, Strength::Choice));
    }
    pieces.push(Piece::text(r"\right)"));
    (Strength::Atom, pieces)
}

/// Fills a template: `#1` is replaced by the first argument, bound as tightly as `first`, and `#2`
/// by the second.
fn fill(template: &'static str, arguments: &[ExprId], first: Strength) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let mut rest = template;
    while let Some((before, after)) = rest.split_once('#') {
        pieces.push(Piece::text(before));
        let (least, argument) = if after.starts_with('2') { (Strength::Choice, 1) } else { (first, 0) };
        pieces.push(Piece::Expr(arguments[argument], least));
        rest = &after[1..];
    }
    pieces.push(Piece::text(rest));
    pieces
}

fn cases(view: &View, id: ExprId) -> Vec<Piece> {
    let mut pieces = vec![Piece::text(r"\begin{cases}")];
    let mut last = id;
    while let Node::Choose { relation, left, right, then, otherwise } = view.graph.node(last) {
        let sign = if *relation == Relation::Less { " < " } else { r" \le " };
        pieces.extend([
            Piece::text(" "),
            Piece::Expr(*then, Strength::Choice),
            Piece::text(r" & \text{if } "),
            Piece::Expr(*left, Strength::Sum),
            Piece::text(sign),
            Piece::Expr(*right, Strength::Sum),
            Piece::text(r" \\"),
        ]);
        last = *otherwise;
        if view.name(last).is_some() {
            break;
        }
    }
    pieces.extend([
        Piece::text(" "),
        Piece::Expr(last, Strength::Choice),
        Piece::text(r" & \text{otherwise} \end{cases}"),
    ]);
    pieces
}

/// Writes a term without its sign.
fn product(view: &View, term: &WrittenTerm) -> (Strength, Vec<Piece>) {
    let (below, above): (Vec<_>, Vec<_>) =
        term.factors.iter().cloned().partition(|(_, exponent)| exponent.is_negative());
    let below = below.into_iter().map(|(base, exponent)| (base, -&exponent)).collect::<Vec<_>>();
    let number = numeral(&term.coefficient.abs());
    let numerator = scientific(&number.numerator);
    if below.is_empty() {
        let prefix = match number.denominator {
            Some(divisor) => format!(r"\frac{{{numerator}}}{{{divisor}}}"),
            None => numerator,
        };
        return factors(view, prefix, &above);
    }
    let mut pieces = vec![Piece::text(r"\frac{")];
    pieces.extend(enclosed(view, numerator, &above));
    pieces.push(Piece::text("}{"));
    pieces.extend(enclosed(view, number.denominator.unwrap_or_else(|| "1".to_owned()), &below));
    pieces.push(Piece::text("}"));
    (Strength::Product, pieces)
}

/// Writes a product between braces, where a single sum needs no parentheses.
fn enclosed(view: &View, number: String, product: &[(ExprId, Number)]) -> Vec<Piece> {
    match product {
        [(base, exponent)] if exponent.is_one() && number == "1" => vec![Piece::Expr(*base, Strength::Sum)],
        _ => factors(view, number, product).1,
    }
}

fn factors(view: &View, number: String, factors: &[(ExprId, Number)]) -> (Strength, Vec<Piece>) {
    let shows_number = number != "1" || factors.is_empty();
    let mut pieces = Vec::new();
    let mut strength = if factors.is_empty() { Strength::Atom } else { Strength::Power };
    if number.starts_with('\\') || number.contains(' ') {
        strength = Strength::Product;
    }
    let count = factors.len() + usize::from(shows_number);
    if shows_number {
        pieces.push(Piece::text(number));
    }
    for (base, exponent) in factors {
        if !pieces.is_empty() {
            let is_digit = view.graph.as_number(*base).is_some();
            pieces.push(Piece::text(if is_digit { r" \cdot " } else { " " }));
        }
        pieces.extend(factor(view, *base, exponent));
    }
    (if count > 1 { Strength::Product } else { strength }, pieces)
}

/// Writes `base ^ exponent` with a positive exponent.
fn factor(view: &View, base: ExprId, exponent: &Number) -> Vec<Piece> {
    if exponent.is_one() {
        return vec![Piece::Expr(base, Strength::Product)];
    }
    if (exponent * &Number::TWO).is_one() {
        return vec![Piece::text(r"\sqrt{"), Piece::Expr(base, Strength::Choice), Piece::text("}")];
    }
    if let Some((name, arguments)) = power_after_name(view, base) {
        let mut pieces = vec![Piece::text(format!("{name}^{{{exponent}}}"))];
        pieces.extend(fill(arguments.0, arguments.1, Strength::Choice));
        return pieces;
    }
    vec![Piece::Expr(base, Strength::Atom), Piece::text(format!("^{{{exponent}}}"))]
}

/// Returns the name and the parenthesised rest of a call such as `\sin\left(x\right)`, whose powers
/// are written after the name.
fn power_after_name<'v>(
    view: &'v View,
    base: ExprId,
) -> Option<(&'static str, (&'static str, &'v [ExprId]))> {
    let Node::Call(function, arguments) = view.graph.node(base) else { return None };
    if view.name(base).is_some() {
        return None;
    }
    let template = row(*function).latex;
    let (name, rest) = template.split_at(template.find(r"\left(")?);
    let is_name = name.len() > 1 && name[1..].bytes().all(|byte| byte.is_ascii_alphabetic());
    is_name.then_some((name, (rest, arguments)))
}

fn scientific(number: &str) -> String {
    match number.split_once('e') {
        Some(("1", exponent)) => format!("10^{{{exponent}}}"),
        Some((digits, exponent)) => format!(r"{digits} \cdot 10^{{{exponent}}}"),
        None => number.to_owned(),
    }
}
