//! The methods of an emitted system.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::shape::{Shape, length};

/// What a method is a function of, beside the parameters.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Arguments {
    /// None.
    None,
    /// `t, q`
    Positions,
    /// `t, q, v`
    State,
    /// `t, q, v, a`
    Motion,
    /// `t, y`
    Whole,
    /// `t, q, v, residuals`
    Residuals,
    /// `t, q, shares`, of which there is one for each coordinate
    Shares,
}

/// What a method returns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Returns {
    Scalar,
    Vector(usize),
    /// With this many rows and columns.
    Matrix(usize, usize),
}

/// The names of the arguments, chosen so that they hide no name of the user.
#[derive(Clone, Debug)]
pub(super) struct ArgumentNames {
    pub(super) time: Ident,
    pub(super) positions: Ident,
    pub(super) velocities: Ident,
    pub(super) accelerations: Ident,
    pub(super) state: Ident,
    pub(super) residuals: Ident,
    pub(super) shares: Ident,
    /// What takes the items of a scene.
    pub(super) visit: Ident,
}

/// One method, ready to be written.
pub(super) struct Method {
    pub(super) name: Ident,
    pub(super) docs: TokenStream,
    pub(super) arguments: Arguments,
    pub(super) returns: Returns,
    pub(super) body: TokenStream,
}

impl Arguments {
    /// Those that are vectors.
    pub(super) fn vectors(self, names: &ArgumentNames) -> Vec<&Ident> {
        let ArgumentNames { positions, velocities, accelerations, state, residuals, shares, .. } = names;
        match self {
            Arguments::None => Vec::new(),
            Arguments::Positions => vec![positions],
            Arguments::State => vec![positions, velocities],
            Arguments::Motion => vec![positions, velocities, accelerations],
            Arguments::Whole => vec![state],
            Arguments::Residuals => vec![positions, velocities, residuals],
            Arguments::Shares => vec![positions, shares],
        }
    }
}

impl Method {
    pub(super) fn tokens(&self, shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
        let (docs, function) = (&self.docs, self.function(shape, names));
        quote! {
            #docs
            #[must_use]
            #[inline]
            pub #function
        }
    }

    /// As a method of a trait.
    pub(super) fn of_trait(&self, shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
        let function = self.function(shape, names);
        quote!(#[inline] #function)
    }

    fn function(&self, shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
        let Method { name, body, .. } = self;
        let (scalar, time) = (shape.scalar(), &names.time);
        let length = |vector: &Ident| match vector {
            _ if *vector == names.state => length(2 * shape.coordinates.len()),
            _ if *vector == names.residuals => length(shape.constraints.len()),
            _ => length(shape.coordinates.len()),
        };
        let vectors = self.arguments.vectors(names).into_iter().map(|vector| {
            let length = length(vector);
            quote!(#vector: &[#scalar; #length])
        });
        let returns = self.returns.tokens(&scalar);
        quote! {
            fn #name(&self, #time: #scalar, #(#vectors),*) -> #returns {
                #body
            }
        }
    }
}

impl Returns {
    /// How many numbers that are.
    pub(super) fn count(self) -> usize {
        match self {
            Returns::Scalar => 1,
            Returns::Vector(n) => n,
            Returns::Matrix(rows, columns) => rows * columns,
        }
    }

    pub(super) fn tokens(self, scalar: &TokenStream) -> TokenStream {
        match self {
            Returns::Scalar => scalar.clone(),
            Returns::Vector(n) => {
                let n = length(n);
                quote!([#scalar; #n])
            }
            Returns::Matrix(rows, columns) => {
                let (rows, columns) = (length(rows), length(columns));
                quote!([[#scalar; #columns]; #rows])
            }
        }
    }

    /// The expression that puts results into that form.
    pub(super) fn collect(self, results: &[TokenStream]) -> TokenStream {
        match self {
            Returns::Scalar => quote!(#(#results)*),
            Returns::Vector(_) => quote!([#(#results),*]),
            Returns::Matrix(rows, columns) => {
                let rows = (0..rows).map(|i| &results[i * columns..][..columns]);
                let rows = rows.map(|row| quote!([#(#row),*]));
                quote!([#(#rows),*])
            }
        }
    }
}
