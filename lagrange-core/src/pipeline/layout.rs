//! Places of the arguments of programs.

use crate::model::{Extent, ProductShape};
use lagrange_expr::symbol::Role;

/// Numbers of arguments of each kind, in their order in p.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Layout {
    /// Positions, which start the state.
    pub positions: usize,
    /// Velocities, which end the state.
    pub velocities: usize,
    /// Parameters, which start p.
    pub parameters: usize,
    /// Inputs, after the parameters.
    pub inputs: usize,
    /// Sides of the switches, after the inputs.
    pub sides: usize,
    /// Multipliers, after the sides. They are followed by one acceleration per velocity.
    pub multipliers: usize,
    /// Reactions of contacts and friction, after the accelerations.
    pub reactions: usize,
}

/// Location of an argument.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    /// The time.
    Time,
    /// An entry of the state.
    State(usize),
    /// An entry of p.
    Parameter(usize),
}

impl Layout {
    /// Returns the location of the argument with this role; `None` for roles that no program uses.
    pub fn place(&self, role: Role) -> Option<Place> {
        let [inputs, sides] = [self.parameters, self.parameters + self.inputs];
        let multipliers = sides + self.sides;
        Some(match role {
            Role::Time => Place::Time,
            Role::Coordinate(i) | Role::State(i) | Role::Discrete(i) => Place::State(i as usize),
            Role::Velocity(i) => Place::State(self.positions + i as usize),
            Role::Parameter(i) => Place::Parameter(i as usize),
            Role::Input(i) => Place::Parameter(inputs + i as usize),
            Role::Side(i) => Place::Parameter(sides + i as usize),
            Role::Multiplier(i) => Place::Parameter(multipliers + i as usize),
            Role::Acceleration(i) => Place::Parameter(multipliers + self.multipliers + i as usize),
            Role::Reaction(i) => {
                Place::Parameter(multipliers + self.multipliers + self.velocities + i as usize)
            }
            Role::Noise(_) | Role::Operand(_) | Role::Placeholder(_) => return None,
        })
    }

    /// Returns the numbers of rows and columns of a product with this number of entries, or the
    /// number of entries of a vector. At most one of the two numbers follows from the other.
    pub fn shape_of(&self, shape: ProductShape, entries: usize) -> Vec<usize> {
        let states = self.positions + self.velocities;
        let extent = |extent| match extent {
            Extent::Velocities => Some(self.velocities),
            Extent::State => Some(states),
            Extent::StateAndTime => Some(states + 1),
            Extent::Constraints => Some(self.multipliers),
            _ => None,
        };
        let ProductShape::Matrix(rows, columns) = shape else { return vec![entries] };
        let other = |known: usize| entries / known.max(1);
        match [extent(rows), extent(columns)] {
            [Some(rows), columns] => vec![rows, columns.unwrap_or_else(|| other(rows))],
            [None, columns] => columns.map_or_else(|| vec![entries], |columns| vec![other(columns), columns]),
        }
    }

    /// Returns the number of parameters and inputs.
    pub fn fields(&self) -> usize {
        self.parameters + self.inputs
    }

    /// Returns the length of p.
    pub fn length(&self) -> usize {
        self.fields() + self.sides + self.multipliers + self.velocities + self.reactions
    }
}
