//! Parts and their placements, as written.

use super::Statement;
use crate::syntax::ast::{AstId, Name, Range};
use lagrange_expr::diagnostics::Origin;

/// `part Leg(side, l = 0.2 m) { … }`
#[derive(Clone, Debug)]
pub struct PartDefinition {
    /// Its name.
    pub name: Name,
    /// Its arguments, which refer to items outside.
    pub arguments: Vec<PartArgument>,
    /// Its statements.
    pub body: Vec<Statement>,
    /// Place from the keyword to the closing brace.
    pub origin: Origin,
    /// True if it is from a file, which may contain more parts than are placed.
    pub is_included: bool,
}

/// An argument of a part.
#[derive(Clone, Debug)]
pub struct PartArgument {
    /// Its name.
    pub name: Name,
    /// The default value, for placements that omit the argument.
    pub default: Option<AstId>,
}

/// `leg[i in 0..4]: Leg { side: e; }`
#[derive(Clone, Debug)]
pub struct Placement {
    /// The name of the placed part, with its indices except the variable.
    pub name: Name,
    /// The variable of an array of parts and its values.
    pub count: Option<(Name, Range)>,
    /// The part.
    pub part: Name,
    /// The given arguments. For an array, a value may be a list.
    pub arguments: Vec<(Name, AstId)>,
}

impl Placement {
    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let ends = self.count.iter_mut().flat_map(|(_, range)| [&mut range.from, &mut range.to]);
        let indices = self.name.indices.iter_mut().chain(ends);
        indices.chain(self.arguments.iter_mut().map(|(_, value)| value)).collect()
    }
}
