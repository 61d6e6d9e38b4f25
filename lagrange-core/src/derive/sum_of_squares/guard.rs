//! Rotations of squares that may both lose the unknown in some configurations.
//!
//! In some configurations two of three squares may not depend on the unknown, such as the
//! horizontal velocities of a point that moves straight up. A rotation of these two divides by
//! their pivot, which is zero there although the pivot of all three is not. If it is zero, no
//! rotation is needed: one square is kept as it is, without the unknown, and the other is left
//! over.

use super::square::{Carried, Carriers, Square};
use crate::derive::algebra::{Algebra, LinearForm};
use lagrange_expr::expr::{ExprId, Graph, Relation};

/// Choice between the rotated squares if the pivot is positive, and the original ones if it is
/// zero.
pub(super) struct Guard {
    pub(super) pivot: ExprId,
}

impl Guard {
    fn choose(&self, graph: &mut Graph, before: ExprId, found: ExprId) -> ExprId {
        let zero = graph.number(0);
        graph.choose(Relation::LessEqual, self.pivot, zero, before, found)
    }

    /// Returns the square that keeps the unknown.
    pub(super) fn kept(&self, graph: &mut Graph, before: &Carried, found: &Carried) -> Carried {
        let zero = graph.number(0);
        let pairs = before.carriers.iter().zip(&found.carriers);
        Carried {
            weight: self.choose(graph, before.weight, found.weight),
            linear: self.choose(graph, before.linear, found.linear),
            arm: self.choose(graph, zero, found.arm),
            carriers: pairs.map(|(&before, &found)| self.choose(graph, before, found)).collect(),
            others: self.form(graph, &before.others, &found.others),
        }
    }

    /// Returns the square that loses the unknown.
    pub(super) fn left(
        &self,
        algebra: &mut Algebra<'_>,
        carriers: &Carriers,
        before: &Carried,
        found: Option<Square>,
    ) -> Square {
        let before = carriers.without_unknown(algebra, before);
        let graph = &mut *algebra.graph;
        let zero = graph.number(0);
        let nothing = Square { weight: before.weight, linear: zero, form: Vec::new() };
        let found = found.unwrap_or(nothing);
        Square {
            weight: self.choose(graph, before.weight, found.weight),
            linear: self.choose(graph, before.linear, found.linear),
            form: self.form(graph, &before.form, &found.form),
        }
    }

    fn form(&self, graph: &mut Graph, before: &LinearForm, found: &LinearForm) -> LinearForm {
        let mut variables = before.iter().chain(found).map(|(id, _)| *id).collect::<Vec<_>>();
        variables.sort_unstable();
        variables.dedup();
        let zero = graph.number(0);
        let of =
            |form: &LinearForm, id| form.iter().find(|(known, _)| *known == id).map_or(zero, |(_, c)| *c);
        let chosen = variables.into_iter().map(|id| {
            let (before, found) = (of(before, id), of(found, id));
            (id, self.choose(graph, before, found))
        });
        chosen.collect()
    }
}
