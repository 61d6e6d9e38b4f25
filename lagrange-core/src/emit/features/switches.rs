//! Members for switches: a field that fixes their sides, the functions that vanish on them, and the
//! queries of runs.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::derive::{Equations, Switch};
use crate::emit::base::members::Members;
use crate::emit::base::messages;
use crate::emit::base::method::{ArgumentNames, Arguments, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::state::state_variables;
use crate::emit::base::writer::MethodWriter;
use crate::model::Model;
use lagrange_algebra::formula::text;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::limits::MAX_LOCATED;
use lagrange_language::syntax::ast::{Declaration, Name};

/// Maximum length of a surface that messages write out.
const LONGEST_SURFACE: usize = 60;

/// Warns about switches beyond the number that runs can locate.
pub(in crate::emit) fn report_unlocated(
    declaration: &Declaration,
    equations: &Equations,
    report: &mut Report,
) {
    let (all, room) =
        (equations.switches.len(), room_for_switches(&Shape::new(declaration, &TokenStream::new())));
    if all > room {
        let message = messages::unlocated_switches(all, room);
        report.doubtful(declaration.name.span, message).help(messages::UNLOCATED_HELP);
    }
}

/// Returns the shape of a derived system, with the switches whose sides runs can fix, units, and
/// derived outputs.
pub(in crate::emit) fn derived_shape<'a>(
    declaration: &'a Declaration,
    krate: &'a TokenStream,
    model: &Model,
    equations: &Equations,
) -> Shape<'a> {
    let mut shape = Shape::new(declaration, krate);
    let located = equations.switches.iter().take(room_for_switches(&shape));
    shape.switches = located.map(|switch| surface_name(&model.graph, switch)).collect();
    shape.units = model.units.clone();
    let derived = model.outputs.iter().filter(|output| output.description.is_some());
    let span = declaration.name.span;
    shape
        .outputs
        .extend(derived.map(|output| (Name::new(output.name.clone(), span), output.components.len())));
    shape
}

/// Returns the number of switches that runs can locate in addition to the declared events.
fn room_for_switches(shape: &Shape<'_>) -> usize {
    MAX_LOCATED.saturating_sub(shape.event_names().len())
}

/// Returns the name of the surface of a switch in messages.
fn surface_name(graph: &Graph, switch: &Switch) -> String {
    let surface = match text::definitions(graph, &[switch.value], LONGEST_SURFACE) {
        (abbreviations, texts) if abbreviations.is_empty() => format!("`{}`", texts.concat()),
        _ => "an expression".to_owned(),
    };
    match &switch.statement {
        Some(statement) => format!("{surface} in `{statement}`"),
        None => surface,
    }
}

