//! Members of systems with constraints.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::redundant::{write_redundant_correction, write_redundant_motion};
use super::sparse::write_sparse_scales;
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments, Method, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::writer::MethodWriter;
use lagrange_algebra::calculus::gradient;
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::expr::ExprId;

/// Maximum number of coordinates for which dependent constraints are supported; a larger matrix
/// does not fit on the stack.
const LARGEST_REDUNDANT: usize = 100;

const MULTIPLIERS: [&str; 2] = [
    "Multipliers λ of the constraints in the order of their declaration: M q̈ = f + Aᵀλ. That of a",
    "constraint on a length is the force along it.",
];

/// Writes `acceleration`, `multipliers` and the methods of `ConstrainedSystem`; returns the
/// operations of the first.
pub(in crate::emit) fn write_constrained(writer: &mut MethodWriter<'_>, docs: &[&str]) -> OperationCounts {
    write_hooks(writer);
    if is_guarded(writer) {
        write_redundant_motion(writer);
    }
    let (accelerations, multipliers) =
        (writer.equations.accelerations.clone(), writer.equations.constraints.multipliers.clone());
    let counts = write_guarded(writer, "acceleration", docs, &accelerations, "acceleration");
    write_guarded(writer, "multipliers", &MULTIPLIERS, &multipliers, "multipliers");
    counts
}

/// Writes the methods of `ConstrainedSystem` with their own bodies.
pub(in crate::emit) fn write_hooks(writer: &mut MethodWriter<'_>) {
    write_correction(writer);
    write_position_residuals(writer);
    write_sparse_scales(writer);
    write_mass_times(writer);
    write_free_momentum_rates(writer);
    if is_guarded(writer) {
        write_redundant_correction(writer);
    }
}

/// Writes `CanonicalSystem::free_momentum_rates`.
fn write_free_momentum_rates(writer: &mut MethodWriter<'_>) {
    let Some(roots) = writer.equations.free_momentum_rates.clone() else { return };
    let returns = Returns::Vector(roots.len());
    let (body, _) = writer.lowered(&roots, Arguments::State, |results| returns.collect(results));
    let (name, docs) = (format_ident!("free_momentum_rates"), TokenStream::new());
    writer.members.canonical.push(Method { name, docs, arguments: Arguments::State, returns, body });
}

