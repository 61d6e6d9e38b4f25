//! What is emitted for switches: a field that fixes their sides, the functions that vanish on them, and what runs ask.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::derive::{Equations, Switch, one_sided};
use crate::diagnostics::Report;
use crate::emit::base::messages;
use crate::emit::base::method::{ArgumentNames, Arguments, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::state::state_variables;
use crate::emit::item::Parts;
use crate::emit::system::Writer;
use crate::expr::{ExprId, Graph};
use crate::formula::text;
use crate::program::Labels;
use crate::syntax::ast::Declaration;

/// The most events, switches among them, that runs can look for.
const MOST_EVENTS: usize = 64;
/// Surfaces with longer texts are not written out in messages.
const LONGEST_SURFACE: usize = 60;

/// Warns of switches beyond those that runs can look for.
pub fn report_unlocated(declaration: &Declaration, equations: &Equations, report: &mut Report) {
    let (all, room) =
        (equations.switches.len(), room_for_switches(&Shape::new(declaration, &TokenStream::new())));
    if all > room {
        let message = messages::unlocated_switches(all, room);
        report.doubtful(declaration.name.span, message).help(messages::UNLOCATED_HELP);
    }
}

/// How many switches runs can look for beside the events of the declaration.
fn room_for_switches(shape: &Shape<'_>) -> usize {
    MOST_EVENTS.saturating_sub(shape.event_names().len())
}

/// What messages call the surface of a switch.
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

/// Expressions with the sides of switches as symbols; names go over to what takes the place of what has them.
pub fn on_sides(
    graph: &mut Graph,
    labels: &mut Labels,
    switches: &[Switch],
    roots: &[ExprId],
) -> Vec<ExprId> {
    if switches.is_empty() {
        return roots.to_vec();
    }
    let image = one_sided(graph, switches, roots);
    let names = labels.iter().filter_map(|(id, name)| Some((*image.get(&id)?, name.to_owned())));
    let names = names.collect::<Vec<_>>();
    names.into_iter().for_each(|(id, name)| labels.insert(id, name));
    roots.iter().map(|root| image.get(root).copied().unwrap_or(*root)).collect()
}

impl Writer<'_> {
    /// The expressions on the sides of the switches that the system is on.
    pub(in crate::emit) fn on_sides(&mut self, roots: &[ExprId]) -> Vec<ExprId> {
        let switches = &self.equations.switches[..self.shape.switches.len()];
        on_sides(&mut self.model.graph, &mut self.labels, switches, roots)
    }

    /// The functions that vanish on the switches, the sides that follow from them, and times at which switches are passed.
    pub(in crate::emit) fn write_switches(&mut self) {
        let switches = &self.equations.switches[..self.shape.switches.len()];
        if switches.is_empty() {
            return;
        }
        let values = switches.iter().map(|switch| switch.value).collect::<Vec<_>>();
        let times = switches.iter().map(|switch| switch.time).collect::<Vec<_>>();
        let returns = Returns::Vector(values.len());
        let (body, _) =
            self.lowered_as_declared(&values, Arguments::State, |results| returns.collect(results));
        self.push_hidden("switch_functions", returns, &body);
        let (krate, field) = (self.shape.krate, self.shape.switches_field());
        let ArgumentNames { time, positions, velocities, .. } = &self.names;
        let call = quote!(self.switch_functions(#time, #positions, #velocities));
        let body = quote!(#krate::event::Switches::signs(self.#field, || #call));
        self.push_hidden("sides", returns, &body);
        self.write_switch_times(&times);
    }

    /// The body of `SwitchedSystem::switch_times`.
    fn write_switch_times(&mut self, times: &[Option<ExprId>]) {
        let known = times.iter().flatten().copied().collect::<Vec<_>>();
        if known.is_empty() {
            return;
        }
        let (body, _) = self.lowered_as_declared(&known, Arguments::None, |results| {
            let mut results = results.iter();
            let times = times.iter().map(|time| match time.and_then(|_| results.next()) {
                Some(time) => quote!(::core::option::Option::Some(#time)),
                None => quote!(::core::option::Option::None),
            });
            quote!([#(#times),*])
        });
        self.switch_times = Some(body);
    }
}

impl Shape<'_> {
    /// The same with the switches whose sides runs can fix.
    pub(in crate::emit) fn with_switches(mut self, graph: &Graph, equations: &Equations) -> Self {
        let located = equations.switches.iter().take(room_for_switches(&self));
        self.switches = located.map(|switch| surface_name(graph, switch)).collect();
        self
    }

    /// The field that fixes sides.
    pub(in crate::emit) fn switches_field(&self) -> Ident {
        let mut name = "switches".to_owned();
        let touching = self.touching.iter().map(|(name, _)| *name);
        let fields = self.fields.iter().copied().chain(touching).collect::<Vec<_>>();
        while fields.iter().any(|field| field.text == name) {
            name.push('_');
        }
        format_ident!("{name}")
    }
}

/// The field that fixes the sides of switches, as it is declared.
pub(in crate::emit) fn switches_declaration(shape: &Shape<'_>) -> Option<TokenStream> {
    let (krate, field) = (shape.krate, shape.switches_field());
    let field = quote! {
        /// On which sides of its switches the system is computed; runs fix them.
        pub #field: #krate::event::Switches,
    };
    (!shape.switches.is_empty()).then_some(field)
}

/// The same field in a literal of the struct, free.
pub(in crate::emit) fn free_switches(shape: &Shape<'_>) -> Option<TokenStream> {
    let field = shape.switches_field();
    (!shape.switches.is_empty()).then(|| quote!(#field: ::core::default::Default::default(),))
}

/// The same field in a literal of the struct, as it is in `self`.
pub(in crate::emit) fn kept_switches(shape: &Shape<'_>) -> Option<TokenStream> {
    let field = shape.switches_field();
    (!shape.switches.is_empty()).then(|| quote!(#field: self.#field,))
}

/// The events by which sides change.
pub(in crate::emit) fn switch_events(shape: &Shape<'_>) -> impl Iterator<Item = TokenStream> {
    let krate = shape.krate;
    shape.switches.iter().map(move |name| quote!(#krate::event::DeclaredEvent::side(#name)))
}

/// The members of `OdeSystem` by which runs end steps at known times.
pub(in crate::emit) fn timed_members(shape: &Shape<'_>, parts: &Parts) -> Option<TokenStream> {
    let (krate, scalar) = (shape.krate, shape.scalar());
    let (time, end) = (&parts.names.time, local("end"));
    let option = quote!(::core::option::Option);
    parts.switch_times.as_ref().map(|_| {
        quote! {
            fn next_restart(&self, #time: #scalar, #end: #scalar) -> #option<#scalar> {
                #krate::event::next_switch_time(self, #time, #end)
            }
            fn beyond(&self, #time: #scalar, #end: #scalar) -> #option<Self> {
                #krate::event::beyond(self, #time, #end)
            }
        }
    })
}

/// The implementation of `SwitchedSystem`.
pub(in crate::emit) fn switched_impl(shape: &Shape<'_>, parts: &Parts) -> TokenStream {
    if shape.switches.is_empty() {
        return TokenStream::new();
    }
    let (name, generics, bounds, scalar) = (shape.name(), shape.generics(), shape.bounds(), shape.scalar());
    let (krate, field, k) = (shape.krate, shape.switches_field(), length(shape.switches.len()));
    let (first, twice) = (length(shape.event_names().len()), length(2 * shape.coordinates.len()));
    let ArgumentNames { time, state, .. } = &parts.names;
    let (switches, others) = (local("switches"), shape.kept_fields(|_| true));
    let variables = state_variables(shape);
    let (positions, velocities) = variables.split_at(shape.coordinates.len());
    let option = quote!(::core::option::Option);
    let times = parts.switch_times.as_ref().map(|times| {
        quote! {
            fn switch_times(&self) -> [#option<#scalar>; #k] {
                #times
            }
        }
    });
    quote! {
        #[automatically_derived]
        impl #bounds #krate::event::SwitchedSystem<#k> for #name #generics {
            const FIRST: ::core::primitive::usize = #first;
            fn switches(&self) -> #krate::event::Switches {
                self.#field
            }
            fn with_switches(&self, #switches: #krate::event::Switches) -> Self {
                Self { #field: #switches, #others }
            }
            fn switch_values(&self, #time: #scalar, #state: &[#scalar; #twice]) -> [#scalar; #k] {
                let [#(#variables),*] = *#state;
                self.switch_functions(#time, &[#(#positions),*], &[#(#velocities),*])
            }
            #times
        }
    }
}
