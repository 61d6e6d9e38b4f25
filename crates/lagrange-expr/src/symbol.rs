//! Names and their roles in a system.

use crate::collections::OrderedMap;

/// Identifies a symbol of one [`Symbols`] table.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct SymbolId(u32);

/// Role of a symbol; the number is its index among its kind, in declaration order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Role {
    /// A run-time parameter: constant during the motion.
    Parameter(u32),
    /// A control: like a parameter for the calculus, but its rate is unknown.
    Input(u32),
    /// A white noise, which is not a function of time.
    Noise(u32),
    /// Time `t`.
    Time,
    /// A position: a generalised coordinate, or a component of a unit quaternion.
    Coordinate(u32),
    /// A first-order state, a position independent of velocities; the number is its index among all
    /// positions.
    State(u32),
    /// A state that only changes at events; the number is its index among all positions.
    Discrete(u32),
    /// A generalised velocity: the rate of a coordinate, or a component of an angular velocity.
    Velocity(u32),
    /// The rate of the velocity with the same index.
    Acceleration(u32),
    /// The multiplier of the constraint with the same index.
    Multiplier(u32),
    /// The force of the contact or of the friction with the same index.
    Reaction(u32),
    /// Side of the switch with the same index on which an expression is evaluated: 1 or −1, or 0 on
    /// the surface itself.
    Side(u32),
    /// An argument of an algebraic unknown, or the unknown itself, in the equation that defines it.
    Operand(u32),
    /// A place holder inside one computation; never part of a result.
    Placeholder(u32),
}

/// A symbol: its name as written by the user, and its role.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Symbol {
    /// Name; for a rate, the name of the changing quantity.
    pub name: String,
    /// Role of the symbol.
    pub role: Role,
    /// Number of dots over the name: the order of its derivative with respect to time.
    pub dots: u8,
}

impl Symbol {
    /// Returns the name in the language.
    pub fn text(&self) -> String {
        match self.dots {
            0 => self.name.clone(),
            1 => format!("dot({})", self.name),
            _ => format!("ddot({})", self.name),
        }
    }

    /// Returns the name of a variable or field.
    pub fn identifier(&self) -> String {
        match self.dots {
            0 => self.name.clone(),
            1 => format!("{}_dot", self.name),
            _ => format!("{}_ddot", self.name),
        }
    }
}

impl Role {
    /// Returns the number of dots over the name of the coordinate whose rate the symbol is.
    fn dots(self) -> u8 {
        match self {
            Role::Velocity(_) => 1,
            Role::Acceleration(_) => 2,
            _ => 0,
        }
    }
}

/// The symbols of one system, one for each role, in the order in which they were added.
#[derive(Clone, Default, Debug)]
pub struct Symbols {
    by_role: OrderedMap<Role, Symbol>,
}

impl Symbols {
    /// Returns the symbol in `role`, added under `name` if it is new. Velocities and accelerations
    /// are rates of the variable of that name.
    pub fn intern(&mut self, name: &str, role: Role) -> SymbolId {
        self.intern_dotted(name, role, role.dots())
    }

    /// Returns the symbol in `role`, added under `name` with this many dots if it is new.
    pub fn intern_dotted(&mut self, name: &str, role: Role, dots: u8) -> SymbolId {
        let symbol = || Symbol { name: name.to_owned(), role, dots };
        SymbolId(self.by_role.index_or_insert_with(role, symbol) as u32)
    }

    /// Returns the symbol with an id of this table.
    pub fn get(&self, id: SymbolId) -> &Symbol {
        self.by_role.value_at(id.0 as usize)
    }

    /// Returns the symbol in `role`, if there is one.
    pub fn find(&self, role: Role) -> Option<SymbolId> {
        self.by_role.index_of(&role).map(|index| SymbolId(index as u32))
    }
}
