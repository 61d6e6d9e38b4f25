//! Taylor polynomials of degree two, jointly in several symbols.
//!
//! Every expression is represented by its value at the point of expansion and its parts of first
//! and second degree in the deviations. The chain rule propagates them from operands to results
//! (truncated power series; Griewank and Walther, *Evaluating Derivatives*, 2nd ed., chapter 13).
//! All other symbols are kept, so the result is exact in them. If all symbols are held, this is
//! substitution.
//!
//! An expression has no expansion where it is undefined at the point or jumps there. At a kink, the
//! expansion is only known to a lower order. A factor that vanishes there raises the known order
//! again: |v| to order 0,
//! |v| v to order 1, |v|³ to order 2.

use crate::calculus::{partials, rebuild, second_partials};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{Dependencies, ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// A polynomial in the deviations.
#[derive(Clone, Copy, Debug)]
pub struct Series {
    /// The parts of degree 0, 1 and 2.
    pub parts: [ExprId; 3],
    /// Their sum; the original expression if nothing had to be omitted.
    pub closed: ExprId,
    /// The degree up to which the parts are known; those of higher degree are zero here.
    order: usize,
    /// True if the original expression depends on a deviation, even if the truncated one does not.
    varies: bool,
}

/// Maximum degree of the expansion.
const HIGHEST: usize = 2;

impl Series {
    fn constant(graph: &mut Graph, value: ExprId) -> Series {
        let zero = graph.number(0);
        Series { parts: [value, zero, zero], closed: value, order: HIGHEST, varies: false }
    }

    /// Creates a series without unknown parts.
    fn new(graph: &mut Graph, mut parts: [ExprId; 3], order: usize) -> Series {
        let (order, zero) = (order.min(HIGHEST), graph.number(0));
        parts.iter_mut().skip(order + 1).for_each(|part| *part = zero);
        Series { parts, closed: graph.total(parts), order, varies: true }
    }

    /// Returns the degree of the polynomial.
    pub fn degree(&self, graph: &Graph) -> usize {
        (1..=HIGHEST).rev().find(|&degree| !graph.is_zero(self.parts[degree])).unwrap_or(0)
    }

    /// Returns the lowest degree in which the expression need not vanish.
    pub fn valuation(&self, graph: &Graph) -> usize {
        (0..=self.order).find(|&degree| !vanishes(graph, self.parts[degree])).unwrap_or(self.order + 1)
    }

    /// Returns the parts up to a degree.
    pub fn up_to(&self, graph: &mut Graph, degree: usize) -> ExprId {
        match self.degree(graph) <= degree {
            true => self.closed,
            false => graph.total(self.parts.iter().take(degree + 1).copied()),
        }
    }

    /// Returns the common part of two expressions that are equal at the point. Degrees in which
    /// they differ are unknown.
    fn common(self, graph: &mut Graph, other: Series) -> Option<Series> {
        let differ = |degree: &usize| {
            let difference = graph.subtract(self.parts[*degree], other.parts[*degree]);
            !vanishes(graph, difference)
        };
        let known = self.order.min(other.order);
        let order = (0..=known).find(differ).unwrap_or(known + 1).checked_sub(1)?;
        Some(Series::new(graph, self.parts, order))
    }
}

/// The expansions of expressions about one point, each computed once.
#[derive(Clone, Default, Debug)]
pub struct Expansion {
    /// Deviations of the symbols that vary.
    deviations: HashMap<ExprId, ExprId>,
    /// Values at the point; `None` if undefined.
    values: HashMap<ExprId, Option<ExprId>>,
    series: HashMap<ExprId, Option<Series>>,
}

impl Expansion {
    /// Holds a symbol at a value.
    pub fn hold(&mut self, symbol: ExprId, value: ExprId) {
        self.values.insert(symbol, Some(value));
    }

    /// Lets a symbol deviate from a value.
    pub fn vary(&mut self, graph: &mut Graph, symbol: ExprId, value: ExprId) {
        self.values.insert(symbol, Some(value));
        self.deviations.insert(symbol, graph.subtract(symbol, value));
    }

    /// Returns the expansion of an expression, if it has one to an order of at most two.
    pub fn of(&mut self, graph: &mut Graph, root: ExprId, order: usize) -> Option<Series> {
        self.value(graph, root);
        for id in graph.reachable_until(&[root], |id| self.series.contains(&id)) {
            if !self.series.contains(&id) {
                let series = self.expand(graph, id);
                self.series.insert(id, series);
            }
        }
        self.known(root).filter(|series| series.order >= order)
    }

    fn known(&self, id: ExprId) -> Option<Series> {
        self.series.get(&id).copied().flatten()
    }

    fn known_value(&self, id: ExprId) -> Option<ExprId> {
        self.values.get(&id).copied().flatten()
    }

    /// Returns the value at the point.
    fn value(&mut self, graph: &mut Graph, root: ExprId) -> Option<ExprId> {
        for id in graph.reachable_until(&[root], |id| self.values.contains(&id)) {
            if !self.values.contains(&id) {
                let value = self.evaluate(graph, id).filter(|&value| is_defined(graph, value));
                self.values.insert(id, value);
            }
        }
        self.known_value(root)
    }

    /// Returns the value of a node after its operands have been evaluated.
    fn evaluate(&self, graph: &mut Graph, id: ExprId) -> Option<ExprId> {
        let node = graph.node(id).clone();
        if let Node::Choose { left, right, then, otherwise, .. } = &node {
            let (left, right) = (self.known_value(*left)?, self.known_value(*right)?);
            // The other branch need not be defined.
            if graph.as_number(left).is_some() && graph.as_number(right).is_some() {
                let [then, otherwise] = [then, otherwise].map(|branch| self.known_value(*branch));
                return if self.holds(graph, &node) { then } else { otherwise };
            }
        }
        let mut is_defined = true;
        node.for_each_child(|child| is_defined &= self.known_value(child).is_some());
        if let Node::Product(factors) = &node {
            let divides_by_zero = |(base, exponent): &(ExprId, Number)| {
                exponent.is_negative() && self.known_value(*base).is_some_and(|base| vanishes(graph, base))
            };
            is_defined &= !factors.iter().any(divides_by_zero);
        }
        is_defined.then(|| rebuild(graph, id, |child| self.known_value(child).unwrap_or(child)))
    }

    /// True if a condition between numbers holds.
    fn holds(&self, graph: &mut Graph, node: &Node) -> bool {
        let Node::Choose { relation, left, right, .. } = node else { return false };
        let (one, zero) = (graph.number(1), graph.number(0));
        let value = |id: &ExprId| self.known_value(*id).unwrap_or(*id);
        let decided = graph.choose(*relation, value(left), value(right), one, zero);
        graph.is_one(decided)
    }

    /// Returns the series of a node after those of its operands.
    fn expand(&mut self, graph: &mut Graph, id: ExprId) -> Option<Series> {
        let value = self.known_value(id)?;
        if let Some(&deviation) = self.deviations.get(&id) {
            let zero = graph.number(0);
            return Some(Series {
                parts: [value, deviation, zero],
                closed: id,
                order: HIGHEST,
                varies: true,
            });
        }
        let mut varies = false;
        let node = graph.node(id).clone();
        node.for_each_child(|child| varies |= self.known(child).is_none_or(|series| series.varies));
        match node {
            _ if !varies => Some(Series::constant(graph, value)),
            Node::Sum { constant, terms } => self.sum(graph, &constant, &terms),
            Node::Product(factors) => self.product(graph, &factors),
            Node::Call(function, arguments) => {
                let series = self.all_known(&arguments)?;
                match at_kink(graph, function, &series) {
                    Some(at_kink) => at_kink,
                    None => self.smooth(graph, id, &series),
                }
            }
            Node::Opaque(_, arguments) => {
                let series = self.all_known(&arguments)?;
                self.smooth(graph, id, &series)
            }
            Node::Choose { .. } => self.choice(graph, &node),
            Node::Number(_) | Node::Pi | Node::Symbol(_) => Some(Series::constant(graph, value)),
        }
    }

    fn sum(&self, graph: &mut Graph, constant: &Number, terms: &[(ExprId, Number)]) -> Option<Series> {
        let series = terms.iter().map(|(term, c)| Some((self.known(*term)?, c.clone())));
        let series = series.collect::<Option<Vec<_>>>()?;
        let mut sum = |constant: &Number, part: fn(&Series) -> ExprId| {
            graph.sum(constant.clone(), series.iter().map(|(series, c)| (part(series), c.clone())))
        };
        let none = &Number::ZERO;
        let parts = [sum(constant, |s| s.parts[0]), sum(none, |s| s.parts[1]), sum(none, |s| s.parts[2])];
        let closed = sum(constant, |s| s.closed);
        let order = series.iter().map(|(series, _)| series.order).min().unwrap_or(HIGHEST);
        match order {
            HIGHEST => Some(Series { parts, closed, order, varies: true }),
            _ => Some(Series::new(graph, parts, order)),
        }
    }

    fn product(&self, graph: &mut Graph, factors: &[(ExprId, Number)]) -> Option<Series> {
        let one = graph.number(1);
        let mut product = Series::constant(graph, one);
        let (mut degree, mut closed) = (0, Vec::new());
        for (base, exponent) in factors {
            let base = self.known(*base)?;
            let power = power(graph, base, exponent)?;
            product = multiply(graph, product, power);
            degree = degree_of_power(graph, base, exponent).saturating_add(degree);
            closed.push((base.closed, exponent.clone()));
        }
        // A polynomial of low degree is not truncated, so squares of sums remain squares.
        if degree <= HIGHEST && product.order == HIGHEST {
            product.closed = graph.product(closed);
        }
        Some(product)
    }

    fn choice(&self, graph: &mut Graph, node: &Node) -> Option<Series> {
        let Node::Choose { relation, left, right, then, otherwise } = node else { return None };
        let (left, right) = (self.known(*left)?, self.known(*right)?);
        let [a, b] = [left, right].map(|side| side.parts[0]);
        let meets = meet(graph, left, right);
        if !meets && graph.as_number(a).is_some() && graph.as_number(b).is_some() {
            return self.known(if self.holds(graph, node) { *then } else { *otherwise });
        }
        let (then, otherwise) = (self.known(*then)?, self.known(*otherwise)?);
        if meets {
            return then.common(graph, otherwise);
        }
        let mut choose = |x: ExprId, y: ExprId| graph.choose(*relation, a, b, x, y);
        let parts = [0, 1, 2].map(|degree| choose(then.parts[degree], otherwise.parts[degree]));
        let closed = choose(then.closed, otherwise.closed);
        Some(Series { parts, closed, order: then.order.min(otherwise.order), varies: true })
    }

    /// Computes f(a + δ) = f(a) + Σ fᵢ δᵢ + ½ Σ fᵢⱼ δᵢ δⱼ.
    fn smooth(&mut self, graph: &mut Graph, id: ExprId, arguments: &[Series]) -> Option<Series> {
        let (mut first, mut second) = (Vec::new(), Vec::new());
        for (operand, slope) in partials(graph, id) {
            let Some(operand) = self.known(operand).filter(|series| series.varies) else { continue };
            let slope = self.value(graph, slope)?;
            first.push(graph.multiply(slope, operand.parts[1]));
            second.push(graph.multiply(slope, operand.parts[2]));
        }
        for (i, j, curvature) in second_partials(graph, id) {
            let [a, b] = [self.known(i)?, self.known(j)?];
            if a.varies && b.varies {
                let curvature = self.value(graph, curvature)?;
                let product = graph.multiply(a.parts[1], b.parts[1]);
                let term = graph.multiply(curvature, product);
                second.push(if i == j { graph.scale(Number::HALF, term) } else { term });
            }
        }
        let parts = [self.known_value(id)?, graph.total(first), graph.total(second)];
        let order = arguments.iter().map(|series| series.order).min().unwrap_or(HIGHEST);
        Some(Series::new(graph, parts, order))
    }

    fn all_known(&self, arguments: &[ExprId]) -> Option<Vec<Series>> {
        arguments.iter().map(|&argument| self.known(argument)).collect()
    }
}

/// Returns aᵉ.
fn power(graph: &mut Graph, base: Series, exponent: &Number) -> Option<Series> {
    let [a, first, second] = base.parts;
    if exponent.is_one() {
        return Some(base);
    }
    if !base.varies {
        let value = graph.power(a, exponent.clone());
        return Some(Series::constant(graph, value));
    }
    if vanishes(graph, a) {
        return power_at_zero(graph, base, exponent);
    }
    let lowered = |by: i64| exponent + &Number::from(-by);
    let (slope, curvature) = (graph.power(a, lowered(1)), graph.power(a, lowered(2)));
    let slope = graph.scale(exponent.clone(), slope);
    let curvature = graph.scale(&(exponent * &lowered(1)) * &Number::HALF, curvature);
    let square = graph.square(first);
    let (straight, bent) = (graph.multiply(slope, second), graph.multiply(curvature, square));
    let parts = [graph.power(a, exponent.clone()), graph.multiply(slope, first), graph.add(straight, bent)];
    Some(Series::new(graph, parts, base.order))
}

/// Returns the power of a base that is zero at the point. If the base grows with at least δᵐ, the
/// power grows with at least δᵐᵉ.
fn power_at_zero(graph: &mut Graph, base: Series, exponent: &Number) -> Option<Series> {
    if *exponent == Number::TWO {
        return Some(multiply(graph, base, base));
    }
    let growth = exponent * &Number::from(base.valuation(graph) as i64);
    let order = (0..=HIGHEST).rev().find(|&order| Number::from(order as i64) < growth)?;
    let zero = graph.number(0);
    Some(Series::new(graph, [zero; 3], order))
}

fn multiply(graph: &mut Graph, a: Series, b: Series) -> Series {
    let mut part = |pairs: &[(usize, usize)]| {
        let products = pairs.iter().map(|&(i, j)| graph.multiply(a.parts[i], b.parts[j]));
        let products = products.collect::<Vec<_>>();
        graph.total(products)
    };
    let parts = [part(&[(0, 0)]), part(&[(0, 1), (1, 0)]), part(&[(0, 2), (1, 1), (2, 0)])];
    let order = (a.order + b.valuation(graph)).min(b.order + a.valuation(graph));
    Series { varies: a.varies || b.varies, ..Series::new(graph, parts, order) }
}

/// Returns the degree of a power before truncation; more than two if it is not a polynomial.
fn degree_of_power(graph: &Graph, base: Series, exponent: &Number) -> usize {
    match (base.degree(graph), exponent.to_i32().map(usize::try_from)) {
        (0, _) => 0,
        (degree, Some(Ok(exponent))) => degree.saturating_mul(exponent),
        _ => usize::MAX,
    }
}

/// Returns the series of a function at a kink or jump, if the values of the arguments are at one.
fn at_kink(graph: &mut Graph, function: Function, arguments: &[Series]) -> Option<Option<Series>> {
    match (function, arguments) {
        (Function::Sign | Function::MagnitudeSlope, [argument]) if vanishes(graph, argument.parts[0]) => {
            Some(None)
        }
        (Function::Abs, [argument]) if vanishes(graph, argument.parts[0]) => {
            Some(power_at_zero(graph, *argument, &Number::ONE))
        }
        (Function::Min | Function::Max, [a, b]) if meet(graph, *a, *b) => Some(a.common(graph, *b)),
        _ => None,
    }
}

/// True if both sides of a comparison are equal at the point and at least one of them varies.
fn meet(graph: &mut Graph, left: Series, right: Series) -> bool {
    let difference = graph.subtract(left.parts[0], right.parts[0]);
    (left.varies || right.varies) && vanishes(graph, difference)
}

/// True if a value is zero for all values of the symbols.
fn vanishes(graph: &Graph, value: ExprId) -> bool {
    let is_number = graph.dependencies(value) == Dependencies::NONE;
    graph.is_zero(value) || is_number && evaluate(graph, &[value], |_| f64::NAN)[0] == 0.0
}

/// True if a value without symbols is a number.
fn is_defined(graph: &Graph, value: ExprId) -> bool {
    let is_written_out = graph.as_number(value).is_some();
    is_written_out
        || graph.dependencies(value) != Dependencies::NONE
        || evaluate(graph, &[value], |_| f64::NAN)[0].is_finite()
}

#[cfg(test)]
mod tests;
