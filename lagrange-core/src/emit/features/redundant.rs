//! Members for dependent constraints: matrices that are formed at run time.

use proc_macro2::TokenStream;
use quote::quote;

use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::length;
use crate::emit::base::writer::MethodWriter;
use lagrange_expr::expr::ExprId;

/// Writes the solution of the whole system M a = f + Aᵀλ and A a + b = 0 at run time.
pub(in crate::emit) fn write_redundant_motion(writer: &mut MethodWriter<'_>) {
    let (n, m) = (writer.model.speeds.len(), writer.model.constraints.len());
    let equations = writer.equations;
    let vectors = [&equations.forcing[..], &equations.constraints.drifts].concat();
    let roots = [entries(writer), vectors].concat();
    let krate = writer.shape.krate;
    let (body, _) = writer.lowered(&roots, Arguments::State, |results| {
        let (known, vectors) = results.split_at((n + m) * n);
        let [mass_matrix, jacobian] = matrices(known, n, m);
        let (forcing, drifts) = vectors.split_at(n);
        quote! {
            #krate::constraint::redundant_motion(
                &#mass_matrix,
                &[#(#forcing),*],
                &#jacobian,
                &[#(#drifts),*],
            )
        }
    });
    let (scalar, n, m) = (writer.shape.scalar(), length(n), length(m));
    let [parameters, _] = Arguments::State.written(writer.shape, &writer.members.names);
    writer.members.hidden.extend(quote! {
        /// Accelerations and the least multipliers where constraints depend on each other.
        #[cold]
        #[inline(never)]
        fn redundant_motion(&self, #parameters) -> #krate::constraint::RedundantMotion<#scalar, #n, #m> {
            #body
        }
    });
}

/// Writes the correction, computed in the same way.
pub(in crate::emit) fn write_redundant_correction(writer: &mut MethodWriter<'_>) {
    let (n, m) = (writer.model.speeds.len(), writer.model.constraints.len());
    let (krate, residuals) = (writer.shape.krate, writer.members.names.residuals.clone());
    let roots = entries(writer);
    let (body, _) = writer.lowered(&roots, Arguments::State, |results| {
        let [mass_matrix, jacobian] = matrices(results, n, m);
        quote!(#krate::constraint::redundant_correction(&#mass_matrix, &#jacobian, #residuals))
    });
    let (scalar, n) = (writer.shape.scalar(), length(n));
    let [parameters, _] = Arguments::Residuals.written(writer.shape, &writer.members.names);
    writer.members.hidden.extend(quote! {
        /// The correction where constraints depend on each other.
        #[cold]
        #[inline(never)]
        fn redundant_correction(&self, #parameters) -> [#scalar; #n] {
            #body
        }
    });
}

/// Returns the entries of M, then those of A.
fn entries(writer: &MethodWriter<'_>) -> Vec<ExprId> {
    [writer.equations.mass_matrix.concat(), writer.equations.constraints.jacobian.concat()].concat()
}

/// Assembles M and A from their entries.
fn matrices(entries: &[TokenStream], n: usize, m: usize) -> [TokenStream; 2] {
    let (mass_matrix, jacobian) = entries.split_at(n * n);
    [Returns::Matrix(n, n).collect(mass_matrix), Returns::Matrix(m, n).collect(jacobian)]
}
