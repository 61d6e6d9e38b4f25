//! Reduced types, as written.

use super::enclosures::{Enclosed, Enclosure};
use crate::syntax::ast::{AstId, Name};

/// A second type with fewer or simpler motions.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// Its name.
    pub name: Name,
    /// Changes to coordinates.
    pub items: Vec<ReductionItem>,
}

/// The change to one coordinate of a reduced type.
#[derive(Clone, Debug)]
pub struct ReductionItem {
    /// The coordinate.
    pub coordinate: Name,
    /// Kind of change.
    pub kind: ReductionKind,
    /// The value after `=`; 0 by default.
    pub value: Option<AstId>,
    /// Loops and conditions around it, before expansion.
    pub enclosures: Vec<Enclosure>,
}

impl ReductionItem {
    pub(super) fn expressions_mut(&mut self) -> impl Iterator<Item = &mut AstId> {
        self.value.iter_mut().chain(self.enclosures.iter_mut().flat_map(Enclosure::expressions_mut))
    }
}

impl Reduction {
    /// True if it has momenta of ignored coordinates, which are fields of its type.
    pub fn has_momenta(&self) -> bool {
        self.of_kind(ReductionKind::Ignored).next().is_some()
    }

    /// Returns the changes of one kind.
    pub fn of_kind(&self, kind: ReductionKind) -> impl Iterator<Item = &ReductionItem> {
        self.items.iter().filter(move |item| item.kind == kind)
    }
}

/// Returns the parameter of a reduced type that is the momentum of an ignored coordinate.
pub fn momentum_of(coordinate: &Name) -> Name {
    Name::new(format!("{}_momentum", coordinate.text), coordinate.span)
}

impl Enclosed for ReductionItem {
    fn enclosures_mut(&mut self) -> &mut Vec<Enclosure> {
        &mut self.enclosures
    }
}

/// The possible changes to a coordinate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ReductionKind {
    /// `freeze x = e;`: held at a value.
    Frozen,
    /// `small theta = e;`: remains near a value.
    Small,
    /// `ignore phi;`: is cyclic, and its momentum replaces its velocity.
    Ignored,
}
