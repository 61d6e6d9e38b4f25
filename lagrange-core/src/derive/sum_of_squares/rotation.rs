//! Elimination of one unknown from a sum of squares.
//!
//! Let rᵢ = aᵢ x + pᵢ. A sum of squares Σ ½ wᵢ rᵢ² is minimal over x where D x = −Σ wᵢ aᵢ pᵢ, with
//! D = Σ wᵢ aᵢ². By Lagrange's identity, the remainder is again a sum of squares
//!
//! ```text
//! Σ wᵢ pᵢ² − (Σ wᵢ aᵢ pᵢ)² / D = Σ_{i<j} (wᵢ wⱼ / D) (aᵢ pⱼ − aⱼ pᵢ)².
//! ```
//!
//! In numbers, take ½ · 1 · (x + 3)² + ½ · 2 · (x + 6)². The pivot is D = 1 + 2 = 3, and the
//! minimum is at x = −(3 + 12)/3 = −5. The remainder is ½ · (1 · 2/3) · (1 · 6 − 1 · 3)² = 3.
//! Inserting −5 in the squares gives the same: ½ · 4 + ½ · 2 · 1.
//!
//! Applied to two squares at a time, this is a Givens rotation without square roots: one square
//! keeps x and the other loses it. See Gentleman, "Least squares computations by Givens
//! transformations without square roots", J. Inst. Math. Appl. 12 (1973), 329–336. Unlike in a
//! Schur complement, no difference of squares occurs, and only the square root of the condition
//! number of the mass matrix enters.
//!
//! Often x enters through variables y_k = t_k x + y′_k, as the angle of a rod does through the
//! velocity of its end. With rᵢ = Σ Jᵢₖ y_k, then
//!
//! ```text
//! aᵢ pⱼ − aⱼ pᵢ = Σ_{k<l} (Jᵢₖ Jⱼₗ − Jᵢₗ Jⱼₖ) (t_k y′_l − t_l y′_k),
//! ```
//!
//! so that the remainder depends on the y′ only by the *minors* t_k y′_l − t_l y′_k. A rod between
//! two points has a single one: the acceleration of its end across it.

use std::collections::BTreeMap;

use super::guard::Guard;
use super::square::{Carried, Carriers, Minor, Square};
use crate::derive::algebra::{Algebra, LinearForm};
use lagrange_algebra::simplify::{self, never_vanishes};
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;

/// Maximum product of the numbers of squares and variables for pairwise rotations. Every rotation
/// may fill in all variables. Many squares of many variables therefore cost far more than the mass
/// matrix that they represent.
const LARGEST_ROTATION: usize = 1000;

/// Dependence of the unknown on the rest: pivot · x = −Σ numerator · y′ − Σ others − load.
#[derive(Debug)]
pub(super) struct Pull {
    /// The pivot D.
    pub(super) pivot: ExprId,
    /// Σ wᵢ aᵢ Jᵢₖ for the carriers.
    carriers: Vec<ExprId>,
    /// Σ wᵢ aᵢ times the coefficients of other variables.
    others: LinearForm,
    /// Σ wᵢ aᵢ (Jᵢ·drift)
    pub(super) drifting: ExprId,
    /// Σ aᵢ κᵢ
    pub(super) applied: ExprId,
}

/// Eliminates the unknown; returns its dependence on the rest and the remaining squares. `None` if
/// these would be too many.
pub(super) fn eliminate(
    algebra: &mut Algebra<'_>,
    carriers: &Carriers,
    squares: &[Carried],
) -> Option<(Pull, Vec<Square>)> {
    let is_single_minor = carriers.minors.len() < 2 && squares.iter().all(|square| square.others.is_empty());
    // All pairs of squares are then multiples of one form and add up to a single square without
    // rotations.
    if is_single_minor {
        let pull = pull(algebra, carriers, squares);
        // A minor that depends on no acceleration does not affect the minimum.
        let minor = carriers.minors.iter().find(|minor| !minor.form.is_empty());
        let left = minor.map(|minor| across(algebra, minor, squares, pull.pivot));
        return Some((pull, left.into_iter().collect()));
    }
    let entries = carriers.minors.iter().map(|minor| minor.form.len());
    let entries = entries.chain(squares.iter().map(|square| square.others.len())).sum::<usize>();
    (squares.len() * entries <= LARGEST_ROTATION).then(|| rotate(algebra, carriers, squares))
}

