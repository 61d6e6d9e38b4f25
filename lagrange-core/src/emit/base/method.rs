//! The methods of an emitted system.

use proc_macro2::{Ident, TokenStream};
use quote::quote;

use super::shape::{Shape, length};
use lagrange_algebra::code::Names;

/// The arguments of a method, in addition to the parameters.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(in crate::emit) enum Arguments {
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
    /// `t, q, shares`, with one share for each velocity
    Shares,
}

/// The result of a method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::emit) enum Returns {
    Scalar,
    Vector(usize),
    /// With this many rows and columns.
    Matrix(usize, usize),
    /// A rotation in rows and a position.
    Frame,
}

/// The names of the arguments, chosen so that they do not shadow names of the user.
#[derive(Clone, Debug)]
pub(in crate::emit) struct ArgumentNames {
    pub(in crate::emit) time: Ident,
    pub(in crate::emit) positions: Ident,
    pub(in crate::emit) velocities: Ident,
    pub(in crate::emit) accelerations: Ident,
    pub(in crate::emit) state: Ident,
    pub(in crate::emit) residuals: Ident,
    pub(in crate::emit) shares: Ident,
    /// Name of the closure that receives the items of a scene.
    pub(in crate::emit) visit: Ident,
    /// Name of the place over which a height is computed.
    pub(in crate::emit) place: Ident,
}

/// One method, ready to be written.
pub(in crate::emit) struct Method {
    pub(in crate::emit) name: Ident,
    pub(in crate::emit) docs: TokenStream,
    pub(in crate::emit) arguments: Arguments,
    pub(in crate::emit) returns: Returns,
    pub(in crate::emit) body: TokenStream,
}

impl ArgumentNames {
    /// Chooses distinct names that differ from those of the user.
    pub(in crate::emit) fn beside(user_names: &[String]) -> ArgumentNames {
        let mut names = Names::new(user_names.iter().map(String::as_str));
        let mut allocate = |wish: &str| names.fresh(wish);
        let [residuals, shares, visit, place] = ["residuals", "shares", "visit", "place"].map(&mut allocate);
        let mut either = |short: &str, long: &str| {
            let name = allocate(short);
            if name == short { name } else { allocate(long) }
        };
        ArgumentNames {
            time: either("t", "time"),
            positions: either("q", "positions"),
            velocities: either("v", "velocities"),
            accelerations: either("a", "accelerations"),
            state: either("y", "state"),
            residuals,
            shares,
            visit,
            place,
        }
    }
}

/// The names where the user has none.
impl Default for ArgumentNames {
    fn default() -> Self {
        ArgumentNames::beside(&[])
    }
}

impl Arguments {
    /// Returns the arguments that are vectors.
    pub(in crate::emit) fn vectors(self, names: &ArgumentNames) -> Vec<&Ident> {
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

    /// Returns the parameters of a method, with their types, and the arguments of its calls.
    pub(in crate::emit) fn written(self, shape: &Shape<'_>, names: &ArgumentNames) -> [TokenStream; 2] {
        let (scalar, time, vectors) = (shape.scalar(), &names.time, self.vectors(names));
        let lengths = vectors.iter().map(|&vector| match vector {
            _ if *vector == names.state => shape.state_length(),
            _ if *vector == names.residuals => length(shape.constraints.len()),
            _ if *vector == names.positions => shape.positions_length(),
            _ => shape.velocities_length(),
        });
        let parameters = quote!(#time: #scalar, #(#vectors: &[#scalar; #lengths]),*);
        [parameters, quote!(#time, #(#vectors),*)]
    }
}

impl Method {
    pub(in crate::emit) fn tokens(&self, shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
        let (docs, function) = (&self.docs, self.function(shape, names));
        quote! {
            #docs
            #[must_use]
            #[inline]
            pub #function
        }
    }

    /// Returns the method as a trait method.
    pub(in crate::emit) fn of_trait(&self, shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
        let function = self.function(shape, names);
        quote!(#[inline] #function)
    }

    fn function(&self, shape: &Shape<'_>, names: &ArgumentNames) -> TokenStream {
        let Method { name, body, .. } = self;
        let ([parameters, _], returns) =
            (self.arguments.written(shape, names), self.returns.tokens(&shape.scalar()));
        quote! {
            fn #name(&self, #parameters) -> #returns {
                #body
            }
        }
    }
}

impl Returns {
    /// Returns the count of numbers.
    pub(in crate::emit) fn count(self) -> usize {
        match self {
            Returns::Scalar => 1,
            Returns::Vector(n) => n,
            Returns::Matrix(rows, columns) => rows * columns,
            Returns::Frame => 12,
        }
    }

    pub(in crate::emit) fn tokens(self, scalar: &TokenStream) -> TokenStream {
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
            Returns::Frame => quote!(([[#scalar; 3]; 3], [#scalar; 3])),
        }
    }

    /// Writes the expression that arranges results in this form.
    pub(in crate::emit) fn collect(self, results: &[TokenStream]) -> TokenStream {
        match self {
            Returns::Scalar => quote!(#(#results)*),
            Returns::Vector(_) => quote!([#(#results),*]),
            Returns::Matrix(rows, columns) => {
                let rows = (0..rows).map(|i| &results[i * columns..][..columns]);
                let rows = rows.map(|row| quote!([#(#row),*]));
                quote!([#(#rows),*])
            }
            Returns::Frame => {
                let (rotation, origin) = results.split_at(9);
                let rotation = Returns::Matrix(3, 3).collect(rotation);
                quote!((#rotation, [#(#origin),*]))
            }
        }
    }
}
