//! Properties of a system that exclude a product.

use super::messages;
use crate::derive::Equations;
use crate::model::Model;
use lagrange_expr::expr::Node;

/// Part of a system that is incompatible with some products.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(in crate::emit) enum Exclusion {
    Contacts,
    Constraints,
    Redundant,
    Switches,
    Indefinite,
    Events,
    Noise,
    Orientations,
    Functions,
    Delays,
    Defaults,
}

impl Exclusion {
    /// Returns the first of these that a system has.
    pub(in crate::emit) fn first(
        exclusions: &[Exclusion],
        model: &Model,
        equations: &Equations,
    ) -> Option<Exclusion> {
        let is_there = |exclusion: &&Exclusion| match exclusion {
            Exclusion::Contacts => !model.reactions.is_empty(),
            Exclusion::Constraints => !model.constraints.is_empty(),
            Exclusion::Redundant => equations.constraints.is_redundant,
            Exclusion::Switches => !equations.switches.is_empty(),
            Exclusion::Indefinite => equations.pivot_growth.is_some(),
            Exclusion::Events => !model.events.is_empty() || !model.clocks.is_empty(),
            Exclusion::Noise => !model.noises.is_empty(),
            Exclusion::Orientations => !model.orientations.is_empty(),
            Exclusion::Functions => calls_functions(model, equations),
            Exclusion::Delays => !model.delays.is_empty(),
            Exclusion::Defaults => lacks_defaults(model),
        };
        exclusions.iter().find(is_there).copied()
    }

    /// Returns its name in messages, with the reason.
    pub(in crate::emit) fn words(self) -> &'static str {
        match self {
            Exclusion::Contacts => messages::CONTACTS,
            Exclusion::Constraints => messages::CONSTRAINTS,
            Exclusion::Redundant => messages::REDUNDANT,
            Exclusion::Switches => messages::SWITCHES,
            Exclusion::Indefinite => messages::INDEFINITE,
            Exclusion::Events => messages::EVENTS,
            Exclusion::Noise => messages::NOISE,
            Exclusion::Orientations => messages::ORIENTATIONS,
            Exclusion::Functions => messages::FUNCTIONS,
            Exclusion::Delays => messages::DELAYS,
            Exclusion::Defaults => messages::WITHOUT_DEFAULTS,
        }
    }
}

/// True if the equations of motion contain functions without a formula.
fn calls_functions(model: &Model, equations: &Equations) -> bool {
    let roots = [&equations.accelerations[..], &model.position_rates()].concat();
    let nodes = model.graph.reachable(&roots);
    nodes.into_iter().any(|id| matches!(model.graph.node(id), Node::Opaque(..)))
}

/// True if a parameter has no default.
fn lacks_defaults(model: &Model) -> bool {
    model.parameters.iter().any(|parameter| parameter.default.is_none())
}
