//! Bodies whose mass changes: the momentum that matter takes with it.
//!
//! Matter leaves or joins a body with the velocity of the body where it does, and exerts no force.
//! At each instant the equations are those of a rigid body, m a = F and J α + ω × J ω = M. The
//! momentum of the body still changes by ṁ v, and its angular momentum by J̇ ω. Loads state this,
//! since the rates of momenta contain the same terms. The force of exhaust is a load of the user.
//!
//! Only mass and inertia change. If the centre of mass shifted in the body, matter would move
//! within it, with reactions that depend on how it does.
//!
//! Source: Thomson, "Equations of motion for the variable mass system", AIAA Journal 4 (1966)
//! 766–768.

use super::plain::Obligation;
use super::translation::Translation;
use crate::syntax::ast::{AstId, Name, StatementKind};

/// Returns the mass or an entry of the inertia of a body.
pub(super) fn matter(translation: &mut Translation<'_>, id: AstId, what: &str) -> AstId {
    let value = super::expressions::mention(translation, id);
    translation.obligations.push(Obligation::Unmoved { what: what.to_owned(), value });
    value
}

/// True if mass or inertia of a body may have a rate. Both are checked if they may change at all.
pub(super) fn may_change(
    translation: &mut Translation<'_>,
    body: &Name,
    mass: AstId,
    inertia: Vec<AstId>,
) -> bool {
    let all = || inertia.iter().chain([&mass]);
    let changes = all().any(|&value| translation.may_change(value));
    if !all().all(|&value| translation.is_at_rest(value)) {
        translation.obligations.push(Obligation::Matter { body: body.clone(), mass, inertia });
    }
    changes
}

/// Adds the load of a mass or moment of inertia that may change, along a scalar or vector velocity.
pub(super) fn push_influx(translation: &mut Translation<'_>, name: &str, matter: AstId, velocity: AstId) {
    if !translation.may_change(matter) {
        return;
    }
    let mut terms = translation.terms();
    let rate = terms.rate(matter);
    let momentum = terms.times(rate, velocity);
    if !terms.is_zero(momentum) {
        push_load(translation, name, momentum, velocity);
    }
}

/// Adds the load `momentum` along `velocity` under a name; both are scalars or vectors.
pub(super) fn push_load(translation: &mut Translation<'_>, name: &str, momentum: AstId, velocity: AstId) {
    let force = translation.bind(name, momentum);
    translation.push(StatementKind::ForceAlong { force, velocity });
}
