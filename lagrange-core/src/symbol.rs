//! Names and the role each plays in a system.

use crate::collections::OrderedMap;

/// Identifies a symbol of one [`Symbols`] table.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct SymbolId(u32);

/// Meaning of a symbol; the number is its index among its kind, in declaration order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Role {
    /// A run-time parameter: constant during the motion.
    Parameter(u32),
    /// A control: like a parameter for the calculus, but its rate is unknown.
    Input(u32),
    /// Time `t`.
    Time,
    /// A generalised coordinate.
    Coordinate(u32),
    /// The rate of the coordinate with the same index.
    Velocity(u32),
    /// The second rate of the coordinate with the same index.
    Acceleration(u32),
    /// The multiplier of the constraint with the same index.
    Multiplier(u32),
    /// The force of the contact or of the friction with the same index.
    Reaction(u32),
    /// Side of the switch with the same index on which an expression is evaluated: 1 or −1, or 0 on the surface itself.
    Side(u32),
    /// A place holder inside one computation; never part of a result.
    Placeholder(u32),
}

/// A symbol: its name as the user wrote it, and its role.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Symbol {
    /// The name; for a velocity or an acceleration that of its coordinate.
    pub name: String,
    /// The role.
    pub role: Role,
}

/// The symbols of one system, one for each role, in the order in which they were added.
#[derive(Clone, Default, Debug)]
pub struct Symbols {
    by_role: OrderedMap<Role, Symbol>,
}

impl Symbols {
    /// The symbol in `role`, added under `name` if it is new.
    pub fn intern(&mut self, name: &str, role: Role) -> SymbolId {
        let symbol = || Symbol { name: name.to_owned(), role };
        SymbolId(self.by_role.index_or_insert_with(role, symbol) as u32)
    }

    /// The symbol behind an id of this table.
    pub fn get(&self, id: SymbolId) -> &Symbol {
        self.by_role.value_at(id.0 as usize)
    }

    /// The symbol in `role`, if there is one.
    pub fn find(&self, role: Role) -> Option<SymbolId> {
        self.by_role.index_of(&role).map(|index| SymbolId(index as u32))
    }
}
