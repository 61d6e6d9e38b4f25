//! Members for contacts and friction: fields for their modes, and the data that run-time code needs
//! for their forces.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::constrained::write_hooks;
use super::reaction_terms::touching_terms;
use super::switches::kept_switches;
use crate::emit::base::members::Members;
use crate::emit::base::messages;
use crate::emit::base::method::{ArgumentNames, Arguments, Returns};
use crate::emit::base::shape::{Shape, Touch, identifier, length, local};
use crate::emit::base::size::MAX_CONTACT_EVENTS;
use crate::emit::base::writer::MethodWriter;
use crate::model::{Model, ReactionKind};
use lagrange_algebra::program::OperationCounts;
use lagrange_expr::expr::{Dependencies, ExprId, Node};

/// Largest constant below a square root that only rounds a kink.
const ROUNDED_KINK: f64 = 1e-12;
const REACTIONS: [&str; 2] = [
    "Forces of contacts and friction in the order of their declaration: normal forces along the gradients of the gaps,",
    "friction forces along those of the slip velocities, in a plane along both.",
];
const MULTIPLIERS: [&str; 2] = [
    "Multipliers λ of the constraints in the order of their declaration, with the forces of contacts and friction that",
    "act in the present modes: M q̈ = f + Aᵀλ + Dᵀr.",
];

