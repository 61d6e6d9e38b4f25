//! Accelerations of systems without constraints whose mass matrix is not definite.

use quote::quote;

use crate::emit::base::method::{Arguments, Returns};
use crate::emit::base::shape::local;
use crate::emit::system::Writer;
use crate::expr::ExprId;
use crate::program::OperationCounts;

impl Writer<'_> {
    /// `acceleration`, which goes a second way where a pivot vanishes or is small; its operations. Mass matrix and forcing are there for
    /// it: most of them was computed anyway.
    pub(in crate::emit) fn write_indefinite(&mut self, docs: &[&str], growth: ExprId) -> OperationCounts {
        let equations = self.equations;
        let (krate, values) = (self.shape.krate, local("values"));
        let n = equations.accelerations.len();
        let roots =
            [&equations.accelerations[..], &equations.forcing, &equations.mass_matrix.concat(), &[growth]];
        let (body, counts) = self.lowered(&roots.concat(), Arguments::State, |results| {
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
        self.push_method("acceleration", docs, n, body, counts);
        counts
    }
}
