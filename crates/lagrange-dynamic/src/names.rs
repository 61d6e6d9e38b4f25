//! Names of systems read at run time.
//!
//! Failures and tables store names as `&'static str`, like those of emitted types. Names are
//! therefore leaked, once for all systems with the same names.

use std::collections::HashMap;
use std::ops::Bound;
#[cfg(feature = "fit")]
use std::sync::OnceLock;
use std::sync::{Mutex, PoisonError};

use lagrange_core::emit::{ReactionOfSystem, Variables};
use lagrange_core::model::EntryLimits;
use lagrange_core::pipeline::Programs;
use lagrange_core::syntax::ast;
use lagrange_runtime::event::{DeclaredEvent, Direction};
use lagrange_runtime::system::{Description, Domain, EntryRange, MatrixLayout, RangedKind};

use crate::reactions::{NamedReaction, Room};

type Texts = &'static [&'static str];

/// Names of a system.
#[derive(Debug)]
pub(crate) struct Names {
    /// Names and units of the variables.
    pub(crate) description: Description,
    /// Ranges and nominal values of the entries of the state.
    pub(crate) domain: Domain,
    /// Names of parameters, then inputs.
    pub(crate) fields: Texts,
    /// Names of inputs, columns of outputs, and constraints.
    pub(crate) layout: MatrixLayout,
    /// Declared events, then the events of switches.
    pub(crate) events: &'static [DeclaredEvent],
    /// Reactions of contacts and friction.
    pub(crate) reactions: &'static [NamedReaction],
    /// Room for them.
    pub(crate) room: Room,
    /// The reason why only steps can simulate the system, if there is one.
    pub(crate) needs_steps: Option<&'static str>,
    /// Names of algebraic unknowns.
    pub(crate) unknowns: Texts,
    /// Names of compliant contacts with round surfaces.
    pub(crate) round_contacts: Texts,
    /// Quantities of contacts, in words.
    pub(crate) quantities: Texts,
    /// The reason why the motion has no Taylor series, if it has none.
    pub(crate) without_series: Option<&'static str>,
    /// Names of entries of the state.
    #[cfg(feature = "fit")]
    state: Texts,
    #[cfg(feature = "fit")]
    filled: OnceLock<Description>,
}

#[cfg(feature = "fit")]
impl Names {
    /// Returns the description of states with this number of entries. Additional entries have names
    /// that no declaration can contain. The number is always the same for the same names.
    pub(crate) fn filled(&'static self, entries: usize) -> &'static Description {
        self.filled.get_or_init(|| {
            let velocities = self.state[self.description.coordinates.len()..].iter().copied();
            let others = (self.state.len()..entries).map(|index| text(&format!("entry {index}")));
            Description { velocities: Vec::leak(velocities.chain(others).collect()), ..self.description }
        })
    }

    /// Returns the static name of a parameter, an input or an entry of the state.
    pub(crate) fn known(&self, name: &str) -> Option<&'static str> {
        self.fields.iter().chain(self.state).copied().find(|known| *known == name)
    }
}

/// Returns the names of a system.
pub(crate) fn names_of(programs: &Programs) -> &'static Names {
    static KNOWN: Mutex<Option<HashMap<String, &'static Names>>> = Mutex::new(None);
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let known = known.get_or_insert_default();
    let Programs { variables, layout, are_holonomic, unknowns, round_contacts, quantities, .. } = programs;
    let reason = without_series(programs);
    let all = format!(
        "{variables:?}{layout:?}{are_holonomic:?}{unknowns:?}{round_contacts:?}{quantities:?}{reason:?}"
    );
    known.entry(all).or_insert_with(|| kept(programs))
}

/// Returns the reason why a motion has no Taylor series, if it has none.
fn without_series(programs: &Programs) -> Option<&str> {
    match &programs.series {
        None => Some("the declaration does not emit `taylor`: add `emit { taylor }`, or take `verner`"),
        Some(series) => series.as_ref().err().map(String::as_str),
    }
}

