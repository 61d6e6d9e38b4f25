//! Removal of optional `let`s that nothing needs.
//!
//! The world position of a frame is only needed for weights, points and outputs, and so is a
//! contact force on its own. If a scene does not need them, they are omitted, so that its plain
//! statements contain only the parts of its equations.

use super::plain::{Drawn, DrawnKind, InertialBody, Obligation, Plain};
use crate::syntax::ast::{AstId, Expression, Expressions, StatementKind};
use lagrange_expr::collections::HashSet;

/// Removes `let`s with these names that are used neither in statements nor in the additional data.
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

/// Returns the expressions of a drawn item.
fn drawn(item: &Drawn) -> Vec<AstId> {
    let (outlines, height) = match &item.kind {
        DrawnKind::Body { outlines, .. } => (&outlines[..], None),
        DrawnKind::Surface { height, .. } => (&[][..], height.as_ref().map(|(_, height)| height)),
        _ => (&[][..], None),
    };
    let of_shape = outlines.iter().flat_map(|outline| outline.dimensions.iter().chain(&outline.place));
    item.values.iter().chain(of_shape).chain(height).copied().collect()
}

/// Returns the expressions that obligations check; those of masses and properties are among the
/// mentioned ones.
fn obliged(obligation: &Obligation) -> Vec<AstId> {
    match obligation {
        Obligation::Tensor { tensor, .. } => tensor.to_vec(),
        Obligation::SpaceVector { value, .. } | Obligation::Opens { gap: value, .. } => vec![*value],
        Obligation::PositiveMass { mass, .. } => vec![*mass],
        _ => Vec::new(),
    }
}

/// Names in expressions, each collected once.
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
