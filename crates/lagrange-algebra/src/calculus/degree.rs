//! Dependence of expressions on the velocities, or on symbols of another kind: none, affine, or
//! nonlinear.

use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// Dependence on the velocities or on symbols of another kind.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Degree {
    /// Contains none of them.
    Free,
    /// A linear combination of them with coefficients free of them, plus a term free of them.
    Affine,
    /// Anything else.
    Nonlinear,
}

/// The degrees of expressions, each computed once.
#[derive(Debug)]
pub struct Degrees {
    kinds: Dependencies,
    /// Kinds of symbols that coefficients of affine expressions must not contain.
    excluded: Dependencies,
    known: HashMap<ExprId, Degree>,
}

/// Degrees in the velocities.
impl Default for Degrees {
    fn default() -> Degrees {
        Degrees::in_terms_of(Dependencies::VELOCITY)
    }
}

impl Degrees {
    /// Creates degrees in the symbols of these kinds.
    pub fn in_terms_of(kinds: Dependencies) -> Degrees {
        Degrees { kinds, excluded: Dependencies::NONE, known: HashMap::default() }
    }

    /// Excludes kinds of symbols from the coefficients of affine expressions.
    pub fn with_coefficients_free_of(self, excluded: Dependencies) -> Degrees {
        Degrees { excluded, ..self }
    }

    /// Determines the degree of all parts of `roots`.
    pub fn classify(&mut self, graph: &Graph, roots: &[ExprId]) {
        for id in graph.reachable_until(roots, |id| self.known.contains(&id)) {
            if !self.known.contains(&id) {
                let degree = self.derive(graph, id);
                self.known.insert(id, degree);
            }
        }
    }

    /// Returns the degree of a classified expression; expressions free of the symbols need not be
    /// classified.
    pub fn of(&self, graph: &Graph, id: ExprId) -> Degree {
        if !graph.dependencies(id).intersects(self.kinds) {
            return Degree::Free;
        }
        self.known.get(&id).copied().unwrap_or(Degree::Nonlinear)
    }

    fn derive(&self, graph: &Graph, id: ExprId) -> Degree {
        let of = |child: &ExprId| self.of(graph, *child);
        match graph.node(id) {
            _ if !graph.dependencies(id).intersects(self.kinds) => Degree::Free,
            Node::Symbol(_) => Degree::Affine,
            Node::Sum { terms, .. } => terms.iter().map(|(term, _)| of(term)).max().unwrap_or(Degree::Free),
            Node::Product(factors) => {
                let mut moving = factors.iter().filter(|(base, _)| of(base) != Degree::Free);
                match (moving.next(), moving.next()) {
                    (Some((base, exponent)), None) if *exponent == Number::ONE => {
                        let mut fixed = factors.iter().filter(|(other, _)| other != base);
                        match fixed.all(|(other, _)| self.may_be_coefficient(graph, *other)) {
                            true => of(base),
                            false => Degree::Nonlinear,
                        }
                    }
                    _ => Degree::Nonlinear,
                }
            }
            Node::Choose { left, right, then, otherwise, .. } => match of(left).max(of(right)) {
                Degree::Free if [left, right].iter().all(|side| self.may_be_coefficient(graph, **side)) => {
                    of(then).max(of(otherwise))
                }
                _ => Degree::Nonlinear,
            },
            _ => Degree::Nonlinear,
        }
    }

    fn may_be_coefficient(&self, graph: &Graph, id: ExprId) -> bool {
        !graph.dependencies(id).intersects(self.excluded)
    }
}

/// Returns the degree k in which an expression is homogeneous in the velocities. It becomes sᵏ
/// times itself when all velocities are multiplied by s. `None` if it is not homogeneous, or not
/// recognisably so.
pub fn homogeneity(graph: &Graph, root: ExprId) -> Option<i64> {
    let mut known: HashMap<ExprId, Option<i64>> = HashMap::default();
    for id in graph.reachable_until(&[root], |id| !depends_on_velocities(graph, id)) {
        let of = |id: &ExprId| known.get(id).copied().flatten();
        let degree = match graph.node(id) {
            _ if !depends_on_velocities(graph, id) => Some(0),
            Node::Symbol(_) => Some(1),
            Node::Sum { constant, terms } => {
                let first = of(&terms[0].0);
                let same = constant.is_zero() && terms.iter().all(|(term, _)| of(term) == first);
                first.filter(|_| same)
            }
            Node::Product(factors) => factors.iter().try_fold(0, |degree, (base, exponent)| {
                let base = of(base)?;
                if base == 0 {
                    return Some(degree);
                }
                base.checked_mul(i64::from(exponent.to_i32()?))?.checked_add(degree)
            }),
            _ => None,
        };
        known.insert(id, degree);
    }
    known.get(&root).copied().flatten()
}

/// Returns the degree of an expression as a polynomial in symbols of these kinds; `None` if it is
/// not a polynomial, or not recognisably one.
pub fn polynomial_degree(graph: &Graph, root: ExprId, kinds: Dependencies) -> Option<i64> {
    let is_free = |id: ExprId| !graph.dependencies(id).intersects(kinds);
    let mut known: HashMap<ExprId, Option<i64>> = HashMap::default();
    for id in graph.reachable_until(&[root], is_free) {
        let of = |id: &ExprId| known.get(id).copied().flatten();
        let degree = match graph.node(id) {
            _ if is_free(id) => Some(0),
            Node::Symbol(_) => Some(1),
            Node::Sum { terms, .. } => {
                terms.iter().try_fold(0, |degree, (term, _)| Some(of(term)?.max(degree)))
            }
            Node::Product(factors) => factors.iter().try_fold(0, |degree, (base, exponent)| {
                let base = of(base)?;
                if base == 0 {
                    return Some(degree);
                }
                let exponent = exponent.to_i32().filter(|exponent| *exponent > 0)?;
                base.checked_mul(i64::from(exponent))?.checked_add(degree)
            }),
            Node::Choose { left, right, then, otherwise, .. } => {
                let is_decided = of(left)? == 0 && of(right)? == 0;
                is_decided.then_some(of(then)?.max(of(otherwise)?))
            }
            _ => None,
        };
        known.insert(id, degree);
    }
    known.get(&root).copied().flatten()
}

fn depends_on_velocities(graph: &Graph, id: ExprId) -> bool {
    graph.dependencies(id).intersects(Dependencies::VELOCITY)
}
