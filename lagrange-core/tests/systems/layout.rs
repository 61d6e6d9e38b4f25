//! Positions and velocities of a declaration, in the order of states.

use crate::tree::Statement;
use crate::world::element;

/// Positions with the velocities that displace them.
#[derive(Clone, Debug)]
pub(crate) enum Slot {
    Coordinate {
        name: String,
        position: usize,
        velocity: usize,
    },
    /// A unit quaternion, displaced by small rotations.
    Orientation {
        name: String,
        position: usize,
        velocity: usize,
    },
}

/// Sizes and names of a state.
#[derive(Clone, Default, Debug)]
pub(crate) struct Layout {
    pub(crate) slots: Vec<Slot>,
    /// The number of positions, without first-order states.
    pub(crate) positions: usize,
    pub(crate) velocities: usize,
    pub(crate) states: Vec<String>,
}

impl Layout {
    pub(crate) fn of(statements: &[Statement]) -> Layout {
        let mut layout = Layout::default();
        for statement in statements {
            match statement {
                Statement::Coordinate { name, count: None, .. } => layout.add_coordinate(name.clone()),
                Statement::Coordinate { name, count: Some(count), .. } => {
                    (0..*count).for_each(|i| layout.add_coordinate(element(name, i)));
                }
                Statement::State { name, count: None, .. } => layout.states.push(name.clone()),
                Statement::State { name, count: Some(count), .. } => {
                    layout.states.extend((0..*count).map(|i| element(name, i)));
                }
                Statement::Quaternion(name) => layout.add_orientation(name),
                Statement::Joint(joint) if joint.kind == "ball" => layout.add_orientation(&joint.names[0]),
                Statement::Joint(joint) => {
                    joint.names.iter().for_each(|name| layout.add_coordinate(name.clone()));
                }
                Statement::Free(name) => {
                    ["x", "y", "z"].iter().for_each(|axis| layout.add_coordinate(format!("{name}_{axis}")));
                    layout.add_orientation(name);
                }
                _ => {}
            }
        }
        layout
    }

    fn add_coordinate(&mut self, name: String) {
        self.slots.push(Slot::Coordinate { name, position: self.positions, velocity: self.velocities });
        self.positions += 1;
        self.velocities += 1;
    }

    fn add_orientation(&mut self, name: &str) {
        let name = name.to_owned();
        self.slots.push(Slot::Orientation { name, position: self.positions, velocity: self.velocities });
        self.positions += 4;
        self.velocities += 3;
    }

    /// Returns the velocity that a force refers to by its coordinate.
    pub(crate) fn velocity(&self, name: &str) -> Option<usize> {
        self.slots.iter().find_map(|slot| match slot {
            Slot::Coordinate { name: known, velocity, .. } if known == name => Some(*velocity),
            _ => None,
        })
    }
}