/// Rotates the unknown out of all squares but one.
fn rotate(algebra: &mut Algebra<'_>, carriers: &Carriers, squares: &[Carried]) -> (Pull, Vec<Square>) {
    let (last, before) = match squares {
        [before @ .., last] if !before.is_empty() => (last, before),
        _ => return (pull(algebra, carriers, squares), Vec::new()),
    };
    let mut left = Vec::new();
    let mut kept = before[0].clone();
    let mut is_certain = false;
    for square in &before[1..] {
        let pair = [kept, square.clone()];
        // If a pivot cannot vanish, no later one can, since every rotation adds to it.
        is_certain |= pair.iter().any(|square| always_holds_unknown(algebra.graph, square));
        let (lost, found) = rotate_pair(algebra, carriers, &pair, &mut is_certain);
        left.extend(lost);
        kept = found;
    }
    // The last pivot only vanishes if the unknown has no inertia.
    let pair = [kept, last.clone()];
    let pull = pull(algebra, carriers, &pair);
    left.extend(residual(algebra, carriers, &pair, pull.pivot));
    (pull, left)
}

/// Returns the square that loses the unknown and the one that keeps it, with a guard unless the
/// pivot cannot vanish.
fn rotate_pair(
    algebra: &mut Algebra<'_>,
    carriers: &Carriers,
    pair: &[Carried; 2],
    is_certain: &mut bool,
) -> (Option<Square>, Carried) {
    let pull = pull(algebra, carriers, pair);
    let lost = residual(algebra, carriers, pair, pull.pivot);
    let kept = normalised(algebra, pair, &pull);
    *is_certain |= never_vanishes(algebra.graph, pull.pivot);
    if *is_certain {
        return (lost, kept);
    }
    let guard = Guard { pivot: pull.pivot };
    algebra.guards.push(pull.pivot);
    let lost = guard.left(algebra, carriers, &pair[1], lost);
    (Some(lost), guard.kept(algebra.graph, &pair[0], &kept))
}

/// True if a square contains the unknown in every configuration.
fn always_holds_unknown(graph: &Graph, square: &Carried) -> bool {
    never_vanishes(graph, square.weight) && never_vanishes(graph, square.arm)
}

fn pull(algebra: &mut Algebra<'_>, carriers: &Carriers, squares: &[Carried]) -> Pull {
    let pivot = squares.iter().map(|s| (s.weight, s.arm, s.arm, Number::ONE)).collect::<Vec<_>>();
    let numerators = (0..carriers.ids.len()).map(|k| {
        let products = squares.iter().map(|s| (s.weight, s.arm, s.carriers[k], Number::ONE));
        algebra.weighted(&products.collect::<Vec<_>>())
    });
    let numerators = numerators.collect();
    let mut others: BTreeMap<ExprId, Vec<_>> = BTreeMap::new();
    for square in squares {
        for &(variable, coefficient) in &square.others {
            let product = (square.weight, square.arm, coefficient, Number::ONE);
            others.entry(variable).or_default().push(product);
        }
    }
    let others = others.into_iter().map(|(variable, products)| (variable, algebra.weighted(&products)));
    let others = others.collect();
    let drifting = drifting(algebra, carriers, squares);
    let applied = squares.iter().map(|s| (algebra.graph.multiply(s.arm, s.linear), Number::ONE)).collect();
    let applied = algebra.total(applied);
    Pull { pivot: algebra.weighted(&pivot), carriers: numerators, others, drifting, applied }
}

/// Computes Σ wᵢ aᵢ (Jᵢ·drift)
fn drifting(algebra: &mut Algebra<'_>, carriers: &Carriers, squares: &[Carried]) -> ExprId {
    let mut drifts = Vec::new();
    for square in squares {
        let parts = square.carriers.iter().zip(&carriers.expansions);
        let parts = parts.map(|(&coefficient, e)| (coefficient, e.drift, Number::ONE)).collect::<Vec<_>>();
        let drift = algebra.products(&parts);
        drifts.push((square.weight, square.arm, algebra.factored(drift), Number::ONE));
    }
    algebra.weighted(&drifts)
}

/// Returns the square of the only minor, from all pairs of squares.
fn across(algebra: &mut Algebra<'_>, minor: &Minor, squares: &[Carried], pivot: ExprId) -> Square {
    let (mut weights, mut loads) = (Vec::new(), Vec::new());
    for (j, b) in squares.iter().enumerate() {
        let mut arms = Vec::new();
        for (i, a) in squares.iter().enumerate() {
            let factor = row_minor(algebra, minor.pair, a, b);
            arms.push((a.weight, a.arm, factor, Number::ONE));
            if i < j {
                let weight = algebra.graph.multiply(a.weight, b.weight);
                weights.push((weight, factor, factor, Number::ONE));
            }
        }
        let arm = algebra.weighted(&arms);
        loads.push((algebra.graph.multiply(b.linear, arm), Number::ONE));
    }
    let weight = algebra.weighted(&weights);
    let weight = algebra.factored(weight);
    let squared = algebra.graph.square(minor.content);
    let weight = algebra.graph.multiply(squared, weight);
    let weight = simplify::quotient(algebra.graph, weight, pivot);
    let load = algebra.total(loads);
    let load = algebra.graph.multiply(minor.content, load);
    let load = simplify::quotient(algebra.graph, load, pivot);
    let drift = algebra.graph.multiply(weight, minor.drift);
    let linear = algebra.total(vec![(load, Number::ONE), (drift, Number::ONE)]);
    Square { weight, linear, form: minor.form.clone() }
}

