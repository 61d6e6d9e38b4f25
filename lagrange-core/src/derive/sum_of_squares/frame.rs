//! Back substitution in the frame of the direction in which a rod moves its end.

use std::collections::BTreeMap;

use super::composition::AffineExpansion;
use super::square::{Carried, Carriers};
use crate::derive::algebra::{Algebra, LinearForm};
use lagrange_algebra::simplify;
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;

/// Two carriers that the unknown moves along a unit vector t, such as the end of a rod.
///
/// In the frame of t, y = tangential·t + normal·(−t₁, t₀), and only the tangential component is
/// free. It follows from D·tangential = −Σ wᵢ aᵢ eᵢ · normal − load, where eᵢ are the coefficients
/// of the squares along the normal. Unlike Cartesian components, neither is a small difference of
/// large numbers.
pub(super) struct Frame {
    pub(super) carriers: [(ExprId, AffineExpansion); 2],
    /// Σ wᵢ aᵢ eᵢ / D
    pub(super) bend: ExprId,
}

/// Finds the frame in which to write the accelerations of two carriers, if the unknown moves them
/// along a unit vector.
pub(super) fn frame(
    carriers: &Carriers,
    algebra: &mut Algebra<'_>,
    squares: &[Carried],
    pivot: ExprId,
) -> Option<Frame> {
    let ([x, y], [a, b]) = (carriers.ids.as_slice(), carriers.expansions.as_slice()) else { return None };
    let length = [a, b].map(|e| (e.slope, e.slope, Number::ONE));
    let length = algebra.products(&length);
    // Without a unit vector there is no frame to rotate into, and variables other than the carriers
    // have no components in it.
    if !algebra.graph.is_one(length) || squares.iter().any(|square| !square.others.is_empty()) {
        return None;
    }
    let arms = squares.iter().map(|square| {
        let along_normal = algebra.products(&[
            (a.slope, square.carriers[1], Number::ONE),
            (b.slope, square.carriers[0], Number::MINUS_ONE),
        ]);
        (square.weight, square.arm, along_normal, Number::ONE)
    });
    let arms = arms.collect::<Vec<_>>();
    let arm = algebra.weighted(&arms);
    let bend = simplify::quotient(algebra.graph, arm, pivot);
    Some(Frame { carriers: [(*x, a.clone()), (*y, b.clone())], bend })
}

impl Frame {
    /// Returns the unknown as −Σ factor · variable, without drift and load: the tangential
    /// component less t·y′.
    pub(super) fn factors(&self, algebra: &mut Algebra<'_>) -> LinearForm {
        let [(_, a), (_, b)] = &self.carriers;
        let mut form: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
        for (this, other, sign) in [(a, b, Number::MINUS_ONE), (b, a, Number::ONE)] {
            let turned = algebra.graph.multiply(self.bend, other.slope);
            let direction = algebra.total(vec![(this.slope, Number::ONE), (turned, sign)]);
            for &(part, slope) in &this.rest {
                form.entry(part).or_default().push((direction, slope, Number::ONE));
            }
        }
        algebra.form_of_products(form)
    }
}