/// Writes `acceleration`, `multipliers` and `reactions`; returns the operations of the first
/// without reactions.
pub(in crate::emit) fn write_touching(writer: &mut MethodWriter<'_>, docs: &[&str]) -> OperationCounts {
    if !writer.model.constraints.is_empty() {
        write_hooks(writer);
    }
    writer.members.terms = touching_terms(writer);
    writer.members.limits_reverse = reversing_limits(writer.model);
    writer.members.gradients_jump = jumping_gradients(writer.model);
    writer.members.needs_steps = needs_steps(writer.shape, writer.model);
    let krate = writer.shape.krate;
    let ArgumentNames { time, positions, velocities, .. } = &writer.members.names;
    let system = quote!(#krate::contact::ContactSystem);
    let (terms, modes) = (local("terms"), quote!(&#system::modes(self)));
    let evaluated = quote!(let #terms = #system::terms(self, #time, #positions, #velocities););
    let forces = quote!(#krate::contact::reactions(&#terms, #modes));
    let otherwise = quote!(#evaluated #krate::contact::Terms::acceleration(&#terms, &#forces));
    let counts = write_acceleration(writer, docs, &otherwise);
    let body = quote!(#evaluated #forces);
    writer.push_method(
        "reactions",
        &REACTIONS,
        writer.model.reactions.len(),
        body,
        OperationCounts::default(),
    );
    let multipliers = writer.equations.reactions.multipliers.clone();
    if !multipliers.is_empty() {
        let returns = Returns::Vector(multipliers.len());
        let (body, counts) =
            writer.lowered(&multipliers, Arguments::State, |results| returns.collect(results));
        writer.push_method("multipliers", &MULTIPLIERS, multipliers.len(), body, counts);
    }
    counts
}

/// Writes the accelerations: without reactions if none acts, and otherwise by `otherwise`.
fn write_acceleration(
    writer: &mut MethodWriter<'_>,
    docs: &[&str],
    otherwise: &TokenStream,
) -> OperationCounts {
    let accelerations = writer.equations.accelerations.clone();
    let returns = Returns::Vector(accelerations.len());
    let (free, counts) = writer.lowered(&accelerations, Arguments::State, |results| returns.collect(results));
    let open = writer.shape.touching.iter().map(|(name, touch)| {
        let field = identifier(name);
        let krate = writer.shape.krate;
        (*touch == Touch::Contact).then(|| quote!(self.#field == #krate::contact::Contact::Open))
    });
    let body = match open.collect::<Option<Vec<_>>>() {
        Some(open) => quote!(if #(#open)&&* { #free } else { #otherwise }),
        None => otherwise.clone(),
    };
    writer.push_method("acceleration", docs, accelerations.len(), body, counts);
    counts
}

/// Returns the reason why only steps can simulate a system, if there is one.
pub(in crate::emit) fn needs_steps(shape: &Shape<'_>, model: &Model) -> Option<String> {
    let of_faces = contact_of_faces(shape, model)
        .map(|name| format!("the contact `{name}` of faces and edges needs the method `Stepped`"));
    of_faces.or_else(|| shape.shares_event.then(|| messages::many_contacts(MAX_CONTACT_EVENTS)))
}

/// Returns the first contact of faces and edges, whose gap contains a contact point.
fn contact_of_faces<'s>(shape: &'s Shape<'_>, model: &Model) -> Option<&'s str> {
    let graph = &model.graph;
    let is_point = |id: ExprId| matches!(graph.node(id), Node::Opaque(point, _) if point.is_contact_point());
    let place = model.reactions.iter().position(|reaction| match reaction.kind {
        ReactionKind::Contact { gap, .. } => graph.reachable(&[gap]).into_iter().any(is_point),
        _ => false,
    })?;
    let touching = shape.reactions()[place];
    Some(shape.written(shape.touching[touching].0))
}

/// Returns true for each friction whose limit contains constraint forces.
pub(in crate::emit) fn reversing_limits(model: &Model) -> Vec<bool> {
    let graph = &model.graph;
    let holds = |limit: ExprId| graph.dependencies(limit).intersects(Dependencies::MULTIPLIER);
    let reverses = |kind: &ReactionKind| match *kind {
        ReactionKind::Contact { .. } => false,
        ReactionKind::Friction { kinetic, fixed } | ReactionKind::Across { kinetic, fixed } => {
            holds(kinetic) || holds(fixed)
        }
        ReactionKind::Smooth { limit, .. } => holds(limit),
    };
    model.reactions.iter().map(|reaction| reverses(&reaction.kind)).collect()
}

/// Returns true for each contact whose gap has a rounded kink: the square root of a sum with a
/// constant that is almost zero. The lowest point of a rim jumps there.
pub(in crate::emit) fn jumping_gradients(model: &Model) -> Vec<bool> {
    let graph = &model.graph;
    let is_rounded = |base: ExprId| match graph.node(base) {
        Node::Sum { constant, .. } => constant.to_f64() > 0.0 && constant.to_f64() <= ROUNDED_KINK,
        _ => false,
    };
    let has_kink = |id: ExprId| match graph.node(id) {
        Node::Product(factors) => factors.iter().any(|(base, _)| is_rounded(*base)),
        _ => false,
    };
    let jumps = |kind: &ReactionKind| match *kind {
        ReactionKind::Contact { gap, .. } => graph.reachable(&[gap]).into_iter().any(has_kink),
        _ => false,
    };
    model.reactions.iter().map(|reaction| jumps(&reaction.kind)).collect()
}

/// Writes the declarations of the fields that store modes.
pub(in crate::emit) fn mode_fields(shape: &Shape<'_>) -> TokenStream {
    let krate = shape.krate;
    let fields = shape.touching.iter().filter_map(|(name, touch)| {
        let (field, of_type) = (identifier(name), mode_type(*touch)?);
        let docs = shape.docs(name, &format!("Mode of `{}`; events change it.", name.text));
        Some(quote!(#docs pub #field: #krate::contact::#of_type,))
    });
    fields.collect()
}

/// Writes the fields that store modes, with their defaults.
pub(in crate::emit) fn default_modes(shape: &Shape<'_>) -> TokenStream {
    shape
        .fields_of_modes()
        .map(|name| {
            let field = identifier(name);
            quote!(#field: ::core::default::Default::default(),)
        })
        .collect()
}

/// Writes the implementation of `ContactSystem`.
pub(in crate::emit) fn contact_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    if shape.touching.is_empty() {
        return TokenStream::new();
    }
    let (name, generics, bounds) = (shape.name(), shape.generics(), shape.bounds());
    let (krate, k) = (shape.krate, length(shape.reactions().len()));
    let nv = shape.velocities_length();
    let (terms, modes, event_of) = (terms_members(shape, members), mode_members(shape), event_of(shape));
    let names = shape.reactions().into_iter().map(|place| shape.written(shape.touching[place].0));
    let flags = |name: &str, flags: &[bool]| {
        let name = format_ident!("{name}");
        flags.contains(&true).then(|| quote!(const #name: [::core::primitive::bool; #k] = [#(#flags),*];))
    };
    let checked = members.ranges.is_some().then(|| {
        let scalar = shape.scalar();
        quote! {
            fn check(&self) -> ::core::result::Result<(), #krate::system::StepFailure<#scalar>> {
                self.check_parameters()?;
                ::core::result::Result::Ok(())
            }
        }
    });
    let needs_steps = members.needs_steps.as_ref().map(|message| {
        quote! {
            const NEEDS_STEPS: ::core::option::Option<&'static ::core::primitive::str> =
                ::core::option::Option::Some(#message);
        }
    });
    let reverse = flags("LIMITS_REVERSE", &members.limits_reverse);
    let jump = flags("GRADIENTS_JUMP", &members.gradients_jump);
    quote! {
        #[automatically_derived]
        impl #bounds #krate::contact::ContactSystem<#nv, #k> for #name #generics {
            const REACTIONS: [&'static ::core::primitive::str; #k] = [#(#names),*];
            #needs_steps
            #reverse
            #jump
            #modes
            #checked
            #terms
            #event_of
        }
    }
}

/// Writes `terms` and, without constraints, `step_terms`, of which it is then a special case.
fn terms_members(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let (krate, scalar, k) = (shape.krate, shape.scalar(), length(shape.reactions().len()));
    let (nv, [parameters, passed]) =
        (shape.velocities_length(), Arguments::State.written(shape, &members.names));
    let body = &members.terms;
    let step = if members.is_damped { local("step") } else { local("_step") };
    let slopes = length(members.slopes);
    let of_system = quote! {
        type Terms = #krate::contact::Terms<#scalar, #nv, #k, [#krate::contact::LimitSlope<#scalar>; #slopes]>;
    };
    if !members.is_forced {
        return quote!(#of_system #[inline] fn terms(&self, #parameters) -> Self::Terms { #body });
    }
    let zero = quote!(<#scalar as #krate::Number>::ZERO);
    quote! {
        #of_system
        #[inline]
        fn terms(&self, #parameters) -> Self::Terms {
            #krate::contact::ContactSystem::step_terms(self, #passed, #zero).accelerated()
        }
        #[inline]
        fn step_terms(
            &self,
            #parameters,
            #step: #scalar,
        ) -> #krate::contact::ForcedTerms<Self::Terms, #scalar, #nv> {
            #body
        }
    }
}

/// Writes the members that read modes from the fields, and copy a system with other modes.
fn mode_members(shape: &Shape<'_>) -> TokenStream {
    let reactions = shape.reactions();
    let (krate, other, k) = (shape.krate, local("modes"), length(reactions.len()));
    let modes = reactions.iter().enumerate().map(|(k, &place)| {
        let (name, touch) = shape.touching[place];
        let field = identifier(name);
        match mode_type(touch) {
            Some(_) if k > 0 && reactions[k - 1] == place => {
                quote!(#krate::contact::Mode::Across(self.#field))
            }
            Some(of_type) => quote!(#krate::contact::Mode::#of_type(self.#field)),
            None => quote!(#krate::contact::Mode::Smooth),
        }
    });
    let fields = shape.number_identifiers();
    let first = |place: usize| reactions.iter().position(|&other| other == place);
    let switched = shape.touching.iter().enumerate().filter_map(|(place, (name, touch))| {
        let (field, of_type, k) = (identifier(name), mode_type(*touch)?, length(first(place)?));
        Some(quote! {
            #field: match #other[#k] {
                #krate::contact::Mode::#of_type(mode) => mode,
                _ => self.#field,
            },
        })
    });
    let marker = shape.needs_marker().then(|| quote!(scalar: ::core::marker::PhantomData,));
    let switches = kept_switches(shape);
    quote! {
        #[inline]
        fn modes(&self) -> [#krate::contact::Mode; #k] {
            [#(#modes),*]
        }
        #[inline]
        fn in_modes(&self, #other: [#krate::contact::Mode; #k]) -> Self {
            Self { #(#fields: self.#fields,)* #(#switched)* #switches #marker }
        }
    }
}

/// Returns the event that switches the mode of each reaction; none for second components.
pub(in crate::emit) fn events_of_rows(shape: &Shape<'_>) -> Vec<Option<usize>> {
    let (events, places) = (shape.events_of_reactions(), shape.reactions());
    let is_first = |k: usize| k == 0 || places[k - 1] != places[k];
    places.iter().enumerate().map(|(k, &place)| events[place].filter(|_| is_first(k))).collect()
}

/// Writes the member that returns the event that switches the mode of a reaction.
fn event_of(shape: &Shape<'_>) -> TokenStream {
    let events = events_of_rows(shape).into_iter().enumerate().filter_map(|(k, event)| {
        let (k, event) = (length(k), length(event?));
        Some(quote!(#k => ::core::option::Option::Some(#event),))
    });
    quote! {
        #[inline]
        fn event_of(&self, k: ::core::primitive::usize) -> ::core::option::Option<::core::primitive::usize> {
            match k {
                #(#events)*
                _ => ::core::option::Option::None,
            }
        }
    }
}

/// Returns the name of the type that stores a mode.
fn mode_type(touch: Touch) -> Option<Ident> {
    match touch {
        Touch::Contact => Some(local("Contact")),
        Touch::Friction | Touch::Planar => Some(local("Friction")),
        Touch::Smooth => None,
    }
}
