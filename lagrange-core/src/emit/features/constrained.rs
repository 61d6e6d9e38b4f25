//! What is emitted for systems with constraints.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use crate::calculus::gradient;
use crate::emit::base::method::{ArgumentNames, Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::item::Parts;
use crate::emit::system::Writer;
use crate::expr::ExprId;
use crate::program::OperationCounts;

/// With more coordinates than this a matrix of them is too large for the stack, and dependent constraints are not made good.
const LARGEST_REDUNDANT: usize = 100;

const MULTIPLIERS: [&str; 2] = [
    "Multipliers λ of the constraints in the order of their declaration: M q̈ = f + Aᵀλ. That of a",
    "constraint on a length is the force along it.",
];

impl Writer<'_> {
    /// `acceleration` and `multipliers`, and the methods of `ConstrainedSystem`; the operations of the first.
    pub(in crate::emit) fn write_constrained(&mut self, docs: &[&str]) -> OperationCounts {
        self.write_hooks();
        if self.is_guarded() {
            self.write_redundant_motion();
        }
        let (accelerations, multipliers) =
            (self.equations.accelerations.clone(), self.equations.constraints.multipliers.clone());
        let counts = self.write_guarded("acceleration", docs, &accelerations, "acceleration");
        self.write_guarded("multipliers", &MULTIPLIERS, &multipliers, "multipliers");
        counts
    }

    /// The methods of `ConstrainedSystem` that need bodies of their own.
    pub(in crate::emit) fn write_hooks(&mut self) {
        self.write_correction();
        self.write_position_residuals();
        self.write_sparse_scales();
        self.write_mass_times();
        self.write_free_momentum_rates();
        if self.is_guarded() {
            self.write_redundant_correction();
        }
    }

    /// What `CanonicalSystem::free_momentum_rates` does.
    fn write_free_momentum_rates(&mut self) {
        let Some(roots) = self.equations.free_momentum_rates.clone() else { return };
        let returns = Returns::Vector(roots.len());
        let (body, _) = self.lowered(&roots, Arguments::State, |results| returns.collect(results));
        let (name, docs) = (format_ident!("free_momentum_rates"), TokenStream::new());
        self.canonical.push(Method { name, docs, arguments: Arguments::State, returns, body });
    }

    /// A method that returns `roots`, or where constraints depend on each other this field of what `redundant_motion` returns.
    fn write_guarded(&mut self, name: &str, docs: &[&str], roots: &[ExprId], field: &str) -> OperationCounts {
        let ArgumentNames { time, positions, velocities, .. } = &self.names;
        let field = local(field);
        let otherwise = quote!(self.redundant_motion(#time, #positions, #velocities).#field);
        let (body, counts) = self.guarded(roots, Arguments::State, &otherwise);
        self.push_method(name, docs, roots.len(), body, counts);
        counts
    }

    /// A body that computes `roots`, but does something else where constraints depend on each other.
    fn guarded(
        &mut self,
        roots: &[ExprId],
        arguments: Arguments,
        otherwise: &TokenStream,
    ) -> (TokenStream, OperationCounts) {
        let constraints = &self.equations.constraints;
        let returns = Returns::Vector(roots.len());
        if !self.is_guarded() {
            return self.lowered(roots, arguments, |results| returns.collect(results));
        }
        if constraints.is_redundant {
            return (otherwise.clone(), OperationCounts::default());
        }
        let (krate, values) = (self.shape.krate, local("values"));
        let all = roots.iter().copied().chain(constraints.condition).collect::<Vec<_>>();
        self.lowered(&all, arguments, |results| {
            let (results, condition) = results.split_at(roots.len());
            let list = returns.collect(results);
            let test = match condition {
                [] => quote!(are_finite(&#values)),
                condition => quote!(are_regular(&#values, #(#condition)*)),
            };
            quote! {
                let #values = #list;
                if #krate::constraint::#test { #values } else { #otherwise }
            }
        })
    }

    fn is_guarded(&self) -> bool {
        self.model.coordinates.len() <= LARGEST_REDUNDANT
    }

    /// What `ConstrainedSystem::correction` does.
    fn write_correction(&mut self) {
        let roots = self.equations.constraints.correction.clone();
        let ArgumentNames { time, positions, velocities, residuals, .. } = &self.names;
        let otherwise = quote!(self.redundant_correction(#time, #positions, #velocities, #residuals));
        let (body, _) = self.guarded(&roots, Arguments::Residuals, &otherwise);
        self.push_constrained("correction", Arguments::Residuals, Returns::Vector(roots.len()), body);
    }

    /// What `ConstrainedSystem::mass_times` does: M a is the gradient of a · ∂L/∂v by the velocities, which takes as long as the momenta.
    fn write_mass_times(&mut self) {
        let (lagrangian, velocities) = (self.model.lagrangian, self.model.velocities());
        let changes = self.model.coordinates.iter().map(|c| c.acceleration).collect::<Vec<_>>();
        let graph = &mut self.model.graph;
        let momenta = gradient(graph, lagrangian, &velocities);
        let products = momenta.iter().zip(&changes).map(|(&p, &change)| graph.multiply(p, change));
        let products = products.collect::<Vec<_>>();
        let product = graph.total(products);
        let roots = gradient(graph, product, &velocities);
        let returns = Returns::Vector(roots.len());
        let (body, _) = self.lowered(&roots, Arguments::Motion, |results| returns.collect(results));
        self.push_constrained("mass_times", Arguments::Motion, returns, body);
    }

    fn write_position_residuals(&mut self) {
        let zero = self.model.graph.number(0);
        let residual = |constraint: &crate::model::Constraint| {
            if constraint.is_holonomic { constraint.value } else { zero }
        };
        let roots = self.model.constraints.iter().map(residual).collect::<Vec<_>>();
        let returns = Returns::Vector(roots.len());
        let (body, _) = self.lowered(&roots, Arguments::Positions, |results| returns.collect(results));
        self.push_constrained("position_residuals", Arguments::Positions, returns, body);
    }

    pub(in crate::emit) fn push_constrained(
        &mut self,
        name: &str,
        arguments: Arguments,
        returns: Returns,
        body: TokenStream,
    ) {
        let name = format_ident!("{name}");
        self.constrained.push(Method { name, docs: TokenStream::new(), arguments, returns, body });
    }
}

/// The methods by which users get back onto the constraints.
pub(in crate::emit) fn projections(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    if parts.constrained.is_empty() {
        return TokenStream::new();
    }
    let (krate, scalar, n) = (shape.krate, shape.scalar(), length(shape.coordinates.len()));
    let ArgumentNames { time, positions, velocities, .. } = &parts.names;
    let violation = quote!(#krate::constraint::Violation<#scalar>);
    quote! {
        /// Takes positions and velocities to the nearest ones that satisfy the constraints, as the mass matrix where they
        /// are found measures distances: first positions, then velocities.
        ///
        /// # Errors
        /// If that does not succeed; both are then what they were.
        #[inline]
        pub fn project(
            &self,
            #time: #scalar,
            #positions: &mut [#scalar; #n],
            #velocities: &mut [#scalar; #n],
        ) -> ::core::result::Result<(), #violation> {
            #krate::constraint::project(self, #time, #positions, #velocities)
        }

        /// The nearest velocities that satisfy the constraints at these positions.
        ///
        /// # Errors
        /// If there are none.
        #[inline]
        pub fn consistent_velocity(
            &self,
            #time: #scalar,
            #positions: &[#scalar; #n],
            #velocities: &[#scalar; #n],
        ) -> ::core::result::Result<[#scalar; #n], #violation> {
            #krate::constraint::consistent_velocity(self, #time, #positions, #velocities)
        }
    }
}

/// The implementation of `ConstrainedSystem`.
pub(in crate::emit) fn constrained_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    if parts.constrained.is_empty() {
        return TokenStream::new();
    }
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, n, m) = (shape.krate, length(shape.coordinates.len()), length(shape.constraints.len()));
    let ArgumentNames { time, positions, velocities, .. } = &parts.names;
    let parameters = quote!(&self, #time: #scalar, #positions: &[#scalar; #n], #velocities: &[#scalar; #n]);
    let methods = parts.constrained.iter().map(|method| method.of_trait(shape, &parts.names));
    let names = shape.constraints.iter().map(|name| &name.text);
    let has_scales = parts.constrained.iter().any(|method| method.name == "residual_scales");
    let scales = (!has_scales).then(|| dense_scales(shape, parts));
    quote! {
        #[automatically_derived]
        impl #bounds #krate::constraint::ConstrainedSystem for #name #generics {
            type Multipliers = [#scalar; #m];
            const CONSTRAINTS: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            #[inline]
            fn multipliers(#parameters) -> [#scalar; #m] {
                self.multipliers(#time, #positions, #velocities)
            }
            #[inline]
            fn velocity_residuals(#parameters) -> [#scalar; #m] {
                self.constraint_velocity(#time, #positions, #velocities)
            }
            #scales
            #(#methods)*
        }
    }
}

/// `residual_scales` by way of the Jacobian of the constraints.
fn dense_scales(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let (krate, scalar, shares) = (shape.krate, shape.scalar(), local("shares"));
    let (n, m) = (length(shape.coordinates.len()), length(shape.constraints.len()));
    let ArgumentNames { time, positions, .. } = &parts.names;
    quote! {
        #[inline]
        fn residual_scales(
            &self,
            #time: #scalar,
            #positions: &[#scalar; #n],
            #shares: &[#scalar; #n],
        ) -> [#scalar; #m] {
            #krate::constraint::weighed(&self.constraint_jacobian(#time, #positions), #shares)
        }
    }
}

/// What methods that are symplectic for any mass matrix must know of the constraints.
pub(in crate::emit) fn canonical_constraints(
    shape: &Shape<'_>,
    parts: &Parts,
    parameters: &TokenStream,
) -> TokenStream {
    if parts.constrained.is_empty() {
        return TokenStream::new();
    }
    let (krate, scalar, n) = (shape.krate, shape.scalar(), length(shape.coordinates.len()));
    let ArgumentNames { time, positions, velocities, .. } = &parts.names;
    let methods = parts.canonical.iter().map(|method| method.of_trait(shape, &parts.names));
    let [residuals, rates, rows, values] = ["residuals", "rates", "rows", "values"].map(local);
    let pushes = parts.are_holonomic.iter().enumerate().map(|(i, is_holonomic)| {
        let i = length(i);
        match is_holonomic {
            true => quote!(#values.push_holonomic(#residuals[#i], #rates[#i], &#rows[#i]);),
            false => quote!(#values.push_nonholonomic(#rates[#i], &#rows[#i]);),
        }
    });
    let position_residuals = parts.are_holonomic.contains(&true).then(|| {
        let system = quote!(#krate::constraint::ConstrainedSystem);
        quote!(let #residuals = #system::position_residuals(self, #time, #positions);)
    });
    // Contacts and friction hold states, too.
    let is_all = shape.touching.is_empty();
    quote! {
        const SAYS_CONSTRAINTS: ::core::primitive::bool = #is_all;
        #(#methods)*
        #[inline]
        fn constraint_values(#parameters) -> #krate::constraint::ConstraintValues<#scalar, [#scalar; #n]> {
            #position_residuals
            let #rates = self.constraint_velocity(#time, #positions, #velocities);
            let #rows = self.constraint_jacobian(#time, #positions);
            let mut #values = #krate::constraint::ConstraintValues::NONE;
            #(#pushes)*
            #values
        }
    }
}

/// What leapfrog methods need to stay on the constraints.
pub(in crate::emit) fn leapfrog_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, n) = (shape.krate, length(shape.coordinates.len()));
    let ArgumentNames { time, positions, velocities, .. } = &parts.names;
    let [later, to] = ["later", "to"].map(local);
    let system = quote!(#krate::constraint::ConstrainedSystem);
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::LeapfrogSystem for #name #generics {
            const IS_HELD: ::core::primitive::bool = true;
            #[inline]
            fn position_correction(
                &self,
                #time: #scalar,
                #positions: &[#scalar; #n],
                #later: #scalar,
                #to: &[#scalar; #n],
            ) -> [#scalar; #n] {
                let residuals = #system::position_residuals(self, #later, #to);
                // The mass matrix does not depend on velocities, which anything may stand for.
                #system::correction(self, #time, #positions, #positions, &residuals)
            }
            #[inline]
            fn velocity_correction(
                &self,
                #time: #scalar,
                #positions: &[#scalar; #n],
                #velocities: &[#scalar; #n],
            ) -> [#scalar; #n] {
                let residuals = self.constraint_velocity(#time, #positions, #velocities);
                #system::correction(self, #time, #positions, #velocities, &residuals)
            }
        }
    }
}
