//! Rates of quantities that states carry along, which energies must not contain.
//!
//! Virtual displacements leave states unchanged, so derivatives of an energy must not include what
//! its velocities gain from the rates of states. Let a weight be at z = h + s with ṡ = −ḣ/10. From
//! m z̈ = −m g follows 0.9 ḧ = −g. The energy m ż²/2 = 0.81 m ḣ²/2 would give 0.81 ḧ = −g instead.
//! Rates that depend on time and other states only do no harm.

use super::elaborator::Elaborator;
use super::evaluator::Evaluator;
use super::messages;
use super::operand::Operand;
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{AstId, Expression};

/// A state with a rate that depends on the motion.
#[derive(Clone)]
pub(super) struct Carrier {
    name: String,
    /// Quantities that its rate depends on.
    rate: Dependencies,
}

/// The states that carry quantities along.
#[derive(Default)]
pub(super) struct Carriers {
    /// By calls of `dot` and `ddot`.
    rates: HashMap<AstId, Carrier>,
    /// By names whose definitions contain such calls.
    names: HashMap<String, Carrier>,
}

impl Evaluator<'_> {
    /// Records that a call is the rate of this value.
    pub(super) fn record_rate(&mut self, value: &Operand, call: AstId) {
        let carried = |&id: &ExprId| self.graph.dependencies(id).intersects(Dependencies::STATE);
        let carried = value.components().iter().copied().filter(carried).collect::<Vec<_>>();
        let carrier = self.graph.reachable(&carried).into_iter().find_map(|id| self.carrier(id));
        if let Some(carrier) = carrier {
            self.carriers.rates.insert(call, carrier);
        }
    }

    /// Returns the carrier that a symbol is.
    fn carrier(&self, id: ExprId) -> Option<Carrier> {
        let symbol = self.graph.symbol_of(id).filter(|symbol| matches!(symbol.role, Role::State(_)))?;
        let rate = self.graph.dependencies(self.graph.rate_of_position(id)?);
        let depends_on_motion = rate.intersects(Dependencies::COORDINATE | Dependencies::VELOCITY);
        depends_on_motion.then(|| Carrier { name: symbol.name.clone(), rate })
    }

    /// Records that a name has the value of an expression.
    pub(super) fn record_name(&mut self, name: &str, definition: AstId) {
        let carrier = self.carried_rates(definition).next().map(|(_, carrier)| carrier.clone());
        if let Some(carrier) = carrier {
            self.carriers.names.insert(name.to_owned(), carrier);
        }
    }

    /// Returns the rates in an expression that states carry along, and these states.
    fn carried_rates(&self, root: AstId) -> impl Iterator<Item = (AstId, &Carrier)> {
        let is_empty = self.carriers.rates.is_empty();
        let mut pending = if is_empty { Vec::new() } else { vec![root] };
        let every = std::iter::from_fn(move || {
            let id = pending.pop()?;
            pending.extend(self.constituents(id));
            Some(id)
        });
        every.filter_map(|id| {
            let by_name = match self.syntax(id) {
                Expression::Name(name) => self.carriers.names.get(name),
                _ => None,
            };
            self.carriers.rates.get(&id).or(by_name).map(|carrier| (id, carrier))
        })
    }
}

/// Reports the first rate that a state carries along, if the state's rate depends on one of these
/// quantities, with respect to which the energy is differentiated.
pub(super) fn report_carried_rate(elaborator: &mut Elaborator<'_>, energy: AstId, kinds: Dependencies) {
    let mut rates = elaborator.evaluator.carried_rates(energy);
    let Some((place, carrier)) = rates.find(|(_, carrier)| carrier.rate.intersects(kinds)) else { return };
    let (place, message) = (elaborator.evaluator.origin(place), messages::states::carried(&carrier.name));
    drop(rates);
    elaborator.evaluator.report.error(place, message).help(messages::states::CARRIED_HELP);
}
