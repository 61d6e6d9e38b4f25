//! Elimination of one unknown from a sum of squares.
//!
//! A sum of squares Σ ½ wᵢ rᵢ² with rᵢ = aᵢ x + pᵢ is minimal over x where D x = −Σ wᵢ aᵢ pᵢ, D = Σ wᵢ aᵢ², and
//! what is left is again a sum of squares, by Lagrange's identity
//!
//! ```text
//! Σ wᵢ pᵢ² − (Σ wᵢ aᵢ pᵢ)² / D = Σ_{i<j} (wᵢ wⱼ / D) (aᵢ pⱼ − aⱼ pᵢ)².
//! ```
//!
//! Two at a time, that is a Givens rotation without square roots (Gentleman, "Least squares computations by
//! Givens transformations without square roots", J. Inst. Math. Appl. 12 (1973), 329–336): one square keeps x
//! and the other loses it. No difference of squares occurs, as in a Schur complement, and the condition
//! of the mass matrix enters by its square root.
//!
//! Where x enters through variables y_k = t_k x + y′_k, as the angle of a rod does through the velocity of its
//! end, rᵢ = Σ Jᵢₖ y_k, then
//!
//! ```text
//! aᵢ pⱼ − aⱼ pᵢ = Σ_{k<l} (Jᵢₖ Jⱼₗ − Jᵢₗ Jⱼₖ) (t_k y′_l − t_l y′_k),
//! ```
//!
//! so that what is left depends on the y′ only by way of the *moments* t_k y′_l − t_l y′_k. A rod between two
//! points has a single one: the acceleration of its end across it.

use std::collections::BTreeMap;

use super::composition::Expansion;
use super::guard::{Guard, never_vanishes};
use crate::derive::algebra::{Algebra, LinearForm};
use crate::expr::{ExprId, Graph};
use crate::number::Number;
use crate::simplify;

/// Squares times variables up to which they are rotated one after the other. Every rotation may fill in all variables,
/// so that many squares of many variables cost far more than the mass matrix that they add up to.
const LARGEST_ROTATION: usize = 1000;

/// ½ weight·r² + linear·r with r = form.
#[derive(Clone, Debug)]
pub(super) struct Square {
    pub(super) weight: ExprId,
    pub(super) linear: ExprId,
    pub(super) form: LinearForm,
}

/// A square that holds the unknown, by way of its carriers.
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

/// The variables through which squares hold the unknown: y_k = t_k x + y′_k.
#[derive(Debug)]
pub(super) struct Carriers {
    pub(super) ids: Vec<ExprId>,
    pub(super) expansions: Vec<Expansion>,
    /// t_k y′_l − t_l y′_k for k < l.
    moments: Vec<Moment>,
}

/// `content` times a form and its drift.
#[derive(Debug)]
struct Moment {
    pair: (usize, usize),
    content: ExprId,
    form: LinearForm,
    drift: ExprId,
}

