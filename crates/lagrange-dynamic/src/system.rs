//! An interpreted system, with its switches.

use lagrange_core::limits;
use lagrange_core::pipeline::{BoundedQuantity, NumericSystem, Programs, Range};
use lagrange_runtime::contact::Mode;
use lagrange_runtime::event::{MAX_LOCATED, SwitchedSystem, Switches};
use lagrange_runtime::system::{OutOfRange, RangedKind, StateVector};

use crate::inline::Inline;
use crate::names::{Names, bound};
use crate::reactions::initial_mode;

const _: () = assert!(limits::MAX_LOCATED == MAX_LOCATED, "warnings state the limit of runs");

/// An interpreted system with states of at most `CAPACITY` entries.
#[derive(Clone, Debug)]
pub struct DynamicSystem<const CAPACITY: usize> {
    pub(crate) numeric: NumericSystem,
    pub(crate) names: &'static Names,
    switches: Switches,
    /// Modes of contacts and friction.
    pub(crate) modes: Vec<Mode>,
}

impl<const CAPACITY: usize> DynamicSystem<CAPACITY> {
    pub(crate) fn new(numeric: NumericSystem, names: &'static Names) -> Self {
        let modes = names.reactions.iter().map(|reaction| initial_mode(reaction.mode)).collect();
        DynamicSystem { numeric, names, switches: Switches::FREE, modes }
    }

    pub(crate) fn programs(&self) -> &Programs {
        self.numeric.programs()
    }

    /// Returns the state of these entries, positions first.
    ///
    /// # Panics
    /// If there are fewer entries than positions, or more than `CAPACITY`.
    pub fn state(&self, entries: &[f64]) -> Inline<CAPACITY> {
        let (positions, velocities) = entries.split_at(self.programs().layout.positions);
        Inline::joined(positions, velocities)
    }

    /// True if outputs are declared.
    pub fn has_outputs(&self) -> bool {
        !self.names.layout.outputs.is_empty()
    }

    /// True if contacts or friction are declared.
    pub(crate) fn is_touching(&self) -> bool {
        !self.modes.is_empty()
    }

    /// Checks that parameters, and quantities of contacts, are in their ranges.
    pub(crate) fn check_parameters(&self) -> Result<(), OutOfRange<f64>> {
        let programs = self.programs();
        let parameters = programs.ranges.iter().try_for_each(|Range { parameter, bounds }| {
            let name = self.names.fields[*parameter];
            let unit = programs.variables.unit(name);
            let unit = self.names.description.units.iter().find(|(_, known)| Some(*known) == unit);
            let unit = unit.map_or("", |(_, unit)| unit);
            let bounds = bounds.map(bound);
            let unit = if unit == "1" { "" } else { unit };
            OutOfRange::check(
                RangedKind::Parameter,
                name,
                self.numeric.fields()[*parameter],
                bounds.into(),
                unit,
            )
        });
        parameters.and_then(|()| self.check_quantities())
    }

    /// Checks quantities of contacts.
    fn check_quantities(&self) -> Result<(), OutOfRange<f64>> {
        let programs = self.programs();
        let mut values = self.numeric.evaluate(&programs.quantity_values, 0.0, &[], &[]).into_iter();
        let named = programs.quantities.iter().zip(self.names.quantities);
        for (BoundedQuantity { bounds, .. }, words) in named {
            let value = values.next().unwrap_or(f64::NAN);
            let range =
                bounds.map(|included| bound(included.and_then(|included| Some((values.next()?, included)))));
            OutOfRange::check(RangedKind::OfContact, words, value, range.into(), "")?;
        }
        Ok(())
    }
}

impl<const CAPACITY: usize> SwitchedSystem for DynamicSystem<CAPACITY> {
    const FIRST: usize = 0;

    fn first(&self) -> usize {
        self.programs().reactions.len() + self.programs().variables.events_of_friction.len()
    }

    fn switches(&self) -> Switches {
        self.switches
    }

    fn with_switches(&self, switches: Switches) -> Self {
        let mut system = DynamicSystem { switches, ..self.clone() };
        system.numeric.fix_sides((0..self.programs().layout.sides).map(|k| switches.side(k)));
        system
    }

    fn switch_values(&self, t: f64, y: &Inline<CAPACITY>, values: &mut [f64]) {
        let (q, v) = y.parts(0);
        let found = self.numeric.evaluate(&self.programs().switches, t, q, v);
        values.iter_mut().zip(found).for_each(|(value, found)| *value = found);
    }

    fn switch_times(&self) -> impl Iterator<Item = Option<f64>> {
        self.programs().switch_times.iter().map(|time| {
            let values = self.numeric.evaluate(time.as_ref()?, 0.0, &[], &[]);
            values.first().copied()
        })
    }
}
