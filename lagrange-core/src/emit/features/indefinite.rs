//! Accelerations of systems without constraints and with an indefinite mass matrix.

use quote::quote;

use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::local;
use crate::emit::base::writer::MethodWriter;
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::expr::ExprId;

/// Writes `acceleration`, which uses a second method where a pivot vanishes or is small; returns
/// its operations. The mass matrix and the forcing are always available for it, since most of them
/// is computed anyway.
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