/// How the unknown depends on the rest: pivot · x = −Σ numerator · y′ − Σ others − load.
#[derive(Debug)]
pub(super) struct Pull {
    /// D
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

impl Carriers {
    pub(super) fn new(algebra: &mut Algebra<'_>, ids: Vec<ExprId>, expansions: Vec<Expansion>) -> Carriers {
        let mut moments = Vec::new();
        for (l, b) in expansions.iter().enumerate() {
            for (k, a) in expansions[..l].iter().enumerate() {
                let moment = moment(algebra, (k, l), a, b);
                let is_nothing = moment.form.is_empty() && algebra.graph.is_zero(moment.drift);
                moments.extend((!is_nothing).then_some(moment));
            }
        }
        Carriers { ids, expansions, moments }
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

    /// The square written in what is left when the unknown is gone.
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

impl Carried {
    /// Whether the square holds the unknown in every configuration.
    fn is_certain(&self, graph: &Graph) -> bool {
        never_vanishes(graph, self.weight) && never_vanishes(graph, self.arm)
    }
}

/// t_k y′_l − t_l y′_k
fn moment(algebra: &mut Algebra<'_>, pair: (usize, usize), a: &Expansion, b: &Expansion) -> Moment {
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
        Some(drift) => Moment { pair, content, form: primitive, drift },
        None => Moment { pair, content: algebra.graph.number(1), form, drift },
    }
}

/// Eliminates the unknown; returns what it depends on and the squares that are left. `None` if those would be too many.
pub(super) fn eliminate(
    algebra: &mut Algebra<'_>,
    carriers: &Carriers,
    squares: &[Carried],
) -> Option<(Pull, Vec<Square>)> {
    let is_single_moment =
        carriers.moments.len() < 2 && squares.iter().all(|square| square.others.is_empty());
    if is_single_moment {
        let pull = pull(algebra, carriers, squares);
        // What depends on no acceleration cannot be made smaller.
        let moment = carriers.moments.iter().find(|moment| !moment.form.is_empty());
        let left = moment.map(|moment| across(algebra, moment, squares, pull.pivot));
        return Some((pull, left.into_iter().collect()));
    }
    let entries = carriers.moments.iter().map(|moment| moment.form.len());
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
        is_certain |= pair.iter().any(|square| square.is_certain(algebra.graph));
        let (lost, found) = rotate_pair(algebra, carriers, &pair, &mut is_certain);
        left.extend(lost);
        kept = found;
    }
    // That the last pivot vanishes means that the unknown has no inertia.
    let pair = [kept, last.clone()];
    let pull = pull(algebra, carriers, &pair);
    left.extend(residual(algebra, carriers, &pair, pull.pivot));
    (pull, left)
}

/// The square that loses the unknown and the one that keeps it, with a guard unless the pivot is certain not to vanish.
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

/// Σ wᵢ aᵢ (Jᵢ·drift)
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

/// The square across the only moment, from all pairs of squares.
fn across(algebra: &mut Algebra<'_>, moment: &Moment, squares: &[Carried], pivot: ExprId) -> Square {
    let (mut weights, mut loads) = (Vec::new(), Vec::new());
    for (j, b) in squares.iter().enumerate() {
        let mut arms = Vec::new();
        for (i, a) in squares.iter().enumerate() {
            let minor = minor(algebra, moment.pair, a, b);
            arms.push((a.weight, a.arm, minor, Number::ONE));
            if i < j {
                let weight = algebra.graph.multiply(a.weight, b.weight);
                weights.push((weight, minor, minor, Number::ONE));
            }
        }
        let arm = algebra.weighted(&arms);
        loads.push((algebra.graph.multiply(b.linear, arm), Number::ONE));
    }
    let weight = algebra.weighted(&weights);
    let weight = algebra.factored(weight);
    let squared = algebra.graph.square(moment.content);
    let weight = algebra.graph.multiply(squared, weight);
    let weight = simplify::quotient(algebra.graph, weight, pivot);
    let load = algebra.total(loads);
    let load = algebra.graph.multiply(moment.content, load);
    let load = simplify::quotient(algebra.graph, load, pivot);
    let drift = algebra.graph.multiply(weight, moment.drift);
    let linear = algebra.total(vec![(load, Number::ONE), (drift, Number::ONE)]);
    Square { weight, linear, form: moment.form.clone() }
}

/// Jᵢₖ Jⱼₗ − Jᵢₗ Jⱼₖ
fn minor(algebra: &mut Algebra<'_>, (k, l): (usize, usize), a: &Carried, b: &Carried) -> ExprId {
    algebra.products(&[
        (a.carriers[k], b.carriers[l], Number::ONE),
        (a.carriers[l], b.carriers[k], Number::MINUS_ONE),
    ])
}

/// The square of a rotation that has lost the unknown; `None` if nothing is left.
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

/// a₁ p₂ − a₂ p₁ by way of the moments: the form and its drift.
fn difference(algebra: &mut Algebra<'_>, carriers: &Carriers, [a, b]: &[Carried; 2]) -> (LinearForm, ExprId) {
    let mut coefficients: BTreeMap<ExprId, Vec<(ExprId, ExprId, Number)>> = BTreeMap::new();
    let mut drifts = Vec::new();
    for moment in &carriers.moments {
        let minor = minor(algebra, moment.pair, a, b);
        if algebra.graph.is_zero(minor) {
            continue;
        }
        let minor = algebra.graph.multiply(minor, moment.content);
        drifts.push((minor, moment.drift, Number::ONE));
        for &(part, slope) in &moment.form {
            coefficients.entry(part).or_default().push((minor, slope, Number::ONE));
        }
    }
    for (arm, others, sign) in [(a.arm, &b.others, Number::ONE), (b.arm, &a.others, Number::MINUS_ONE)] {
        for &(variable, coefficient) in others {
            coefficients.entry(variable).or_default().push((arm, coefficient, sign.clone()));
        }
    }
    (algebra.form_of_products(coefficients), algebra.products(&drifts))
}

/// The square of a rotation that has kept the unknown, with the coefficient one.
fn normalised(algebra: &mut Algebra<'_>, pair: &[Carried; 2], pull: &Pull) -> Carried {
    let mut divided = |value: ExprId| simplify::quotient(algebra.graph, value, pull.pivot);
    let carriers = pull.carriers.iter().map(|&value| divided(value)).collect();
    let others = pull.others.iter().map(|&(variable, value)| (variable, divided(value))).collect();
    let linear = pair.iter().map(|s| (algebra.graph.multiply(s.arm, s.linear), Number::ONE)).collect();
    let linear = algebra.total(linear);
    Carried { weight: pull.pivot, linear, arm: algebra.graph.number(1), carriers, others }
}

impl Pull {
    /// (Σ numerator · y′ + Σ others) / D as a form in what is left, without drift.
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