/// Writes the functions that vanish on the switches, the sides that follow from them, and the times
/// at which switches are crossed.
pub(in crate::emit) fn write_switches(writer: &mut MethodWriter<'_>) {
    let switches = &writer.equations.switches[..writer.shape.switches.len()];
    if switches.is_empty() {
        return;
    }
    let values = switches.iter().map(|switch| switch.value).collect::<Vec<_>>();
    let times = switches.iter().map(|switch| switch.time).collect::<Vec<_>>();
    let returns = Returns::Vector(values.len());
    let (body, _) = writer.lowered_as_declared(&values, Arguments::State, |results| returns.collect(results));
    writer.push_hidden("switch_functions", returns, body);
    let (krate, field) = (writer.shape.krate, switches_field(writer.shape));
    let ArgumentNames { time, positions, velocities, .. } = &writer.members.names;
    let call = quote!(self.switch_functions(#time, #positions, #velocities));
    let body = quote!(#krate::event::Switches::signs(self.#field, || #call));
    writer.push_hidden("sides", returns, body);
    write_switch_times(writer, &times);
}

/// Writes the body of `SwitchedSystem::switch_times`.
fn write_switch_times(writer: &mut MethodWriter<'_>, times: &[Option<ExprId>]) {
    let known = times.iter().flatten().copied().collect::<Vec<_>>();
    if known.is_empty() {
        return;
    }
    let (body, _) = writer.lowered_as_declared(&known, Arguments::None, |results| {
        let mut results = results.iter();
        let times = times.iter().map(|time| match time.and_then(|_| results.next()) {
            Some(time) => quote!(::core::option::Option::Some(#time)),
            None => quote!(::core::option::Option::None),
        });
        quote!([#(#times),*])
    });
    writer.members.switch_times = Some(body);
}

/// Returns the name of the field that fixes sides.
fn switches_field(shape: &Shape<'_>) -> Ident {
    let mut name = "switches".to_owned();
    let touching = shape.touching.iter().map(|(name, _)| *name);
    let fields = shape.number_identifiers().into_iter().map(|field| field.to_string());
    let fields = fields.chain(touching.map(|name| name.text.clone())).collect::<Vec<_>>();
    while fields.contains(&name) {
        name.push('_');
    }
    format_ident!("{name}")
}

/// Writes the declaration of the field that fixes the sides of switches.
pub(in crate::emit) fn switches_declaration(shape: &Shape<'_>) -> Option<TokenStream> {
    let (krate, field) = (shape.krate, switches_field(shape));
    let field = quote! {
        /// On which sides of its switches the system is computed; runs fix them.
        pub #field: #krate::event::Switches,
    };
    (!shape.switches.is_empty()).then_some(field)
}

/// Writes the field in a literal of the struct, with free sides.
pub(in crate::emit) fn free_switches(shape: &Shape<'_>) -> Option<TokenStream> {
    let field = switches_field(shape);
    (!shape.switches.is_empty()).then(|| quote!(#field: ::core::default::Default::default(),))
}

/// Writes the field in a literal of the struct, with its value in `self`.
pub(in crate::emit) fn kept_switches(shape: &Shape<'_>) -> Option<TokenStream> {
    let field = switches_field(shape);
    (!shape.switches.is_empty()).then(|| quote!(#field: self.#field,))
}

/// Writes the events at which sides change.
pub(in crate::emit) fn switch_events(shape: &Shape<'_>) -> impl Iterator<Item = TokenStream> {
    let krate = shape.krate;
    shape.switches.iter().map(move |name| quote!(#krate::event::DeclaredEvent::side(#name)))
}

/// Writes the members of `OdeSystem` with which runs end steps at known times, when switches are
/// crossed and clocks tick.
pub(in crate::emit) fn timed_members(
    shape: &Shape<'_>,
    members: &Members,
    next_tick: Option<TokenStream>,
) -> Option<TokenStream> {
    let (krate, scalar) = (shape.krate, shape.scalar());
    let (time, end) = (&members.names.time, local("end"));
    let option = quote!(::core::option::Option);
    let is_timed = members.switch_times.is_some();
    let passage = is_timed.then(|| quote!(#krate::event::next_switch_time(self, #time, #end)));
    let next = match (passage, next_tick) {
        (Some(passage), Some(tick)) => quote!(#krate::event::earlier(#passage, #tick)),
        (passage, tick) => passage.or(tick)?,
    };
    let beyond = is_timed.then(|| {
        quote! {
            fn beyond(&self, #time: #scalar, #end: #scalar) -> #option<Self> {
                #krate::event::beyond(self, #time, #end)
            }
        }
    });
    Some(quote! {
        fn next_restart(&self, #time: #scalar, #end: #scalar) -> #option<#scalar> {
            #next
        }
        #beyond
    })
}

/// Writes the implementation of `SwitchedSystem`.
pub(in crate::emit) fn switched_impl(shape: &Shape<'_>, members: &Members) -> TokenStream {
    if shape.switches.is_empty() {
        return TokenStream::new();
    }
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, field) = (shape.krate, switches_field(shape));
    let (first, all) = (length(shape.event_names().len()), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let (switches, values) = (local("switches"), local("values"));
    let others = shape.kept_fields(|_| true);
    let variables = state_variables(shape);
    let (positions, velocities) = variables.split_at(shape.coordinates.len());
    let option = quote!(::core::option::Option);
    let times = members.switch_times.as_ref().map(|times| {
        quote! {
            fn switch_times(&self) -> impl ::core::iter::Iterator<Item = #option<#scalar>> {
                ::core::iter::IntoIterator::into_iter({ #times })
            }
        }
    });
    quote! {
        #[automatically_derived]
        impl #bounds #krate::event::SwitchedSystem for #name #generics {
            const FIRST: ::core::primitive::usize = #first;
            fn switches(&self) -> #krate::event::Switches {
                self.#field
            }
            fn with_switches(&self, #switches: #krate::event::Switches) -> Self {
                Self { #field: #switches, #others }
            }
            fn switch_values(&self, #time: #scalar, #state: &[#scalar; #all], #values: &mut [#scalar]) {
                let [#(#variables),*] = *#state;
                #values.copy_from_slice(&self.switch_functions(#time, &[#(#positions),*], &[#(#velocities),*]));
            }
            #times
        }
    }
}
