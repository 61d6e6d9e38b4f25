//! Members for declared events.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::switches::switch_events;
use crate::emit::base::members::Members;
use crate::emit::base::method::{ArgumentNames, Arguments, Returns};
use crate::emit::base::shape::{Shape, length, local};
use crate::emit::base::size::shares_event;
use crate::emit::base::state::state_variables;
use crate::emit::base::writer::MethodWriter;
use crate::model::{Action, Assignment, Event, Model};
use lagrange_language::syntax::ast::{self, Declaration, Direction};

/// Writes the functions of the events, and the states after assignments.
pub(in crate::emit) fn write_events(writer: &mut MethodWriter<'_>) {
    let events = separate_events(writer.shape.declaration, writer.model);
    if events.is_empty() {
        return;
    }
    // The function of a contact depends on its mode; run-time code supplies its value.
    let one = writer.model.graph.number(1);
    let value = |event: &Event| match event.action {
        Action::Impact(_) => one,
        _ => event.value,
    };
    let values = events.iter().map(value).collect::<Vec<_>>();
    let returns = Returns::Vector(values.len());
    let (body, _) = writer.lowered(&values, Arguments::State, |results| returns.collect(results));
    writer.push_hidden("event_functions", returns, body);
    for (i, event) in events.iter().enumerate() {
        if let Action::Assign(assignments) = &event.action {
            write_assignments(writer, &format!("after_event_{i}"), assignments);
        }
    }
}

/// Returns the declared events, without those of contacts that share one event.
pub fn separate_events(declaration: &Declaration, model: &Model) -> Vec<Event> {
    let shares_event = shares_event(declaration);
    let is_separate = |event: &&Event| !(shares_event && matches!(event.action, Action::Impact(_)));
    model.events.iter().filter(is_separate).cloned().collect()
}

/// Writes a hidden method that returns the state after assignments.
pub(super) fn write_assignments(writer: &mut MethodWriter<'_>, method: &str, assignments: &[Assignment]) {
    let state = writer.model.state_after(assignments);
    let returns = Returns::Vector(state.len());
    let (body, _) = writer.lowered(&state, Arguments::State, |results| returns.collect(results));
    writer.push_hidden(method, returns, body);
}

