//! Expansion within a budget.
//!
//! Expressions are processed in ascending order, so their parts are known beforehand. Arguments of
//! functions, bases of roots and of denominators stay closed, but are themselves written in the
//! form of [`Expander::readable`]. Parts that exceed the budget also stay closed.

use std::rc::Rc;

use super::effort::Effort;
use super::group::{gather_waves, group};
use super::monomial::Term;
use super::pairs::join;
use super::polynomial::Polynomial;
use super::rules::{RULES, Rule, squares};
use super::waves;
use crate::calculus::substitute;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

/// Maximum exponent of expanded powers of sums: (a + b + c)⁸ has 45 monomials, and readers would
/// already prefer the power.
const HIGHEST_POWER: i32 = 8;

/// Purpose of a result.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Short formulas.
    Reading,
    /// Equal values in as few different forms as possible.
    Comparing,
    /// Few operations, without losing digits that the original expression keeps.
    Computing,
}

/// Polynomials of expressions, each computed once.
pub(super) struct Expander {
    purpose: Purpose,
    effort: Effort,
    expanded: HashMap<ExprId, Rc<Polynomial>>,
    readable: HashMap<ExprId, ExprId>,
}

impl Expander {
    pub(super) fn new(purpose: Purpose, budget: usize) -> Expander {
        Expander::with_effort(purpose, Effort::new(budget))
    }

    /// Creates an empty expander with the remaining readings of this one.
    pub(super) fn again(&self) -> Expander {
        Expander::with_effort(self.purpose, self.effort.again())
    }

    fn with_effort(purpose: Purpose, effort: Effort) -> Expander {
        Expander { purpose, effort, expanded: HashMap::default(), readable: HashMap::default() }
    }

    /// Expands all parts of `root`, unless this alone would consume all effort.
    pub(super) fn expand_all(&mut self, graph: &mut Graph, root: ExprId) -> Option<()> {
        let mut parts = graph.reachable(&[root]);
        parts.retain(|id| !self.expanded.contains(id));
        self.effort.spend(parts.len())?;
        for id in parts {
            let polynomial = match self.expand(graph, id) {
                Some(polynomial) => polynomial,
                None => self.closed(graph, id),
            };
            self.expanded.insert(id, Rc::new(polynomial));
            if self.purpose == Purpose::Reading {
                self.readable(graph, id);
            }
        }
        Some(())
    }

    /// Returns the polynomial of an expanded expression.
    pub(super) fn polynomial(&self, graph: &Graph, id: ExprId) -> Rc<Polynomial> {
        self.expanded.get(&id).cloned().unwrap_or_else(|| Rc::new(Polynomial::atom(graph, id)))
    }

    /// Applies identities to a polynomial: every rule for reading; for comparing, powers of sines
    /// and hyperbolic sines are replaced.
    pub(super) fn simplified(&mut self, graph: &mut Graph, polynomial: &Polynomial) -> Option<Polynomial> {
        match self.purpose {
            Purpose::Reading => apply_rules(graph, &RULES, polynomial, |readings| self.effort.read(readings)),
            // Sums of angles would need an additional sine or cosine.
            Purpose::Computing => apply_rules(graph, squares(), polynomial, |_| Some(())),
            Purpose::Comparing => waves::reduce(&mut self.effort, graph, polynomial),
        }
    }

    /// Returns the shortest known form of an expanded expression.
    pub(super) fn readable(&mut self, graph: &mut Graph, id: ExprId) -> ExprId {
        if let Some(&known) = self.readable.get(&id) {
            return known;
        }
        let form = match self.purpose {
            Purpose::Comparing => self.grouped(graph, id).unwrap_or(id),
            Purpose::Computing => id,
            Purpose::Reading => {
                let as_it_is = self.with_readable_parts(graph, id);
                let grouped = self.grouped(graph, id).unwrap_or(as_it_is);
                let is_short = graph.written_size(grouped) <= graph.written_size(as_it_is);
                if is_short { grouped } else { as_it_is }
            }
        };
        self.readable.insert(id, form);
        form
    }

    /// Simplifies and regroups a polynomial, if the remaining effort allows it.
    pub(super) fn grouped(&mut self, graph: &mut Graph, id: ExprId) -> Option<ExprId> {
        let polynomial = self.polynomial(graph, id);
        self.effort.spend(polynomial.len())?;
        let mut simplified = self.simplified(graph, &polynomial)?;
        if self.purpose == Purpose::Computing {
            simplified = gather_waves(graph, &simplified);
        }
        Some(group(graph, &simplified))
    }

    fn closed(&mut self, graph: &mut Graph, id: ExprId) -> Polynomial {
        let atom = self.with_readable_parts(graph, id);
        Polynomial::atom(graph, atom)
    }

