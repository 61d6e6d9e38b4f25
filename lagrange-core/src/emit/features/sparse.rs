//! Large matrices of which most entries are zero: only the others are written.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::length;
use crate::emit::base::writer::MethodWriter;
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::expr::{ExprId, Graph};

/// Matrices with no more entries than this are written in rows, zeros included, since they are
/// easier to read that way.
const LARGEST_IN_ROWS: usize = 10_000;
/// A larger matrix is listed if at most one in this many entries differs from zero. In a fuller
/// one, rows are shorter than entries with their indices.
const FEWEST_ZEROS: usize = 4;

/// The entries of a matrix that are not zero, with their rows and columns.
pub(in crate::emit) struct Sparse {
    places: Vec<(usize, usize)>,
    roots: Vec<ExprId>,
}

impl Sparse {
    /// `None` if the matrix had better be written in rows.
    pub(in crate::emit) fn of(graph: &Graph, returns: Returns, roots: &[ExprId]) -> Option<Sparse> {
        let Returns::Matrix(_, columns) = returns else { return None };
        if roots.len() <= LARGEST_IN_ROWS {
            return None;
        }
        let entries = roots.iter().enumerate().filter(|(_, root)| !graph.is_zero(**root));
        let entries = entries.map(|(index, &root)| ((index / columns, index % columns), root));
        let (places, entries): (Vec<_>, Vec<_>) = entries.unzip();
        (entries.len() * FEWEST_ZEROS <= roots.len()).then_some(Sparse { places, roots: entries })
    }

    /// A list of rows, columns and entries.
    fn list(&self, entries: &[TokenStream]) -> TokenStream {
        let entries = self.places.iter().zip(entries).map(|(&(row, column), entry)| {
            let (row, column) = (length(row), length(column));
            quote!((#row, #column, #entry))
        });
        quote!([#(#entries),*])
    }
}

/// A body that computes a matrix.
pub(in crate::emit) fn lowered_sparse(
    writer: &mut MethodWriter<'_>,
    sparse: &Sparse,
    arguments: Arguments,
) -> (TokenStream, OperationCounts) {
    let krate = writer.shape.krate;
    writer.lowered(&sparse.roots, arguments, |entries| {
        let list = sparse.list(entries);
        quote!(#krate::private::matrix(&#list))
    })
}

/// `ConstrainedSystem::residual_scales`, if the Jacobian of the constraints is not worth forming
/// for it.
pub(in crate::emit) fn write_sparse_scales(writer: &mut MethodWriter<'_>) {
    let (n, m) = (writer.model.speeds.len(), writer.model.constraints.len());
    let roots = writer.equations.constraints.jacobian.concat();
    let Some(sparse) = Sparse::of(&writer.model.graph, Returns::Matrix(m, n), &roots) else { return };
    let (krate, shares) = (writer.shape.krate, writer.members.names.shares.clone());
    let (body, _) = writer.lowered(&sparse.roots, Arguments::Shares, |entries| {
        let list = sparse.list(entries);
        quote!(#krate::constraint::weighed_entries(&#list, #shares))
    });
    writer.push_constrained("residual_scales", Arguments::Shares, Returns::Vector(m), body);
}
