//! Accelerations of systems without constraints whose mass matrix is not definite.

use quote::quote;

use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::local;
use crate::emit::base::writer::MethodWriter;
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::expr::ExprId;

/// `acceleration`, which goes a second way where a pivot vanishes or is small; its operations. Mass
/// matrix and forcing are there for it: most of them was computed anyway.
pub(in crate::emit) fn write_indefinite(
    writer: &mut MethodWriter<'_>,
    docs: &[&str],
    growth: ExprId,
) -> OperationCounts {
    let equations = writer.equations;
    let (krate, values) = (writer.shape.krate, local("values"));
    let n = equations.accelerations.len();
    let roots =
        [&equations.accelerations[..], &equations.forcing, &equations.mass_matrix.concat(), &[growth]];
    let (body, counts) = writer.lowered(&roots.concat(), Arguments::State, |results| {
        let (accelerations, rest) = results.split_at(n);
        let (forcing, rest) = rest.split_at(n);
        let (entries, growth) = rest.split_at(n * n);
        let list = Returns::Vector(n).collect(accelerations);
        let mass_matrix = Returns::Matrix(n, n).collect(entries);
        quote! {
            let #values = #list;
            if #krate::constraint::are_regular(&#values, #(#growth)*) {
                #values
            } else {
                #krate::constraint::indefinite_motion(&#mass_matrix, &[#(#forcing),*])
            }
        }
    });
    writer.push_method("acceleration", docs, n, body, counts);
    counts
}