    fn with_readable_parts(&mut self, graph: &mut Graph, id: ExprId) -> ExprId {
        let mut parts = Vec::new();
        graph.node(id).for_each_child(|child| parts.push(child));
        let forms = parts.into_iter().map(|part| (part, self.readable(graph, part))).collect::<Vec<_>>();
        if forms.iter().all(|(part, form)| part == form) {
            return id;
        }
        substitute(graph, id, &forms.into_iter().collect())
    }

    fn expand(&mut self, graph: &mut Graph, id: ExprId) -> Option<Polynomial> {
        match graph.node(id).clone() {
            Node::Number(value) => Some(Polynomial::constant(value)),
            Node::Pi | Node::Symbol(_) => Some(Polynomial::atom(graph, id)),
            Node::Sum { terms, .. } if self.purpose == Purpose::Computing && is_difference(graph, &terms) => {
                Some(Polynomial::atom(graph, id))
            }
            Node::Sum { constant, terms } => self.expand_sum(graph, constant, &terms),
            Node::Product(factors) => {
                let mut product = Polynomial::constant(Number::ONE);
                for (base, exponent) in &factors {
                    let power = self.expand_power(graph, *base, exponent)?;
                    product = self.effort.times(&product, &power)?;
                }
                Some(product)
            }
            Node::Call(function @ (Function::Sin | Function::Cos), arguments)
                if self.purpose == Purpose::Comparing =>
            {
                let angle = self.polynomial(graph, arguments[0]);
                waves::expand(&mut self.effort, graph, function, &angle)
            }
            Node::Call(function, arguments) => {
                let arguments = arguments.iter().map(|x| self.readable(graph, *x)).collect::<Vec<_>>();
                let call = apply(graph, function, &arguments);
                Some(Polynomial::atom(graph, call))
            }
            Node::Opaque(function, arguments) => {
                let arguments = arguments.iter().map(|x| self.readable(graph, *x)).collect::<Vec<_>>();
                let call = graph.opaque(function, &arguments);
                Some(Polynomial::atom(graph, call))
            }
            Node::Choose { .. } => Some(self.closed(graph, id)),
        }
    }

    fn expand_sum(
        &mut self,
        graph: &Graph,
        constant: Number,
        terms: &[(ExprId, Number)],
    ) -> Option<Polynomial> {
        let mut sum = Polynomial::constant(constant);
        for (term, coefficient) in terms {
            let term = self.polynomial(graph, *term);
            self.effort.spend(term.len())?;
            sum.add_scaled(&term, coefficient);
        }
        self.effort.within_budget(sum)
    }

    fn expand_power(&mut self, graph: &mut Graph, base: ExprId, exponent: &Number) -> Option<Polynomial> {
        let polynomial = self.polynomial(graph, base);
        let integer = exponent.to_i32();
        if let (Some((monomial, coefficient)), Some(integer)) = (polynomial.single(), integer)
            && let Some(coefficient) = coefficient.power(integer)
        {
            return Some(Polynomial::of_terms([Term { coefficient, monomial: monomial.power(exponent) }]));
        }
        match integer {
            Some(integer @ 0..=HIGHEST_POWER) => {
                let one = Polynomial::constant(Number::ONE);
                (0..integer).try_fold(one, |power, _| self.effort.times(&power, &polynomial))
            }
            _ => {
                let base = self.readable(graph, base);
                let power = graph.power(base, exponent.clone());
                Some(Polynomial::atom(graph, power))
            }
        }
    }
}

/// True if a sum contains a difference of symbols or of products of symbols, such as the length of
/// a spring and its rest length. If expanded, it would have rounding errors where the difference of
/// close numbers is exact.
pub(super) fn is_difference(graph: &Graph, terms: &[(ExprId, Number)]) -> bool {
    let is_symbol = |id: ExprId| matches!(graph.node(id), Node::Symbol(_));
    let is_plain = |id: ExprId| match graph.node(id) {
        Node::Product(factors) => factors.iter().all(|(base, _)| is_symbol(*base)),
        _ => is_symbol(id),
    };
    let is_negative = |(_, coefficient): &(ExprId, Number)| coefficient.is_negative();
    terms.iter().all(|(term, _)| is_plain(*term)) && terms.iter().any(is_negative)
}

/// Applies the rules and collects equal terms until neither changes anything.
fn apply_rules(
    graph: &mut Graph,
    rules: &[Rule],
    polynomial: &Polynomial,
    mut spend: impl FnMut(usize) -> Option<()>,
) -> Option<Polynomial> {
    let mut polynomial = polynomial.clone();
    loop {
        let before = polynomial.len();
        let joined = join(graph, rules, polynomial.terms(), &mut spend)?;
        polynomial = Polynomial::of_terms(joined.into_iter().map(|joined| joined.term));
        if polynomial.len() == before {
            return Some(polynomial);
        }
    }
}
