//! Sums of products, as they arise in eliminations.

use std::collections::BTreeMap;

use lagrange_algebra::simplify::{self, Angles};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Σ slope · variable, in ascending order of variables.
pub(super) type LinearForm = Vec<(ExprId, ExprId)>;

/// Maximum number of terms of a product of two sums that is expanded on trial, such as four by
/// four. A trial costs as much as its result.
const MAX_OPENED: usize = 16;
/// Maximum depth of counting factors. The count only decides between two ways of writing a sum, so
/// it must not traverse the whole graph.
const DEEPEST_COUNTED: usize = 4;

/// The graph, with simplified sums: equal products are combined, and so are squares of sine and
/// cosine. Products of sines and cosines are rewritten in sums and differences of angles if this
/// leaves fewer terms to cancel.
pub(super) struct Algebra<'g> {
    pub(super) graph: &'g mut Graph,
    angles: Angles,
    /// Pivots whose vanishing is tested by the conditions that [`super::sum_of_squares`] inserts.
    pub(super) guards: Vec<ExprId>,
}

impl<'g> Algebra<'g> {
    pub(super) fn new(graph: &'g mut Graph) -> Algebra<'g> {
        Algebra { graph, angles: Angles::default(), guards: Vec::new() }
    }

    /// Returns `Σ coefficient · term`.
    pub(super) fn total(&mut self, terms: Vec<(ExprId, Number)>) -> ExprId {
        let mut flat = Vec::with_capacity(terms.len());
        for (term, coefficient) in terms {
            self.flatten(term, &coefficient, &mut flat);
        }
        self.simplified(flat)
    }

    pub(super) fn simplified(&mut self, terms: Vec<(ExprId, Number)>) -> ExprId {
        let collected = simplify::collect(self.graph, terms);
        let terms = self.terms_of(collected);
        if terms.len() < 2 {
            return collected;
        }
        simplify::contract(self.graph, &mut self.angles, terms)
    }

    /// Returns the terms of a sum, including the constant; any other expression is a single term.
    pub(super) fn terms_of(&mut self, id: ExprId) -> Vec<(ExprId, Number)> {
        let (scale, core) = self.graph.split_coefficient(id);
        let Node::Sum { constant, terms } = self.graph.node(core).clone() else { return vec![(core, scale)] };
        let mut terms = terms.into_iter().map(|(term, c)| (term, &c * &scale)).collect::<Vec<_>>();
        if !constant.is_zero() {
            terms.push((self.graph.number(1), &constant * &scale));
        }
        terms
    }

    /// Appends the terms of a sum; any other expression is appended as it is.
    fn flatten(&self, id: ExprId, scale: &Number, flat: &mut Vec<(ExprId, Number)>) {
        let (coefficient, core) = self.graph.split_coefficient(id);
        let scale = &coefficient * scale;
        match self.graph.node(core) {
            Node::Sum { constant, terms } if constant.is_zero() => {
                flat.extend(terms.iter().map(|(term, c)| (*term, c * &scale)));
            }
            _ => flat.push((core, scale)),
        }
    }

    /// Returns `Σ scale · a · b`, expanded if that leaves fewer terms.
    pub(super) fn products(&mut self, products: &[(ExprId, ExprId, Number)]) -> ExprId {
        let (mut closed, mut opened) = (Vec::new(), Vec::new());
        for (a, b, scale) in products {
            closed.push((self.graph.multiply(*a, *b), scale.clone()));
            self.multiply_out(*a, *b, scale, &mut opened);
        }
        let is_the_same = opened.len() == closed.len();
        let closed = self.simplified(closed);
        // A single term has nothing to cancel with.
        if is_the_same || self.terms(closed) < 2 {
            return closed;
        }
        let before = opened.len();
        let opened = self.simplified(opened);
        // An expanded product no longer shares its factors with other sums, so expansion pays off
        // only if terms cancel.
        let has_shrunk = self.terms(opened) < before;
        let is_short = self.terms(opened) <= self.terms(closed)
            || self.factors(opened, DEEPEST_COUNTED) < self.factors(closed, DEEPEST_COUNTED);
        if has_shrunk && is_short { opened } else { closed }
    }

    /// Counts the factors in all terms, down to a depth.
    fn factors(&self, id: ExprId, depth: usize) -> usize {
        match self.graph.node(id) {
            Node::Sum { terms, .. } if depth > 0 => {
                terms.iter().map(|(term, _)| self.factors(*term, depth - 1)).sum()
            }
            Node::Product(factors) if depth > 0 => {
                factors.iter().map(|(base, _)| self.factors(*base, depth - 1)).sum()
            }
            _ => 1,
        }
    }

    fn multiply_out(&mut self, a: ExprId, b: ExprId, scale: &Number, terms: &mut Vec<(ExprId, Number)>) {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        self.flatten(a, scale, &mut left);
        self.flatten(b, &Number::ONE, &mut right);
        // Most terms of so long a product will not cancel; as a single term it stays shared.
        if left.len() * right.len() > MAX_OPENED {
            terms.push((self.graph.multiply(a, b), scale.clone()));
            return;
        }
        for (a, c) in &left {
            for (b, d) in &right {
                terms.push((self.graph.multiply(*a, *b), c * d));
            }
        }
    }

    /// Returns the number of terms of a sum. Zero has none, any other expression has one.
    pub(super) fn terms(&self, id: ExprId) -> usize {
        let (_, core) = self.graph.split_coefficient(id);
        match self.graph.node(core) {
            Node::Number(value) if value.is_zero() => 0,
            Node::Sum { constant, terms } => terms.len() + usize::from(!constant.is_zero()),
            _ => 1,
        }
    }

    /// Returns `Σ weight · a · b`. Products with equal weights are added up first, because terms
    /// cancel among these.
    pub(super) fn weighted(&mut self, products: &[(ExprId, ExprId, ExprId, Number)]) -> ExprId {
        let mut groups: OrderedMap<ExprId, Vec<(ExprId, ExprId, Number)>> = OrderedMap::default();
        for (weight, a, b, scale) in products {
            groups.get_or_insert_with(*weight, Vec::new).push((*a, *b, scale.clone()));
        }
        let mut terms = Vec::new();
        for (weight, products) in groups.iter() {
            if let [(a, b, scale)] = products.as_slice() {
                // Other sums share the product of weight and `a`.
                let weighted = self.graph.multiply(*weight, *a);
                terms.push((self.graph.multiply(weighted, *b), scale.clone()));
                continue;
            }
            let sum = self.products(products);
            terms.push((self.graph.multiply(*weight, sum), Number::ONE));
        }
        self.total(terms)
    }

    /// Factors out of a sum what all its terms have in common.
    pub(super) fn factored(&mut self, id: ExprId) -> ExprId {
        let Node::Sum { constant, terms } = self.graph.node(id).clone() else { return id };
        if !constant.is_zero() || terms.len() < 2 {
            return id;
        }
        let terms = terms.iter().map(|(term, c)| self.graph.scale(c.clone(), *term)).collect::<Vec<_>>();
        let (common, rest) = simplify::content(self.graph, &terms);
        let rest = self.graph.total(rest);
        self.graph.multiply(common, rest)
    }

    /// Splits a form into the common factor of its coefficients and the remaining form.
    pub(super) fn primitive(&mut self, form: &LinearForm) -> (ExprId, LinearForm) {
        let coefficients = form.iter().map(|(_, coefficient)| *coefficient).collect::<Vec<_>>();
        let (content, rest) = simplify::content(self.graph, &coefficients);
        (content, form.iter().zip(rest).map(|((id, _), coefficient)| (*id, coefficient)).collect())
    }

    /// Returns the form with these sums of products as coefficients, without those that vanish.
    pub(super) fn form_of_products(
        &mut self,
        sums: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>>,
    ) -> LinearForm {
        let mut form = Vec::with_capacity(sums.len());
        for (variable, products) in sums {
            let coefficient = self.products(&products);
            if !self.graph.is_zero(coefficient) {
                form.push((variable, coefficient));
            }
        }
        form
    }

    /// Returns the form with these sums as coefficients, without those that vanish.
    pub(super) fn linear_form(&mut self, sums: BTreeMap<ExprId, Vec<(ExprId, Number)>>) -> LinearForm {
        let mut form = Vec::with_capacity(sums.len());
        for (variable, terms) in sums {
            let coefficient = self.total(terms);
            if !self.graph.is_zero(coefficient) {
                form.push((variable, coefficient));
            }
        }
        form
    }
}
