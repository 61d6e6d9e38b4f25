//! Indices of names as integers.

use super::complaints::Complaints;
use super::counting::Counting;
use super::scopes::ScopeId;
use crate::syntax::ast::{AstId, Name};
use lagrange_expr::diagnostics::Origin;

/// An index and its place.
pub(super) type PlacedIndex = (i64, Origin);

/// Returns the indices of a name as integers; errors are reported.
pub(super) fn indices_of(
    name: &Name,
    scope: ScopeId,
    counting: Counting<'_>,
    complaints: &mut Complaints<'_>,
) -> Option<Vec<i64>> {
    let indices = name.indices.iter().map(|index| (*index, scope)).collect::<Vec<_>>();
    counted_indices(&indices, counting, complaints)
}

/// Returns indices as integers, each in its scope; errors are reported.
pub(super) fn counted_indices(
    indices: &[(AstId, ScopeId)],
    counting: Counting<'_>,
    complaints: &mut Complaints<'_>,
) -> Option<Vec<i64>> {
    let counted = indices
        .iter()
        .map(|(index, scope)| counting.integer(*index, *scope).map_err(|fault| (fault, *scope)));
    match counted.collect::<Result<Vec<_>, _>>() {
        Ok(indices) => Some(indices),
        Err((fault, scope)) => {
            complaints.fault(counting.expressions, &fault, (counting.scopes, scope));
            None
        }
    }
}
