//! The linear equations of accelerations and multipliers, in blocks that are not coupled.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::emit::base::shape::{length, local};
use lagrange_algebra::series::SeriesPrograms;

/// Returns statements that compute accelerations and multipliers from residuals, block by block.
pub(super) fn solved(programs: &SeriesPrograms, partial: &Ident) -> TokenStream {
    let of_block = |(index, block): (usize, &Vec<usize>)| {
        let solver = solver_of(index);
        let residuals = block.iter().map(|unknown| length(programs.kept + unknown));
        let unknowns = block.iter().map(|&unknown| acceleration_of(unknown));
        quote!(let [#(#unknowns),*] = #solver.accelerations::<FUSED>(&[#(#partial[#residuals]),*]);)
    };
    programs.blocks.iter().enumerate().map(of_block).collect()
}

/// Returns the variable that holds an acceleration or a multiplier.
pub(super) fn acceleration_of(unknown: usize) -> Ident {
    local(&format!("acceleration_{unknown}"))
}

/// Returns the variable that holds the inverse of a block.
fn solver_of(block: usize) -> Ident {
    local(&format!("solver_{block}"))
}

/// Returns statements that invert the matrix, block by block.
pub(super) fn inverted(krate: &TokenStream, programs: &SeriesPrograms, inversion: &str) -> TokenStream {
    let (start, inversion) = (local("start"), format_ident!("{inversion}"));
    let unknowns = programs.blocks.iter().map(Vec::len).sum::<usize>();
    let of_block = |(index, block): (usize, &Vec<usize>)| {
        let solver = solver_of(index);
        let row = |i: usize| block.iter().map(move |j| length(programs.initials + i * unknowns + j));
        let entries = block.iter().flat_map(|&i| row(i));
        quote!(let #solver = #krate::private::SeriesSolver::#inversion([#(#start[#entries]),*]);)
    };
    programs.blocks.iter().enumerate().map(of_block).collect()
}
