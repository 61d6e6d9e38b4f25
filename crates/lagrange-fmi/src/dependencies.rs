//! Variables that rates and outputs depend on.

use std::collections::BTreeSet;

use lagrange_core::pipeline::{Layout, Place, Programs};
use lagrange_core::program::{Op, Program, ValueId};
use lagrange_core::symbol::Role;

/// Returns the roles of the arguments of a program's result.
fn roles(program: &Program, output: usize) -> BTreeSet<Role> {
    let mut found = BTreeSet::new();
    let mut seen = BTreeSet::new();
    let mut open = program.outputs().get(output).copied().into_iter().collect::<Vec<ValueId>>();
    while let Some(value) = open.pop() {
        if !seen.insert(value) {
            continue;
        }
        if let Op::Input(role) = program.op(value) {
            found.insert(*role);
        }
        program.op(value).for_each_operand(|operand| open.push(operand));
    }
    found
}

/// Dependencies of results, including those through sides, accelerations and multipliers.
pub(crate) struct Dependencies<'a> {
    programs: &'a Programs,
}

impl<'a> Dependencies<'a> {
    pub(crate) fn new(programs: &'a Programs) -> Dependencies<'a> {
        Dependencies { programs }
    }

    /// Returns the roles that a result ultimately depends on.
    fn of(&self, program: &Program, output: usize) -> BTreeSet<Role> {
        let programs = self.programs;
        let mut found = BTreeSet::new();
        for role in roles(program, output) {
            match role {
                Role::Side(index) => found.extend(roles(&programs.switches, index as usize)),
                Role::Acceleration(index) => found.extend(self.of(&programs.accelerations, index as usize)),
                Role::Multiplier(index) => found.extend(self.of(&programs.multipliers, index as usize)),
                role => drop(found.insert(role)),
            }
        }
        found
    }

    /// Returns the indices that a rate depends on: entries of the state, then fields.
    pub(crate) fn of_rate(&self, index: usize) -> BTreeSet<usize> {
        let positions = self.programs.layout.positions;
        places(
            &self.programs.layout,
            &match index.checked_sub(positions) {
                None => self.of(&self.programs.position_rates, index),
                Some(index) => self.of(&self.programs.accelerations, index),
            },
        )
    }

    /// Returns the indices that each output depends on.
    pub(crate) fn of_outputs(&self) -> Vec<BTreeSet<usize>> {
        let outputs = self.programs.outputs.iter();
        let all = outputs.flat_map(|(_, program)| {
            (0..program.outputs().len()).map(|index| places(&self.programs.layout, &self.of(program, index)))
        });
        all.collect()
    }

    /// Returns true for each entry of the state whose declared initial value depends on parameters.
    pub(crate) fn of_start(&self) -> Vec<bool> {
        let states = self.programs.layout.positions + self.programs.layout.velocities;
        let follows =
            |index| self.programs.start.as_ref().is_some_and(|start| !roles(start, index).is_empty());
        (0..states).map(follows).collect()
    }
}

fn places(layout: &Layout, roles: &BTreeSet<Role>) -> BTreeSet<usize> {
    let states = layout.positions + layout.velocities;
    let place = |role: &Role| match layout.place(*role)? {
        Place::Time => None,
        Place::State(index) => Some(index),
        Place::Parameter(index) => Some(states + index),
    };
    roles.iter().filter_map(place).collect()
}