/// Writes the members of `OdeSystem` for events.
pub(in crate::emit) fn event_members(shape: &Shape<'_>, members: &Members) -> TokenStream {
    let names = shape.event_names();
    if names.is_empty() && shape.switches.is_empty() {
        return begin(shape, members).unwrap_or_default();
    }
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let events = names.iter().map(|(name, direction)| {
        let name = shape.written(name);
        match direction.map(|direction| direction_tokens(shape, direction)) {
            Some(direction) => quote!(#krate::event::DeclaredEvent::new(#name, #direction)),
            None => quote!(#krate::event::DeclaredEvent::switch(#name)),
        }
    });
    let events = events.chain(switch_events(shape));
    let (values, event) = (local("values"), local("event"));
    let functions = (!shape.events.is_empty()).then(|| {
        let call = call(shape, members, "event_functions");
        quote! {
            for (value, found) in ::core::iter::Iterator::zip(#values.iter_mut(), #call) {
                *value = found;
            }
        }
    });
    let touching = (!shape.touching.is_empty())
        .then(|| quote!(#krate::contact::event_values(self, #time, #state, #values);));
    let switches = (!shape.switches.is_empty())
        .then(|| quote!(#krate::event::side_values(self, #time, #state, #values);));
    // Only contacts and friction depend on the elapsed time.
    let name = local("elapsed");
    let elapsed = if shape.touching.is_empty() { quote!(_) } else { quote!(#name) };
    let (reactions, begin) = (reactions(shape, members, &event, &elapsed), begin(shape, members));
    quote! {
        const EVENTS: &'static [#krate::event::DeclaredEvent] = &[#(#events),*];
        #[inline]
        fn event_values(&self, #time: #scalar, #state: &[#scalar; #all], #values: &mut [#scalar]) {
            #functions
            #touching
            #switches
        }
        fn react(
            &self,
            #event: ::core::primitive::usize,
            #time: #scalar,
            #elapsed: #scalar,
            #state: &[#scalar; #all],
        ) -> #krate::system::Reacted<Self> {
            match #event {
                #reactions
            }
        }
        #begin
    }
}

/// Writes an arm for each event that requires an action, and one for all others.
fn reactions(shape: &Shape<'_>, members: &Members, event: &Ident, elapsed: &TokenStream) -> TokenStream {
    let (krate, state) = (shape.krate, &members.names.state);
    let time = &members.names.time;
    let answer = |reaction: TokenStream| quote!(::core::result::Result::Ok(#krate::event::Response::new(#krate::event::Action::#reaction)));
    let declared = shape.events.iter().enumerate().filter_map(|(i, event)| {
        let index = length(i);
        let answer = match &event.action {
            ast::Action::Stop => answer(quote!(Stop)),
            ast::Action::Assign(_) => {
                let call = call(shape, members, &format!("after_event_{i}"));
                answer(quote!(Replace(#call)))
            }
            ast::Action::Record | ast::Action::Impact(_) => return None,
        };
        Some(quote!(#index => #answer,))
    });
    let mut events = shape.events_of_reactions().into_iter().flatten().collect::<Vec<_>>();
    events.dedup();
    let touching = events.iter().map(|index| {
        let index = length(*index);
        quote!(#index => #krate::contact::react(self, #index, #time, #elapsed, #state),)
    });
    let others = match shape.switches.is_empty() {
        true => answer(quote!(Continue)),
        false => quote!(#krate::event::change_side(self, #event, #time, #state)),
    };
    declared.chain(touching).chain([quote!(_ => #others,)]).collect()
}

fn begin(shape: &Shape<'_>, members: &Members) -> Option<TokenStream> {
    let (krate, scalar, all) = (shape.krate, shape.scalar(), shape.state_length());
    let ArgumentNames { time, state, .. } = &members.names;
    let contacts = quote!(#krate::contact::begin);
    let sides = quote!(#krate::event::choose_sides(self, #time, #state));
    let checked = members.ranges.is_some().then(|| quote!(self.check_parameters()?;));
    let mut arguments = [quote!(#time), quote!(#state)];
    let begun = match (shape.touching.is_empty(), shape.switches.is_empty()) {
        (true, true) if checked.is_none() => return None,
        (true, true) => {
            arguments = [quote!(_), quote!(_)];
            quote!(::core::result::Result::Ok(::core::option::Option::None))
        }
        (false, true) => quote!(#contacts(self, #time, #state)),
        (true, false) => quote!(::core::result::Result::Ok(#sides)),
        (false, false) => quote! {
            let on_sides = #sides;
            let system = ::core::option::Option::as_ref(&on_sides).unwrap_or(self);
            ::core::result::Result::Ok(#contacts(system, #time, #state)?.or(on_sides))
        },
    };
    let freed = (!shape.switches.is_empty()).then(|| {
        quote! {
            fn on_sides(&self, #time: #scalar, #state: &[#scalar; #all]) -> ::core::option::Option<Self> {
                #sides
            }
            fn freed(&self) -> ::core::option::Option<Self> {
                ::core::option::Option::Some(#krate::event::free_sides(self))
            }
        }
    });
    let [time_here, state_here] = arguments;
    Some({
        quote! {
            fn begin(
                &self,
                #time_here: #scalar,
                #state_here: &[#scalar; #all],
            ) -> ::core::result::Result<::core::option::Option<Self>, #krate::system::StepFailure<#scalar>> {
                #checked
                #begun
            }
            #freed
        }
    })
}

/// Writes a call of a hidden method with the halves of the state.
pub(super) fn call(shape: &Shape<'_>, members: &Members, method: &str) -> TokenStream {
    let ArgumentNames { time, state, .. } = &members.names;
    let variables = state_variables(shape);
    let (positions, velocities) = variables.split_at(shape.coordinates.len());
    let method = format_ident!("{method}");
    quote!({
        let [#(#variables),*] = *#state;
        self.#method(#time, &[#(#positions),*], &[#(#velocities),*])
    })
}

fn direction_tokens(shape: &Shape<'_>, direction: Direction) -> TokenStream {
    let krate = shape.krate;
    match direction {
        Direction::Rising => quote!(#krate::event::Direction::Rising),
        Direction::Falling => quote!(#krate::event::Direction::Falling),
        Direction::Crossing => quote!(#krate::event::Direction::Crossing),
    }
}
