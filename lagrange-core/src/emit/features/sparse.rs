//! Large sparse matrices: only nonzero entries are written.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::length;
use crate::emit::base::writer::MethodWriter;
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::expr::{ExprId, Graph};

/// Maximum number of entries of a matrix that is always written in rows, including zeros, since
/// this is easier to read.
const LARGEST_IN_ROWS: usize = 10_000;
/// A larger matrix is listed if at most one in this many entries is nonzero. For a fuller one, rows
/// are shorter than entries with their indices.
const FEWEST_ZEROS: usize = 4;

/// The nonzero entries of a matrix, with their rows and columns.
pub(in crate::emit) struct Sparse {
    places: Vec<(usize, usize)>,
    roots: Vec<ExprId>,
}

impl Sparse {
    /// Collects the nonzero entries; `None` if the matrix should be written in rows.
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

    /// Writes a list of rows, columns and entries.
    fn list(&self, entries: &[TokenStream]) -> TokenStream {
        let entries = self.places.iter().zip(entries).map(|(&(row, column), entry)| {
            let (row, column) = (length(row), length(column));
            quote!((#row, #column, #entry))
        });
        quote!([#(#entries),*])
    }
}

/// Writes a body that computes a matrix.
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

/// Writes `ConstrainedSystem::residual_scales`, if the Jacobian of the constraints is too sparse to
/// be formed for it.
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
