//! Normal form of sines and cosines, which is unique for equal values.
//!
//! Sines and cosines of sums become polynomials in those of the single angles (Abramowitz and
//! Stegun, §4.3.16–17). Then sin² becomes 1 - cos² and sinh² becomes cosh² - 1. If the single
//! angles are independent, two polynomials of that form are equal only if they are the same.

use super::effort::Effort;
use super::monomial::{Monomial, Term};
use super::polynomial::Polynomial;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

/// Largest multiple of an angle that is written in terms of the sine and cosine of the angle, with
/// n + 1 terms for both. Higher multiples are separate angles.
const HIGHEST_MULTIPLE: i32 = 8;

/// The sine and the cosine of an angle.
struct SineAndCosine {
    sin: Polynomial,
    cos: Polynomial,
}

/// Expands sin or cos of an angle; `None` if this exceeds the budget.
pub(super) fn expand(
    effort: &mut Effort,
    graph: &mut Graph,
    function: Function,
    angle: &Polynomial,
) -> Option<Polynomial> {
    let one = Number::ONE;
    let mut total = SineAndCosine { sin: Polynomial::default(), cos: Polynomial::constant(one) };
    for (monomial, coefficient) in angle.iter() {
        let multiple = coefficient.to_i32().filter(|n| (-HIGHEST_MULTIPLE..=HIGHEST_MULTIPLE).contains(n));
        let (unit, times, sign) = match multiple {
            Some(n) => (Number::ONE, n.unsigned_abs(), n.signum()),
            None => (coefficient.clone(), 1, 1),
        };
        let unit = wave_of(graph, monomial, unit, sign);
        for _ in 0..times {
            total = add_angles(effort, &total, &unit)?;
        }
    }
    Some(if function == Function::Sin { total.sin } else { total.cos })
}

fn wave_of(graph: &mut Graph, monomial: &Monomial, coefficient: Number, sign: i32) -> SineAndCosine {
    let core = monomial.build(graph);
    let angle = graph.scale(coefficient, core);
    let [sin, cos] = [Function::Sin, Function::Cos].map(|f| {
        let call = apply(graph, f, &[angle]);
        Polynomial::atom(graph, call)
    });
    let mut signed = Polynomial::default();
    signed.add_scaled(&sin, &Number::from(i64::from(sign)));
    SineAndCosine { sin: signed, cos }
}

fn add_angles(effort: &mut Effort, a: &SineAndCosine, b: &SineAndCosine) -> Option<SineAndCosine> {
    let mut sin = effort.times(&a.sin, &b.cos)?;
    sin.add_scaled(&effort.times(&a.cos, &b.sin)?, &Number::ONE);
    let mut cos = effort.times(&a.cos, &b.cos)?;
    cos.add_scaled(&effort.times(&a.sin, &b.sin)?, &Number::MINUS_ONE);
    Some(SineAndCosine { sin: effort.within_budget(sin)?, cos: effort.within_budget(cos)? })
}

/// Returns the polynomial without powers of sines and hyperbolic sines above the first.
pub(super) fn reduce(effort: &mut Effort, graph: &mut Graph, polynomial: &Polynomial) -> Option<Polynomial> {
    let mut polynomial = polynomial.clone();
    loop {
        let mut reduced = Polynomial::default();
        let mut changed = false;
        for term in polynomial.terms() {
            let replaced = reduce_term(effort, graph, &term)?;
            changed |= replaced.is_some();
            reduced.add_scaled(&replaced.unwrap_or_else(|| Polynomial::of_terms([term])), &Number::ONE);
        }
        polynomial = effort.within_budget(reduced)?;
        if !changed {
            return Some(polynomial);
        }
    }
}

/// Returns the term with two powers of a sine replaced; `Some(None)` if it has no such power.
fn reduce_term(effort: &mut Effort, graph: &mut Graph, term: &Term) -> Option<Option<Polynomial>> {
    let is_square = |&(base, ref exponent): &(ExprId, Number)| {
        let partner = partner(graph, base)?;
        exponent.to_i32().filter(|&e| e > 1).map(|_| (base, partner))
    };
    let Some((base, (cofunction, argument))) = term.monomial.factors().iter().find_map(is_square) else {
        return Some(None);
    };
    let other = apply(graph, cofunction, &[argument]);
    let sign = if cofunction == Function::Cos { Number::ONE } else { Number::MINUS_ONE };
    let rest = term.monomial.times_power(base, -2);
    effort.spend(2)?;
    let square = Term { coefficient: -&(&term.coefficient * &sign), monomial: rest.times_power(other, 2) };
    let one = Term { coefficient: &term.coefficient * &sign, monomial: rest };
    Some(Some(Polynomial::of_terms([one, square])))
}

/// Returns the function whose square replaces that of a sine or a hyperbolic sine, and the
/// argument.
fn partner(graph: &Graph, id: ExprId) -> Option<(Function, ExprId)> {
    match graph.node(id) {
        Node::Call(Function::Sin, x) => Some((Function::Cos, x[0])),
        Node::Call(Function::Sinh, x) => Some((Function::Cosh, x[0])),
        _ => None,
    }
}
