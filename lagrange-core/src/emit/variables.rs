//! Names and units of an emitted type as plain data, for systems that are not emitted.

use proc_macro2::TokenStream;

use super::base::fields::split_indices;
use super::base::shape::{Shape, Touch};
use super::features::contacts::{events_of_rows, jumping_gradients, needs_steps, reversing_limits};
use super::features::orientations::written_velocity;
use super::features::ports::column_names;
use super::features::regressor::regressor_names;
use super::features::switches::derived_shape;
use super::features::units::units_by_name;
use crate::derive::Equations;
use crate::model::{EntryLimits, Model, Product};
use lagrange_expr::collections::HashSet;
use lagrange_language::syntax::ast::{Action, Declaration, Direction};

/// Names and units of a system's variables, as in the constants of its emitted type.
#[derive(Clone, Debug)]
pub struct Variables {
    /// Parameters, then inputs.
    pub fields: Vec<String>,
    /// Positions, including first-order states.
    pub positions: Vec<String>,
    /// Velocities; empty if all of them are rates of the positions without separate names.
    pub velocities: Vec<String>,
    /// Coordinates whose rates the named velocities are; empty names for other velocities.
    pub rates_of: Vec<String>,
    /// Ranges and nominal values of the entries of the state.
    pub limits: Vec<EntryLimits>,
    /// Number of first-order states, the last positions.
    pub first_order_states: usize,
    /// Indices of positions at which unit quaternions begin.
    pub quaternions: Vec<usize>,
    /// For each velocity, the index of the position whose rate it is; `None` for components of
    /// angular velocities, three for each quaternion.
    pub positions_of_velocities: Vec<Option<usize>>,
    /// Constraints.
    pub constraints: Vec<String>,
    /// True if constraints are stabilised, so that steps are not projected.
    pub is_stabilised: bool,
    /// Events.
    pub events: Vec<EventOfSystem>,
    /// Contacts and friction, with one name for all elements of an array.
    pub touching: Vec<String>,
    /// Reactions of contacts and friction.
    pub reactions: Vec<ReactionOfSystem>,
    /// Events after the declared ones, at which friction changes its mode.
    pub events_of_friction: Vec<String>,
    /// The reason why only steps can simulate the system, if there is one.
    pub needs_steps: Option<String>,
    /// Inputs that are delayed signals.
    pub delayed: Vec<String>,
    /// Surfaces of the switches whose sides runs fix.
    pub switches: Vec<String>,
    /// Columns of each output.
    pub outputs: Vec<Vec<String>>,
    /// Parameters that the columns of the regressor multiply, if it is requested.
    pub regressor: Vec<String>,
    /// Units by name; the unit of an array applies to all elements.
    pub units: Vec<(String, String)>,
    /// Declared units of parameters, inputs and the state that differ from their units at run time.
    pub declared_units: Vec<(String, String)>,
}

impl Variables {
    /// Returns the names of the entries of the state: positions, then velocities.
    pub fn state_names(&self) -> Vec<String> {
        let rates = || self.positions.iter().map(|name| rate_of(name)).collect();
        let are_rates = self.velocities.is_empty() && self.first_order_states == 0;
        let velocities = if are_rates { rates() } else { self.velocities.clone() };
        [self.positions.clone(), velocities].concat()
    }

    /// Returns the unit of a variable, or of the array for an element; `None` if it is unknown.
    pub fn unit(&self, name: &str) -> Option<&str> {
        let of = |name: &str| self.units.iter().find(|(known, _)| known == name).map(|(_, unit)| &**unit);
        of(name).or_else(|| of(split_indices(name).0))
    }

    /// Returns the unit in which the declaration writes numbers of a variable; `None` if it is
    /// unknown.
    pub fn declared_unit(&self, name: &str) -> Option<&str> {
        let declared = self.declared_units.iter().find(|(known, _)| known == name);
        declared.map_or_else(|| self.unit(name), |(_, unit)| Some(unit))
    }
}

/// Returns the name of the rate of a coordinate in columns, `x_dot[0]` for `x[0]`.
fn rate_of(name: &str) -> String {
    let (stem, indices) = split_indices(name);
    format!("{stem}_dot{indices}")
}

/// A declared event.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct EventOfSystem {
    /// Its name.
    pub name: String,
    /// Direction of the relevant zeros.
    pub direction: Direction,
    /// True for an event of a contact.
    pub is_of_contact: bool,
}

/// A reaction of a contact or friction.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ReactionOfSystem {
    /// Name of the contact or friction.
    pub name: String,
    /// Its mode.
    pub mode: ModeOfReaction,
    /// Index of the event at which the mode changes.
    pub event: Option<usize>,
    /// True if the limit of friction contains constraint forces.
    pub limit_reverses: bool,
    /// True if the gradient of the gap jumps.
    pub gradient_jumps: bool,
}

