//! The traits of `lagrange::system` that an emitted system implements, through its methods.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::base::fields::places;
use super::base::fingerprint::fingerprint;
use super::base::members::Members;
use super::base::method::{ArgumentNames, Arguments};
use super::base::shape::{Shape, length, local};
use super::features::clocks::{clock_members, next_tick};
use super::features::constrained::{canonical_constraints, constrained_impl, is_projected, leapfrog_impl};
use super::features::contacts::contact_impl;
use super::features::delays::{delay_member, delayed_impl};
use super::features::events::event_members;
use super::features::kernel::kernel_impl;
use super::features::lanes::with_lanes;
use super::features::laws::lagrangian_impl;
use super::features::linearised::linearised_impl;
use super::features::noise::noise_members;
use super::features::orientations::{orientation_members, position_rates};
use super::features::parametric::parametric_impl;
use super::features::ports::units_of_outputs;
use super::features::ranges::domain_member;
use super::features::regressor::regressor_impl;
use super::features::scene::scene_impl;
use super::features::switches::{switched_impl, timed_members};
use super::features::taylor::taylor_impl;
use super::features::units::units_constant;
use lagrange_language::syntax::ast::Name;

/// Returns the implementations of all traits for which the system has the methods.
pub(super) fn trait_impls(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (ode, mechanical) = (ode_impl(shape, members), mechanical_impl(shape, members));
    let energy = has(members, "energy").then(|| energy_impl(shape, members));
    let is_canonical = is_canonical(shape, members);
    let name = shape.name();
    let canonical = is_canonical.then(|| canonical_impl(shape, members, &name));
    let separable = members.is_separable.then(|| match members.constrained.is_empty() {
        true => separable_impl(shape, &name),
        false => leapfrog_impl(shape, members),
    });
    let constrained = constrained_impl(shape, members);
    let (contact, scene) = (contact_impl(shape, members), scene_impl(shape, members));
    let (switched, kernel) = (switched_impl(shape, members), kernel_impl(shape, members));
    let (parametric, delayed) = (parametric_impl(shape, members), delayed_impl(shape, members));
    let (taylor, linearised) = (taylor_impl(shape, members), linearised_impl(shape, members));
    let (lagrangian, regressor) = (lagrangian_impl(shape, members), regressor_impl(shape, members));
    // With constraints there is only a skeleton of the type.
    let is_whole = members.prepared.is_some() && members.constrained.is_empty();
    let prepared = is_whole.then(|| {
        let name = shape.prepared_name();
        let canonical = is_canonical.then(|| canonical_impl(shape, members, &name));
        let separable = members.is_separable.then(|| separable_impl(shape, &name));
        quote!(#canonical #separable)
    });
    quote!(#ode #mechanical #energy #separable #canonical #constrained #contact #switched #scene #prepared #kernel #taylor #linearised #lagrangian #regressor #parametric #delayed)
}

/// True if the system is a `CanonicalSystem`: momenta of angular velocities have no conjugate
/// coordinates.
fn is_canonical(shape: &Shape<'_>, members: &Members) -> bool {
    shape.velocities_are_rates() && has(members, "momentum_rates")
}

/// True if a method of this name exists.
fn has(members: &Members, name: &str) -> bool {
    members.methods.iter().any(|method| method.name == name)
}

fn ode_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, all) = (shape.krate, shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let jacobian = has(members, "jacobian").then(|| {
        quote! {
            #[inline]
            fn jacobian(
                &self,
                #time: #scalar,
                #state: &[#scalar; #all],
            ) -> ::core::option::Option<[[#scalar; #all]; #all]> {
                ::core::option::Option::Some(self.jacobian(#time, #state))
            }
        }
    });
    let undefined = undefined_member(shape, members);
    let (constrained, events) = (correct_members(shape, members), event_members(shape, members));
    let timed = timed_members(shape, members, next_tick(shape, members));
    let (clocks, noise) = (clock_members(shape, members), noise_members(shape, members));
    let (delays, domain) = (delay_member(shape), domain_member(shape, members));
    let lanes = with_lanes(shape, members);
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::OdeSystem for #name #generics {
            type Scalar = #scalar;
            type State = [#scalar; #all];
            #[inline]
            fn rhs(&self, #time: #scalar, #state: &[#scalar; #all]) -> [#scalar; #all] {
                self.rhs(#time, #state)
            }
            #undefined
            #jacobian
            #constrained
            #events
            #timed
            #clocks
            #noise
            #delays
            #domain
            #lanes
        }
    }
}

/// Maximum number of coordinates for which the mass matrix is tested for singularity. A larger one
/// would exhaust the stack.
const LARGEST_MASS_MATRIX: usize = 64;

/// Returns the member of `OdeSystem` that names non-finite quantities.
fn undefined_member(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (krate, scalar) = (shape.krate, shape.scalar());
    let ArgumentNames { time, state, positions, velocities, .. } = &members.names;
    let (all, rates) = (shape.state_length(), local("rates"));
    let inputs = named(shape, |name| shape.is_input(name));
    // With constraints a singular mass matrix may be valid.
    let determines = shape.constraints.is_empty() && shape.velocities.len() <= LARGEST_MASS_MATRIX;
    let mass_matrix = members.methods.iter().find(|method| determines && method.name == "mass_matrix");
    let mass_matrix = match mass_matrix.map(|method| method.arguments) {
        Some(Arguments::Positions) => {
            quote!(|#positions, _| ::core::option::Option::Some(self.mass_matrix(#time, #positions)))
        }
        Some(_) => quote! {
            |#positions, #velocities| ::core::option::Option::Some(self.mass_matrix(#time, #positions, #velocities))
        },
        None => quote!(|_, _| ::core::option::Option::None),
    };
    let found = quote! {
        #krate::integrate::undefined(self, (#time, #state, #rates), &[#(#inputs),*], #mass_matrix)
    };
    let unknowns = members.unknowns.as_ref().map(|unknowns| quote!(.with_unknowns(#time, &{ #unknowns })));
    let contacts = members.distances.as_ref().map(|apart| quote!(.with_contacts(#time, &{ #apart })));
    let found = match (&unknowns, &contacts) {
        (None, None) => found,
        _ => {
            let found_first = local("found");
            quote! {
                let #found_first = #found?;
                let (#positions, #velocities) = #krate::system::split::<Self>(#state);
                let (#positions, #velocities) = (&#positions, &#velocities);
                ::core::option::Option::Some(#found_first #unknowns #contacts)
            }
        }
    };
    quote! {
        fn undefined(
            &self,
            #time: #scalar,
            #state: &[#scalar; #all],
            #rates: &[#scalar; #all],
        ) -> ::core::option::Option<#krate::system::Undefined<#scalar>> {
            #found
        }
    }
}

/// Returns parameters or inputs, each with its name.
fn named(shape: &Shape<'_>, is_wanted: impl Fn(&Name) -> bool) -> Vec<TokenStream> {
    let fields = shape.fields.iter().zip(places(&shape.number_fields()));
    let wanted = fields.filter(|(name, _)| is_wanted(name)).map(|(name, place)| {
        let text = shape.written(name);
        quote!((#text, self.#place))
    });
    wanted.collect()
}

/// Returns the members of `OdeSystem` that project a state onto its invariants.
fn correct_members(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let (is_held, is_touching) = (!members.constrained.is_empty(), !shape.touching.is_empty());
    let (is_projected, is_oriented) = (is_projected(shape, members), !shape.quaternions.is_empty());
    let is_corrected = is_touching || is_projected || is_oriented;
    // Projections include this.
    let normalised =
        (is_oriented && !is_projected).then(|| quote!(#krate::system::normalise::<Self>(#state)?;));
    let touching = is_touching.then(|| quote!(#krate::contact::correct(self, #time, #state)?;));
    let outcome = quote!(::core::result::Result<(), #krate::system::StepFailure<#scalar>>);
    let correct = is_corrected.then(|| {
        let projected = is_projected.then(|| quote!(#krate::constraint::correct(self, #time, #state)?;));
        quote! {
            const IS_CONSTRAINED: ::core::primitive::bool = true;
            #[inline]
            fn correct(&self, #time: #scalar, #state: &mut [#scalar; #all]) -> #outcome {
                #projected
                #normalised
                #touching
                ::core::result::Result::Ok(())
            }
        }
    });
    // Initial states, and states assigned by events, must satisfy the constraints, however they are
    // maintained later.
    let others = (is_held || is_touching).then(|| {
        let members = ["admit", "restore"].map(|name| {
            let name = local(name);
            let held = is_held.then(|| quote!(#krate::constraint::#name(self, #time, #state)?;));
            let normalised =
                (is_oriented && !is_held).then(|| quote!(#krate::system::normalise::<Self>(#state)?;));
            quote! {
                #[inline]
                fn #name(&self, #time: #scalar, #state: &mut [#scalar; #all]) -> #outcome {
                    #held
                    #normalised
                    #touching
                    ::core::result::Result::Ok(())
                }
            }
        });
        members.into_iter().collect::<TokenStream>()
    });
    quote!(#correct #others)
}

fn mechanical_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, columns, state) = (shape.krate, shape.columns_name(), shape.state_name());
    let (nq, nv) = (shape.positions_length(), shape.velocities_length());
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let coordinates = shape.coordinates.iter().map(|name| shape.written(name));
    let (rates, oriented) = (position_rates(shape, members), orientation_members(shape, members));
    let parameter = parameter_member(shape);
    let fingerprint = Literal::u64_unsuffixed(fingerprint(shape.declaration));
    let units = units_constant(shape, units_of_outputs(shape, members), is_canonical(shape, members));
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::MechanicalSystem for #name #generics {
            type Coordinates = [#scalar; #nq];
            type Velocities = [#scalar; #nv];
            type Columns<C> = #columns<C>;
            const COORDINATES: &'static [&'static ::core::primitive::str] = &[#(#coordinates),*];
            #units
            const FINGERPRINT: ::core::primitive::u64 = #fingerprint;
            #[inline]
            fn acceleration(&self, #parameters) -> [#scalar; #nv] {
                self.acceleration(#passed)
            }
            #rates
            #oriented
            #parameter
        }
        #[automatically_derived]
        impl #bounds #krate::system::NamedSystem for #name #generics {
            type NamedState = #state #generics;
        }
    }
}

/// Returns the member of `MechanicalSystem` that returns the parameters.
fn parameter_member(shape: &Shape<'_>) -> Option<TokenStream> {
    let (scalar, index) = (shape.scalar(), local("index"));
    let parameters = named(shape, |name| !shape.is_input(name));
    (!parameters.is_empty()).then(|| {
        quote! {
            fn parameter(
                &self,
                #index: ::core::primitive::usize,
            ) -> ::core::option::Option<(&'static ::core::primitive::str, #scalar)> {
                [#(#parameters),*].get(#index).copied()
            }
        }
    })
}

fn energy_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, [parameters, passed]) = (shape.krate, Arguments::State.written(shape, &members.names));
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::EnergyFunction for #name #generics {
            #[inline]
            fn energy(&self, #parameters) -> #scalar {
                self.energy(#passed)
            }
        }
    }
}

fn canonical_impl(shape: &Shape<'_>, members: &Members, name: &Ident) -> TokenStream {
    let (generics, bounds, scalar) = (shape.generics(), shape.bounds(), shape.scalar());
    let (krate, n) = (shape.krate, length(shape.coordinates.len()));
    let mut mass_matrix = members.methods.iter().filter(|method| method.name == "mass_matrix");
    let arguments = mass_matrix.next().map_or(Arguments::State, |method| method.arguments);
    let [_, configuration] = arguments.written(shape, &members.names);
    let [parameters, passed] = Arguments::State.written(shape, &members.names);
    let constrained = canonical_constraints(shape, members);
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::CanonicalSystem for #name #generics {
            #[inline]
            fn momenta(&self, #parameters) -> [#scalar; #n] {
                self.momenta(#passed)
            }
            #[inline]
            fn momentum_rates(&self, #parameters) -> [#scalar; #n] {
                self.momentum_rates(#passed)
            }
            #[inline]
            fn mass_matrix(&self, #parameters) -> [[#scalar; #n]; #n] {
                self.mass_matrix(#configuration)
            }
            #constrained
        }
    }
}

fn separable_impl(shape: &Shape<'_>, name: &Ident) -> TokenStream {
    let (generics, bounds, krate) = (shape.generics(), shape.bounds(), shape.krate);
    quote! {
        #[automatically_derived]
        impl #bounds #krate::system::SeparableSystem for #name #generics {}
    }
}
