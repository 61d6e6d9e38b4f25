//! Members for white noise: the diffusions, and their contribution to the state.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::derive::DiffusionKind;
use crate::emit::base::members::{Members, Noisy};
use crate::emit::base::method::{ArgumentNames, Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, doc, length, local};
use crate::emit::base::writer::MethodWriter;

/// Writes `diffusion` if there is noise.
pub(in crate::emit) fn write_diffusion(writer: &mut MethodWriter<'_>) {
    let diffusion = writer.equations.diffusion.clone();
    let Some(first) = diffusion.columns.first() else { return };
    let (arguments, returns) = (Arguments::Whole, Returns::Matrix(diffusion.columns.len(), first.len()));
    let (body, _) =
        writer.lowered(&diffusion.columns.concat(), arguments, |results| returns.collect(results));
    let names = writer.model.noises.iter().map(|noise| format!("`{}`", noise.name)).collect::<Vec<_>>();
    let docs = [
        format!(
            "Diffusions of the noises {}, in rows: entry `[k][i]` is the factor of the",
            names.join(", ")
        ),
        "increment of Wiener process k in that of entry `i` of the state.".to_owned(),
    ];
    let docs = docs.iter().map(|line| doc(line)).collect();
    writer.members.methods.push(Method { name: format_ident!("diffusion"), docs, arguments, returns, body });
    writer.members.noise = Some(Noisy { count: diffusion.columns.len(), kind: diffusion.kind });
}

/// Returns the members of `OdeSystem` by which integration methods handle noise.
pub(in crate::emit) fn noise_members(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let Noisy { count, kind } = members.noise?;
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let [increments, increment, change, column, entry, factor, sum] =
        ["increments", "increment", "change", "column", "entry", "factor", "sum"].map(local);
    let kind = match kind {
        DiffusionKind::Additive => quote!(Additive),
        DiffusionKind::Unambiguous => quote!(Unambiguous),
        DiffusionKind::Multiplicative => quote!(Multiplicative),
    };
    let count = length(count);
    Some(quote! {
        #[inline]
        fn noise(&self) -> #krate::system::WhiteNoise {
            #krate::system::WhiteNoise { count: #count, kind: #krate::system::NoiseKind::#kind }
        }
        #[inline]
        fn diffuse(
            &self,
            #time: #scalar,
            #state: &[#scalar; #all],
            #increments: &[#scalar],
        ) -> [#scalar; #all] {
            let mut #change = [<#scalar as #krate::Number>::ZERO; #all];
            for (#column, #increment) in self.diffusion(#time, #state).iter().zip(#increments) {
                for (#entry, #factor) in #change.iter_mut().zip(#column) {
                    let #sum = *#entry + *#factor * *#increment;
                    *#entry = #sum;
                }
            }
            #change
        }
    })
}
