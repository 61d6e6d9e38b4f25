//! Squares that contain an unknown through variables, and the minors that remain when it is
//! eliminated.

use std::collections::BTreeMap;

use super::composition::AffineExpansion;
use crate::derive::algebra::{Algebra, LinearForm};
use lagrange_algebra::simplify;
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;

/// ½ weight·r² + linear·r with r = form.
#[derive(Clone, Debug)]
pub(super) struct Square {
    pub(super) weight: ExprId,
    pub(super) linear: ExprId,
    pub(super) form: LinearForm,
}

/// A square that contains the unknown through its carriers.
#[derive(Clone, Debug)]
pub(super) struct Carried {
    pub(super) weight: ExprId,
    pub(super) linear: ExprId,
    /// The coefficient aᵢ of the unknown.
    pub(super) arm: ExprId,
    /// Jᵢₖ for the carriers.
    pub(super) carriers: Vec<ExprId>,
    /// The other variables.
    pub(super) others: LinearForm,
}

/// The variables through which squares contain the unknown: y_k = t_k x + y′_k.
#[derive(Debug)]
pub(super) struct Carriers {
    pub(super) ids: Vec<ExprId>,
    pub(super) expansions: Vec<AffineExpansion>,
    /// t_k y′_l − t_l y′_k for k < l.
    pub(super) minors: Vec<Minor>,
}

/// `content` times a form and its drift.
#[derive(Debug)]
pub(super) struct Minor {
    pub(super) pair: (usize, usize),
    pub(super) content: ExprId,
    pub(super) form: LinearForm,
    pub(super) drift: ExprId,
}

impl Carriers {
    pub(super) fn new(
        algebra: &mut Algebra<'_>,
        ids: Vec<ExprId>,
        expansions: Vec<AffineExpansion>,
    ) -> Carriers {
        let mut minors = Vec::new();
        for (l, b) in expansions.iter().enumerate() {
            for (k, a) in expansions[..l].iter().enumerate() {
                let minor = minor(algebra, (k, l), a, b);
                let is_nothing = minor.form.is_empty() && algebra.graph.is_zero(minor.drift);
                minors.extend((!is_nothing).then_some(minor));
            }
        }
        Carriers { ids, expansions, minors }
    }

    /// Splits the form of a square into carriers and others.
    pub(super) fn carry(&self, algebra: &mut Algebra<'_>, square: Square) -> Carried {
        let zero = algebra.graph.number(0);
        let mut carriers = vec![zero; self.ids.len()];
        let mut others = Vec::new();
        let mut arm = Vec::new();
        for (variable, coefficient) in square.form {
            match self.ids.iter().position(|&id| id == variable) {
                Some(k) => {
                    carriers[k] = coefficient;
                    arm.push((coefficient, self.expansions[k].slope, Number::ONE));
                }
                None => others.push((variable, coefficient)),
            }
        }
        let arm = algebra.products(&arm);
        Carried { weight: square.weight, linear: square.linear, arm, carriers, others }
    }

    /// Writes a square in the variables that remain without the unknown.
    pub(super) fn without_unknown(&self, algebra: &mut Algebra<'_>, square: &Carried) -> Square {
        let one = algebra.graph.number(1);
        let mut form: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
        let mut drifts = Vec::new();
        for (&coefficient, expansion) in square.carriers.iter().zip(&self.expansions) {
            for &(part, slope) in &expansion.rest {
                form.entry(part).or_default().push((coefficient, slope, Number::ONE));
            }
            drifts.push((coefficient, expansion.drift, Number::ONE));
        }
        for &(variable, coefficient) in &square.others {
            form.entry(variable).or_default().push((coefficient, one, Number::ONE));
        }
        let drift = algebra.products(&drifts);
        let drift = algebra.graph.multiply(square.weight, drift);
        let linear = algebra.graph.add(square.linear, drift);
        Square { weight: square.weight, linear, form: algebra.form_of_products(form) }
    }
}

/// Computes t_k y′_l − t_l y′_k.
fn minor(algebra: &mut Algebra<'_>, pair: (usize, usize), a: &AffineExpansion, b: &AffineExpansion) -> Minor {
    let mut slopes: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
    for &(part, slope) in &b.rest {
        slopes.entry(part).or_default().push((a.slope, slope, Number::ONE));
    }
    for &(part, slope) in &a.rest {
        slopes.entry(part).or_default().push((b.slope, slope, Number::MINUS_ONE));
    }
    let drift = algebra.products(&[(a.slope, b.drift, Number::ONE), (b.slope, a.drift, Number::MINUS_ONE)]);
    let form = algebra.form_of_products(slopes);
    let (content, primitive) = algebra.primitive(&form);
    match simplify::safe_quotient(algebra.graph, drift, content) {
        Some(drift) => Minor { pair, content, form: primitive, drift },
        None => Minor { pair, content: algebra.graph.number(1), form, drift },
    }
}
