//! The inputs of the programs of one step.

use crate::program::{Builder, Op, ValueId};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::symbol::Role;

/// The meaning of a placeholder in the programs of a step.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Slot {
    /// This initial value.
    Initial(usize),
    /// The coefficient of order k of this carried value.
    Carried(usize),
    /// This carried value divided by k + 1: the coefficient of order k + 1 of its integral.
    Integral(usize),
    /// Σ_{0≤j<k} xⱼ yₖ₋₁₋ⱼ of the factors of this sum, where xⱼ is the coefficient that step j
    /// kept.
    Sum(usize),
    /// The coefficient of this kept value as if accelerations were zero.
    Partial(usize),
    /// This acceleration or, after all of these, multiplier, of order k.
    Acceleration(u32),
    /// This acceleration divided by k + 1: the coefficient of order k + 1 of its velocity.
    Velocity(u32),
    /// k + 1
    Order,
    /// 1/(k + 1)
    Reciprocal,
    /// One in the first step, zero in all others.
    First,
}

impl Slot {
    /// Returns what this slot divides by k + 1.
    pub(super) fn dividend(self) -> Option<Slot> {
        match self {
            Slot::Integral(carried) => Some(Slot::Carried(carried)),
            Slot::Velocity(acceleration) => Some(Slot::Acceleration(acceleration)),
            _ => None,
        }
    }
}

/// The allocated placeholders.
#[derive(Default, Debug)]
pub(super) struct Slots(OrderedMap<Slot, ()>);

impl Slots {
    /// Returns the value of a placeholder in a program.
    pub(super) fn input(&mut self, builder: &mut Builder, slot: Slot) -> ValueId {
        let index = self.0.index_or_insert_with(slot, || ());
        let index = u32::try_from(index).expect("fewer than 2^32 slots fit in memory");
        builder.push(Op::Input(Role::Placeholder(index)))
    }

    /// Returns the meaning of an input, if it is a placeholder.
    pub(super) fn of(&self, role: Role) -> Option<Slot> {
        match role {
            Role::Placeholder(index) if (index as usize) < self.0.len() => {
                Some(*self.0.key_at(index as usize))
            }
            _ => None,
        }
    }

    pub(super) fn list(&self) -> Vec<Slot> {
        self.0.iter().map(|(slot, ())| *slot).collect()
    }
}
