//! Optional `let`s that nothing needs.
//!
//! The place of a frame in the world matters to weights, points and outputs only, and so does the
//! force of a contact by itself. Those that a scene does not need are omitted, so that its plain
//! statements hold only the parts of its equations.

use super::plain::{Drawn, DrawnKind, InertialBody, Obligation, Plain};
use crate::syntax::ast::{AstId, Expression, Expressions, StatementKind};
use lagrange_expr::collections::HashSet;

/// Removes `let`s of these names that neither statements nor anything beside them mention.
pub(super) fn leave_out_unneeded(plain: &mut Plain, optional: &HashSet<String>) {
    if optional.is_empty() {
        return;
    }
    let expressions = &plain.declaration.expressions;
    let mut needed = Needed { expressions, names: HashSet::default(), seen: HashSet::default() };
    plain.mentioned.iter().for_each(|&id| needed.add(id));
    plain.in_space.expressions().into_iter().for_each(|id| needed.add(id));
    plain.inertial.iter().flat_map(InertialBody::expressions).for_each(|id| needed.add(id));
    plain.drawing.iter().flat_map(drawn).for_each(|id| needed.add(id));
    plain.obligations.iter().flat_map(obliged).for_each(|id| needed.add(id));
    let mut kept = Vec::with_capacity(plain.declaration.statements.len());
    for statement in plain.declaration.statements.iter().rev() {
        let is_needed = match &statement.kind {
            StatementKind::Let(name, _) => {
                !optional.contains(&name.text) || needed.names.contains(&name.text)
            }
            _ => true,
        };
        kept.push(is_needed);
        if is_needed {
            statement.kind.expressions().into_iter().for_each(|id| needed.add(id));
        }
    }
    let mut kept = kept.into_iter().rev();
    plain.declaration.statements.retain(|_| kept.next().unwrap_or(true));
}

/// Expressions of an item that is drawn.
fn drawn(item: &Drawn) -> Vec<AstId> {
    let outlines = match &item.kind {
        DrawnKind::Body { outlines, .. } => &outlines[..],
        _ => &[],
    };
    let of_shape = outlines.iter().flat_map(|outline| outline.dimensions.iter().chain(&outline.place));
    item.values.iter().chain(of_shape).copied().collect()
}

/// Expressions that obligations check, those of masses and properties being among the mentioned
/// ones.
fn obliged(obligation: &Obligation) -> Vec<AstId> {
    match obligation {
        Obligation::Tensor { tensor, .. } => tensor.to_vec(),
        Obligation::SpaceVector { value, .. } | Obligation::Opens { gap: value, .. } => vec![*value],
        Obligation::PositiveMass { mass, .. } => vec![*mass],
        _ => Vec::new(),
    }
}

/// Names in expressions, each found once.
struct Needed<'e> {
    expressions: &'e Expressions,
    names: HashSet<String>,
    seen: HashSet<AstId>,
}

impl Needed<'_> {
    fn add(&mut self, root: AstId) {
        let mut pending = vec![root];
        while let Some(id) = pending.pop() {
            if !self.seen.insert(id) {
                continue;
            }
            match self.expressions.get(id) {
                Expression::Name(name) => drop(self.names.insert(name.clone())),
                other => pending.extend(other.operands()),
            }
        }
    }
}
