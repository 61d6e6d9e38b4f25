//! Engine of the rules: it finds pairs of terms that a rule combines.
//!
//! A term is read as a side of a rule in every possible way. Readings are looked up by the required
//! form of the other side. The cost is therefore proportional to the number of terms, not of pairs.

use super::monomial::{Monomial, Term};
use super::rules::{Rule, RuleArguments};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// A term after joining, and the input term that it comes from.
#[derive(Debug)]
pub(super) struct Joined {
    pub(super) term: Term,
    /// The index of an input term that this one contains; they are identical if nothing was joined.
    pub(super) source: usize,
}

/// A term `key.coefficient · key.cofactor · f(key.x) · g(key.y)`.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Reading {
    rule: usize,
    is_left: bool,
    x: ExprId,
    y: ExprId,
    /// Factor of the left term of the rule.
    coefficient: Number,
    cofactor: Monomial,
}

impl Rule {
    /// Returns the single term that replaces the terms `a` and `b` of a sum, if the rule matches
    /// them.
    pub fn apply(&self, graph: &mut Graph, a: ExprId, b: ExprId) -> Option<ExprId> {
        let terms = [a, b].map(|id| {
            let (coefficient, core) = graph.split_coefficient(id);
            Monomial::of(graph, core, usize::MAX).map(|monomial| Term { coefficient, monomial })
        });
        let terms = terms.into_iter().flatten().collect();
        let joined = join(graph, std::slice::from_ref(self), terms, |_| Some(()))?;
        let [single] = joined.as_slice() else { return None };
        let product = single.term.monomial.build(graph);
        Some(graph.scale(single.term.coefficient.clone(), product))
    }
}

/// Applies `rules` until none matches. `spend` receives the number of ways of reading each term.
/// `None` if `spend` returns `None`.
pub(super) fn join(
    graph: &mut Graph,
    rules: &[Rule],
    terms: Vec<Term>,
    mut spend: impl FnMut(usize) -> Option<()>,
) -> Option<Vec<Joined>> {
    let mut open: HashMap<Reading, Vec<usize>> = HashMap::default();
    let mut slots =
        terms.into_iter().enumerate().map(|(source, term)| Some(Joined { term, source })).collect::<Vec<_>>();
    let mut next = 0;
    while let Some(slot) = slots.get(next) {
        let readings = slot.as_ref().map_or(Vec::new(), |joined| readings(graph, rules, &joined.term));
        spend(readings.len())?;
        match readings.iter().find_map(|reading| partner(&mut open, &slots, reading)) {
            Some((partner, reading)) => {
                let left = if reading.is_left { next } else { partner };
                let source = slots[left].as_ref().map_or(left, |joined| joined.source);
                slots[next] = None;
                slots[partner] = None;
                let term = replace(graph, &rules[reading.rule], reading);
                slots.push(Some(Joined { term, source }));
            }
            None => {
                for reading in readings {
                    open.get_or_insert_with(reading, Vec::new).push(next);
                }
            }
        }
        next += 1;
    }
    Some(slots.into_iter().flatten().collect())
}

/// Returns a remaining term that is the other side of `reading`.
fn partner<'a>(
    open: &mut HashMap<Reading, Vec<usize>>,
    slots: &[Option<Joined>],
    reading: &'a Reading,
) -> Option<(usize, &'a Reading)> {
    let other = Reading { is_left: !reading.is_left, ..reading.clone() };
    let candidates = open.get_or_insert_with(other, Vec::new);
    let present = std::iter::from_fn(|| candidates.pop()).find(|&candidate| slots[candidate].is_some());
    present.map(|candidate| (candidate, reading))
}

fn replace(graph: &mut Graph, rule: &Rule, reading: &Reading) -> Term {
    let result = (rule.result)(graph, reading.x, reading.y);
    let (inner, core) = graph.split_coefficient(result);
    let number = graph.as_number(core).cloned();
    let monomial = match number {
        Some(_) => reading.cofactor.clone(),
        None => reading.cofactor.times_power(core, 1),
    };
    let inner = &inner * &number.unwrap_or(Number::ONE);
    Term { coefficient: &reading.coefficient * &inner, monomial }
}

fn readings(graph: &Graph, rules: &[Rule], term: &Term) -> Vec<Reading> {
    let calls = calls(graph, &term.monomial);
    let mut found = Vec::new();
    if calls.is_empty() {
        return found;
    }
    for (index, rule) in rules.iter().enumerate() {
        for (is_left, pattern) in [(true, rule.left), (false, rule.right)] {
            for (x, y, matched) in matches(&calls, pattern, rule.arguments) {
                let flipped = rule.subtracts && !is_left;
                let coefficient = if flipped { -&term.coefficient } else { term.coefficient.clone() };
                let cofactor = term.monomial.over(&matched);
                found.push(Reading { rule: index, is_left, x, y, coefficient, cofactor });
            }
        }
    }
    found
}

/// A factor `function(argument) ^ exponent` with a positive integer exponent.
struct CallFactor {
    id: ExprId,
    function: Function,
    argument: ExprId,
    exponent: i32,
}

fn calls(graph: &Graph, monomial: &Monomial) -> Vec<CallFactor> {
    let call = |&(id, ref exponent): &(ExprId, Number)| {
        let exponent = exponent.to_i32().filter(|&e| e > 0)?;
        match graph.node(id) {
            Node::Call(function @ (Function::Sin | Function::Cos | Function::Sinh | Function::Cosh), x) => {
                Some(CallFactor { id, function: *function, argument: x[0], exponent })
            }
            _ => None,
        }
    };
    monomial.factors().iter().filter_map(call).collect()
}

/// Returns every `(x, y, f(x)·g(y))` among the factors.
fn matches(
    calls: &[CallFactor],
    [f, g]: [Function; 2],
    arguments: RuleArguments,
) -> Vec<(ExprId, ExprId, Monomial)> {
    let mut found = Vec::new();
    for first in calls.iter().filter(|call| call.function == f) {
        for second in calls.iter().filter(|call| call.function == g) {
            let (x, y) = (first.argument, second.argument);
            let fits = match arguments {
                RuleArguments::Same => x == y && (first.id != second.id || first.exponent > 1),
                // Every rule is symmetric under the exchange of x and y together with their
                // functions.
                RuleArguments::Distinct => x < y,
            };
            if fits {
                let one = Number::ONE;
                found.push((x, y, Monomial::new(vec![(first.id, one.clone()), (second.id, one)])));
            }
        }
    }
    found
}