/// Returns Jᵢₖ Jⱼₗ − Jᵢₗ Jⱼₖ.
fn row_minor(algebra: &mut Algebra<'_>, (k, l): (usize, usize), a: &Carried, b: &Carried) -> ExprId {
    algebra.products(&[
        (a.carriers[k], b.carriers[l], Number::ONE),
        (a.carriers[l], b.carriers[k], Number::MINUS_ONE),
    ])
}

/// Returns the square of a rotation that has lost the unknown; `None` if nothing is left.
fn residual(
    algebra: &mut Algebra<'_>,
    carriers: &Carriers,
    pair: &[Carried; 2],
    pivot: ExprId,
) -> Option<Square> {
    let (form, drift) = difference(algebra, carriers, pair);
    if form.is_empty() {
        return None;
    }
    let [a, b] = pair;
    let weights = algebra.graph.multiply(a.weight, b.weight);
    let weight = simplify::quotient(algebra.graph, weights, pivot);
    let arms = [(b.linear, a.weight, a.arm, Number::ONE), (a.linear, b.weight, b.arm, Number::MINUS_ONE)];
    let load = algebra.weighted(&arms);
    let load = algebra.graph.divide(load, pivot);
    let drift = algebra.graph.multiply(weight, drift);
    let linear = algebra.total(vec![(load, Number::ONE), (drift, Number::ONE)]);
    Some(Square { weight, linear, form })
}

/// Computes a₁ p₂ − a₂ p₁ from the minors: the form and its drift.
fn difference(algebra: &mut Algebra<'_>, carriers: &Carriers, [a, b]: &[Carried; 2]) -> (LinearForm, ExprId) {
    let mut coefficients: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
    let mut drifts = Vec::new();
    for minor in &carriers.minors {
        let factor = row_minor(algebra, minor.pair, a, b);
        if algebra.graph.is_zero(factor) {
            continue;
        }
        let factor = algebra.graph.multiply(factor, minor.content);
        drifts.push((factor, minor.drift, Number::ONE));
        for &(part, slope) in &minor.form {
            coefficients.entry(part).or_default().push((factor, slope, Number::ONE));
        }
    }
    for (arm, others, sign) in [(a.arm, &b.others, Number::ONE), (b.arm, &a.others, Number::MINUS_ONE)] {
        for &(variable, coefficient) in others {
            coefficients.entry(variable).or_default().push((arm, coefficient, sign.clone()));
        }
    }
    (algebra.form_of_products(coefficients), algebra.products(&drifts))
}

/// Returns the square of a rotation that has kept the unknown, with the coefficient one.
fn normalised(algebra: &mut Algebra<'_>, pair: &[Carried; 2], pull: &Pull) -> Carried {
    let mut divided = |value: ExprId| simplify::quotient(algebra.graph, value, pull.pivot);
    let carriers = pull.carriers.iter().map(|&value| divided(value)).collect();
    let others = pull.others.iter().map(|&(variable, value)| (variable, divided(value))).collect();
    let linear = pair.iter().map(|s| (algebra.graph.multiply(s.arm, s.linear), Number::ONE)).collect();
    let linear = algebra.total(linear);
    Carried { weight: pull.pivot, linear, arm: algebra.graph.number(1), carriers, others }
}

impl Pull {
    /// Returns (Σ numerator · y′ + Σ others) / D as a form in the remaining variables, without
    /// drift.
    pub(super) fn factors(&self, algebra: &mut Algebra<'_>, carriers: &Carriers) -> LinearForm {
        let mut form: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
        let one = algebra.graph.number(1);
        for (&numerator, expansion) in self.carriers.iter().zip(&carriers.expansions) {
            for &(part, slope) in &expansion.rest {
                form.entry(part).or_default().push((numerator, slope, Number::ONE));
            }
        }
        for &(variable, coefficient) in &self.others {
            form.entry(variable).or_default().push((coefficient, one, Number::ONE));
        }
        let form = algebra.form_of_products(form);
        form.iter().map(|&(id, value)| (id, simplify::quotient(algebra.graph, value, self.pivot))).collect()
    }
}