fn kept(programs: &Programs) -> &'static Names {
    let variables = &programs.variables;
    let units = variables.units.iter().map(|(name, unit)| (text(name), text(unit))).collect::<Vec<_>>();
    let declared = variables.events.iter().map(|event| match event.is_of_contact {
        true => DeclaredEvent::switch(text(&event.name)),
        false => DeclaredEvent::new(text(&event.name), direction(event.direction)),
    });
    let of_friction = variables.events_of_friction.iter().map(|name| DeclaredEvent::switch(text(name)));
    let sides = variables.switches.iter().map(|surface| DeclaredEvent::side(text(surface)));
    let description = Description {
        coordinates: texts(&variables.positions),
        velocities: texts(&variables.velocities),
        rates_of: texts(&variables.rates_of),
        first_order_states: variables.first_order_states,
        units: Vec::leak(units),
        quaternions: Vec::leak(variables.quaternions.clone()),
    };
    let fields = texts(&variables.fields);
    let layout = MatrixLayout {
        inputs: &fields[programs.layout.parameters..],
        outputs: texts(&variables.outputs.concat()),
        constraints: texts(&variables.constraints),
        are_holonomic: Vec::leak(programs.are_holonomic.clone()),
    };
    Box::leak(Box::new(Names {
        description,
        domain: domain(variables),
        fields,
        layout,
        events: Vec::leak(declared.chain(of_friction).chain(sides).collect()),
        reactions: Vec::leak(variables.reactions.iter().map(named).collect()),
        room: Room::of(programs).unwrap_or(Room::Small),
        needs_steps: variables.needs_steps.as_deref().map(text),
        unknowns: texts(&programs.unknowns),
        round_contacts: texts(&programs.round_contacts),
        quantities: Vec::leak(programs.quantities.iter().map(|quantity| text(&quantity.words)).collect()),
        without_series: without_series(programs).map(text),
        #[cfg(feature = "fit")]
        state: texts(&variables.state_names()),
        #[cfg(feature = "fit")]
        filled: OnceLock::new(),
    }))
}

fn named(reaction: &ReactionOfSystem) -> NamedReaction {
    let &ReactionOfSystem { mode, event, limit_reverses, gradient_jumps, .. } = reaction;
    let name = text(&reaction.name);
    NamedReaction { name, mode, event, limit_reverses, gradient_jumps }
}

/// Returns the ranges and the nominal values of the entries of the state.
fn domain(variables: &Variables) -> Domain {
    let (names, limits) = (variables.state_names(), &variables.limits);
    let (positions, states) = (variables.positions.len(), variables.first_order_states);
    let range = |(entry, EntryLimits { bounds, .. }): (usize, &EntryLimits)| EntryRange {
        entry,
        kind: match entry {
            _ if entry >= positions => RangedKind::Velocity,
            _ if entry + states >= positions => RangedKind::State,
            _ => RangedKind::Coordinate,
        },
        name: text(&names[entry]),
        unit: text(variables.unit(&names[entry]).filter(|unit| *unit != "1").unwrap_or_default()),
        bounds: bounds.map(bound).into(),
    };
    let limited = limits.iter().enumerate();
    let limited = limited.filter(|(_, limits)| limits.is_bounded());
    Domain {
        ranges: Vec::leak(limited.map(range).collect()),
        nominal: Vec::leak(EntryLimits::nominal_values(limits)),
    }
}

/// Returns a bound, given with true if it is included.
pub(crate) fn bound(bound: Option<(f64, bool)>) -> Bound<f64> {
    match bound {
        None => Bound::Unbounded,
        Some((value, true)) => Bound::Included(value),
        Some((value, false)) => Bound::Excluded(value),
    }
}

fn texts(names: &[String]) -> Texts {
    Vec::leak(names.iter().map(|name| text(name)).collect())
}

fn text(name: &str) -> &'static str {
    String::leak(name.to_owned())
}

fn direction(direction: ast::Direction) -> Direction {
    match direction {
        ast::Direction::Rising => Direction::Rising,
        ast::Direction::Falling => Direction::Falling,
        ast::Direction::Crossing => Direction::Crossing,
    }
}