/// The kind of the mode of a reaction.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ModeOfReaction {
    /// A contact, open or closed.
    Contact,
    /// Friction that sticks or slips.
    Friction,
    /// The second component of the friction before it.
    Across,
    /// Smooth friction.
    Smooth,
}

/// Collects the names and units of a derived system.
pub fn variables(declaration: &Declaration, model: &Model, equations: &Equations) -> Variables {
    let nowhere = TokenStream::new();
    let shape = derived_shape(declaration, &nowhere, model, equations);
    let text = |text: &str| text.to_owned();
    let is_named = shape.names_velocities();
    let named = shape.velocities.iter().filter(|_| is_named);
    let rates_of = |name| text(shape.written(name));
    let counted = shape.outputs.iter().zip(&model.outputs);
    let outputs: Vec<Vec<String>> = counted
        .map(|((name, _), output)| column_names(&shape, name, output.components.len()).collect())
        .collect();
    let units_of_outputs = shape.outputs.iter().zip(&outputs).flat_map(|((name, _), columns)| {
        let columns = columns.iter().enumerate();
        columns
            .filter_map(|(index, column)| Some((column.clone(), shape.unit_of_component(&name.text, index)?)))
    });
    let has_momenta = shape.velocities_are_rates() && model.products.contains(&Product::MomentumRates);
    let units = units_by_name(&shape, units_of_outputs.collect(), has_momenta);
    let declared_units = shape.fields.iter().chain(&shape.coordinates).filter_map(|name| {
        let declared = shape.units.get(&name.text)?.declared.clone()?;
        Some((text(shape.written(name)), declared))
    });
    Variables {
        fields: shape.fields.iter().map(|name| text(shape.written(name))).collect(),
        positions: shape.coordinates.iter().map(|name| text(shape.written(name))).collect(),
        velocities: named.clone().map(|velocity| written_velocity(&shape, velocity)).collect(),
        rates_of: named.map(|velocity| velocity.coordinate.map_or_else(String::new, rates_of)).collect(),
        limits: model.entry_limits(),
        first_order_states: shape.states,
        quaternions: shape.quaternions.clone(),
        positions_of_velocities: shape.velocities.iter().map(|v| shape.position_of(v)).collect(),
        constraints: shape.constraints.iter().map(|name| text(shape.written(name))).collect(),
        is_stabilised: shape.is_stabilised,
        events: shape
            .events
            .iter()
            .map(|event| EventOfSystem {
                name: text(shape.written(&event.name)),
                direction: event.direction,
                is_of_contact: matches!(event.action, Action::Impact(_)),
            })
            .collect(),
        touching: touching_names(&shape),
        reactions: reactions(&shape, model),
        events_of_friction: events_of_friction(&shape),
        needs_steps: needs_steps(&shape, model),
        delayed: model.delays.iter().map(|delay| model.inputs[delay.input].name.clone()).collect(),
        switches: shape.switches.clone(),
        outputs,
        regressor: regressor_names(&shape, equations),
        units: units.into_iter().map(|(name, unit)| (name, text(unit))).collect(),
        declared_units: declared_units.collect(),
    }
}

/// Returns the reactions in the order of their rows.
fn reactions(shape: &Shape<'_>, model: &Model) -> Vec<ReactionOfSystem> {
    let (places, events) = (shape.reactions(), events_of_rows(shape));
    let (reversing, jumping) = (reversing_limits(model), jumping_gradients(model));
    let reaction = |(k, &place): (usize, &usize)| {
        let (name, touch) = shape.touching[place];
        let mode = match touch {
            Touch::Contact => ModeOfReaction::Contact,
            Touch::Planar if k > 0 && places[k - 1] == place => ModeOfReaction::Across,
            Touch::Friction | Touch::Planar => ModeOfReaction::Friction,
            Touch::Smooth => ModeOfReaction::Smooth,
        };
        ReactionOfSystem {
            name: shape.written(name).to_owned(),
            mode,
            event: events[k],
            limit_reverses: reversing[k],
            gradient_jumps: jumping[k],
        }
    };
    places.iter().enumerate().map(reaction).collect()
}

fn events_of_friction(shape: &Shape<'_>) -> Vec<String> {
    let others = shape.event_names().into_iter().skip(shape.events.len());
    others.map(|(name, _)| shape.written(name).to_owned()).collect()
}

/// Returns the declared names of contacts and friction. An array has one name, and so do the points
/// in which a body touches, with their friction.
fn touching_names(shape: &Shape<'_>) -> Vec<String> {
    let names = || shape.touching.iter().map(|(name, _)| split_indices(shape.written(name)).0);
    let is_of_contact = |name: &str| {
        let contact = name.strip_suffix("_friction");
        contact.is_some_and(|contact| names().any(|name| name == contact))
    };
    let mut known = HashSet::default();
    let declared = names().filter(|name| known.insert(*name) && !is_of_contact(name));
    declared.map(str::to_owned).collect()
}