/// Writes a method that returns `roots`, or this field of the result of `redundant_motion` if
/// constraints are dependent.
fn write_guarded(
    writer: &mut MethodWriter<'_>,
    name: &str,
    docs: &[&str],
    roots: &[ExprId],
    field: &str,
) -> OperationCounts {
    let [_, passed] = Arguments::State.written(writer.shape, &writer.members.names);
    let field = local(field);
    let otherwise = quote!(self.redundant_motion(#passed).#field);
    let (body, counts) = guarded(writer, roots, Arguments::State, &otherwise);
    writer.push_method(name, docs, roots.len(), body, counts);
    counts
}

/// Writes a body that computes `roots`, with an alternative for dependent constraints.
fn guarded(
    writer: &mut MethodWriter<'_>,
    roots: &[ExprId],
    arguments: Arguments,
    otherwise: &TokenStream,
) -> (TokenStream, OperationCounts) {
    let constraints = &writer.equations.constraints;
    let returns = Returns::Vector(roots.len());
    if !is_guarded(writer) {
        return writer.lowered(roots, arguments, |results| returns.collect(results));
    }
    if constraints.is_redundant {
        return (otherwise.clone(), OperationCounts::default());
    }
    let (krate, values) = (writer.shape.krate, local("values"));
    let all = roots.iter().copied().chain(constraints.condition).collect::<Vec<_>>();
    writer.lowered(&all, arguments, |results| {
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

fn is_guarded(writer: &MethodWriter<'_>) -> bool {
    writer.model.speeds.len() <= LARGEST_REDUNDANT
}

/// Writes `ConstrainedSystem::correction`.
fn write_correction(writer: &mut MethodWriter<'_>) {
    let roots = writer.equations.constraints.correction.clone();
    let [_, passed] = Arguments::Residuals.written(writer.shape, &writer.members.names);
    let otherwise = quote!(self.redundant_correction(#passed));
    let (body, _) = guarded(writer, &roots, Arguments::Residuals, &otherwise);
    writer.push_constrained("correction", Arguments::Residuals, Returns::Vector(roots.len()), body);
}

/// Writes `ConstrainedSystem::mass_times`: M a is the gradient of a · ∂L/∂v with respect to the
/// velocities, which costs as much as the momenta.
fn write_mass_times(writer: &mut MethodWriter<'_>) {
    let (lagrangian, velocities) = (writer.model.lagrangian, writer.model.velocities());
    let changes = writer.model.speeds.iter().map(|speed| speed.acceleration).collect::<Vec<_>>();
    let graph = &mut writer.model.graph;
    let momenta = gradient(graph, lagrangian, &velocities);
    let products = momenta.iter().zip(&changes).map(|(&p, &change)| graph.multiply(p, change));
    let products = products.collect::<Vec<_>>();
    let product = graph.total(products);
    let roots = gradient(graph, product, &velocities);
    let returns = Returns::Vector(roots.len());
    let (body, _) = writer.lowered(&roots, Arguments::Motion, |results| returns.collect(results));
    writer.push_constrained("mass_times", Arguments::Motion, returns, body);
}

fn write_position_residuals(writer: &mut MethodWriter<'_>) {
    let zero = writer.model.graph.number(0);
    let residual = |constraint: &crate::model::Constraint| {
        if constraint.is_holonomic { constraint.value } else { zero }
    };
    let roots = writer.model.constraints.iter().map(residual).collect::<Vec<_>>();
    let returns = Returns::Vector(roots.len());
    let (body, _) = writer.lowered(&roots, Arguments::Positions, |results| returns.collect(results));
    writer.push_constrained("position_residuals", Arguments::Positions, returns, body);
}

/// Writes the methods that return states to the constraints.
pub(in crate::emit) fn projections(shape: &Shape<'_>, members: &Members) -> TokenStream {
    if members.constrained.is_empty() {
        return TokenStream::new();
    }
    let (krate, scalar) = (shape.krate, shape.scalar());
    let (nq, nv) = (shape.positions_length(), shape.velocities_length());
    let ArgumentNames { time, positions, velocities, .. } = &members.names;
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let violation = quote!(#krate::constraint::Violation<#scalar>);
    quote! {
        /// Takes positions and velocities to the nearest ones that satisfy the constraints: first
        /// positions, then velocities. The mass matrix at the result measures distances.
        ///
        /// # Errors
        /// If that does not succeed; both are then unchanged.
        #[inline]
        pub fn project(
            &self,
            #time: #scalar,
            #positions: &mut [#scalar; #nq],
            #velocities: &mut [#scalar; #nv],
        ) -> ::core::result::Result<(), #violation> {
            #krate::constraint::project(self, #passed)
        }

        /// The nearest velocities that satisfy the constraints at these positions.
        ///
        /// # Errors
        /// If there are none.
        #[inline]
        pub fn consistent_velocity(&self, #parameters) -> ::core::result::Result<[#scalar; #nv], #violation> {
            #krate::constraint::consistent_velocity(self, #passed)
        }
    }
}

/// True if states are projected onto constraints after each step.
pub(in crate::emit) fn is_projected(shape: &Shape<'_>, members: &Members) -> bool {
    !members.constrained.is_empty() && !shape.is_stabilised
}

/// Writes the implementation of `ConstrainedSystem`.
pub(in crate::emit) fn constrained_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    if members.constrained.is_empty() {
        return TokenStream::new();
    }
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, m) = (shape.krate, length(shape.constraints.len()));
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let methods = members.constrained.iter().map(|method| method.of_trait(shape, &members.names));
    let names = shape.constraints.iter().map(|name| shape.written(name));
    let has_scales = members.constrained.iter().any(|method| method.name == "residual_scales");
    let scales = (!has_scales).then(|| dense_scales(shape, members));
    quote! {
        #[automatically_derived]
        impl #bounds #krate::constraint::ConstrainedSystem for #name #generics {
            type Multipliers = [#scalar; #m];
            const CONSTRAINTS: &'static [&'static ::core::primitive::str] = &[#(#names),*];
            #[inline]
            fn multipliers(&self, #parameters) -> [#scalar; #m] {
                self.multipliers(#passed)
            }
            #[inline]
            fn velocity_residuals(&self, #parameters) -> [#scalar; #m] {
                self.constraint_velocity(#passed)
            }
            #scales
            #(#methods)*
        }
    }
}

/// Writes `residual_scales` by means of the Jacobian of the constraints.
fn dense_scales(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (krate, scalar, shares) = (shape.krate, shape.scalar(), local("shares"));
    let (nv, m) = (shape.velocities_length(), length(shape.constraints.len()));
    let [parameters, passed] = Arguments::Positions.written(shape, &members.names);
    quote! {
        #[inline]
        fn residual_scales(&self, #parameters, #shares: &[#scalar; #nv]) -> [#scalar; #m] {
            #krate::constraint::weighed(&self.constraint_jacobian(#passed), #shares)
        }
    }
}

/// Writes the members about constraints for methods that are symplectic for any mass matrix. If
/// there are more constraints than coordinates, some are dependent, and states are corrected after
/// steps.
pub(in crate::emit) fn canonical_constraints(shape: &Shape<'_>, members: &Members) -> TokenStream {
    if members.constrained.is_empty() || shape.constraints.len() > shape.coordinates.len() {
        return TokenStream::new();
    }
    let (krate, scalar, n) = (shape.krate, shape.scalar(), length(shape.coordinates.len()));
    let ArgumentNames { time, positions, .. } = &members.names;
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let methods = members.canonical.iter().map(|method| method.of_trait(shape, &members.names));
    let [residuals, rates, rows, values] = ["residuals", "rates", "rows", "values"].map(local);
    let pushes = members.are_holonomic.iter().enumerate().map(|(i, is_holonomic)| {
        let i = length(i);
        match is_holonomic {
            true => quote!(#values.push_holonomic(#residuals[#i], #rates[#i], &#rows[#i]);),
            false => quote!(#values.push_nonholonomic(#rates[#i], &#rows[#i]);),
        }
    });
    let position_residuals = members.are_holonomic.contains(&true).then(|| {
        let system = quote!(#krate::constraint::ConstrainedSystem);
        quote!(let #residuals = #system::position_residuals(self, #time, #positions);)
    });
    // Contacts and friction also constrain states.
    let is_all = shape.touching.is_empty();
    quote! {
        const SAYS_CONSTRAINTS: ::core::primitive::bool = #is_all;
        #(#methods)*
        #[inline]
        fn constraint_values(&self, #parameters) -> #krate::constraint::ConstraintValues<#scalar, [#scalar; #n]> {
            #position_residuals
            let #rates = self.constraint_velocity(#passed);
            let #rows = self.constraint_jacobian(#time, #positions);
            let mut #values = #krate::constraint::ConstraintValues::NONE;
            #(#pushes)*
            #values
        }
    }
}

/// Writes the implementation that leapfrog methods need to satisfy the constraints.
pub(in crate::emit) fn leapfrog_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, n) = (shape.krate, length(shape.coordinates.len()));
    let ArgumentNames { time, positions, .. } = &members.names;
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
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
                // The mass matrix does not depend on velocities, so any values are valid.
                #system::correction(self, #time, #positions, #positions, &residuals)
            }
            #[inline]
            fn velocity_correction(&self, #parameters) -> [#scalar; #n] {
                let residuals = self.constraint_velocity(#passed);
                #system::correction(self, #passed, &residuals)
            }
        }
    }
}
