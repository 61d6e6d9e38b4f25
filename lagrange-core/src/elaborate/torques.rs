//! Attribution of torques on angles to bodies.
//!
//! A torque m on an angle θ has the power m θ̇. If θ turns as a body does, θ̇ = ω, a moment m on
//! this body has the same power. If it is the relative angle of two bodies, θ̇ = ω₂ − ω₁, the
//! moments m on one and −m on the other have this power. If θ is the second angle of a double
//! pendulum, measured from the first rod, the torque is that of a motor in the joint. Measured from
//! the vertical, it acts on the second rod alone. An ambiguous torque is not attributed.

use super::elaborator::Elaborator;
use super::expression::value_of;
use super::operand::Operand;
use crate::model::{BodyMotion, DrawnItem};
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::expr::ExprId;
use lagrange_language::bodies::{DrawnKind, LoadOrigin};
use lagrange_language::syntax::ast::AstId;

/// Bodies, each with true if the opposite moment acts on it.
type Shares = Vec<(usize, bool)>;

/// Returns a torque on an angle as moments on bodies, or else as an omitted item of this name.
pub(super) fn torque_item(elaborator: &mut Elaborator<'_>, name: &str, values: &[AstId]) -> Vec<DrawnItem> {
    let &[moment, angle] = values else { return Vec::new() };
    let found = [moment, angle].map(|syntax| value_of(&mut elaborator.evaluator, syntax));
    let [Some(Operand::Scalar(moment)), Some(turning)] = found else { return Vec::new() };
    let Some(Operand::Scalar(rate)) = elaborator.evaluator.rate(&turning, angle) else { return Vec::new() };
    let fitting = turned(elaborator, rate);
    let [shares] = &fitting[..] else { return vec![DrawnItem::omitted(name)] };
    let item = |&(body, is_opposite): &(usize, bool)| {
        let motion = &elaborator.scene.motions[body];
        let ([x, y], body) = (motion.center(), Some(motion.body.text.clone()));
        let moment = if is_opposite { elaborator.evaluator.graph.negate(moment) } else { moment };
        let kind = DrawnKind::Moment { name: "torque".to_owned(), cause: LoadOrigin::Applied, body };
        DrawnItem { kind, values: vec![x, y, moment], parts: Vec::new(), height: None }
    };
    shares.iter().map(item).collect()
}

/// Returns the bodies on which a moment has the power of a torque on an angle of this rate: single
/// bodies, or else pairs.
fn turned(elaborator: &mut Elaborator<'_>, rate: ExprId) -> Vec<Shares> {
    let spins = elaborator.scene.motions.iter().map(BodyMotion::spin).collect::<Vec<_>>();
    let single = spins.iter().enumerate().map(|(body, &spin)| (vec![(body, false)], spin)).collect();
    let bodies = fitting(elaborator, rate, single);
    if !bodies.is_empty() {
        return bodies;
    }
    let mut pairs = Vec::new();
    for (second, &spin) in spins.iter().enumerate() {
        for (first, &other) in spins[..second].iter().enumerate() {
            let relative = elaborator.evaluator.graph.subtract(spin, other);
            pairs.push((vec![(first, true), (second, false)], relative));
        }
    }
    fitting(elaborator, rate, pairs)
}

/// Returns the bodies with this rate, and those with the opposite rate, with opposite moments.
fn fitting(elaborator: &mut Elaborator<'_>, rate: ExprId, candidates: Vec<(Shares, ExprId)>) -> Vec<Shares> {
    let graph = &mut elaborator.evaluator.graph;
    let mut differences = Vec::new();
    for (_, spin) in &candidates {
        differences.extend([graph.subtract(rate, *spin), graph.add(rate, *spin)]);
    }
    let vanish = vanishing(graph, &differences);
    let mut fitting = Vec::new();
    for ((shares, _), vanish) in candidates.into_iter().zip(vanish.chunks(2)) {
        match vanish {
            [true, _] => fitting.push(shares),
            [_, true] => fitting.push(shares.into_iter().map(|(body, side)| (body, !side)).collect()),
            _ => {}
        }
    }
    fitting
}
