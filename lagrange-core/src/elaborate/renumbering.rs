//! Numbers of coordinates and velocities in a reduced model.

use crate::model::{Model, Pinned, Reduction};
use lagrange_expr::symbol::Role;

/// Order of coordinates and velocities without the frozen ones, with ignored coordinates last.
pub(super) struct Renumbering {
    /// Indices of the remaining coordinates, in their new order.
    coordinates: Vec<usize>,
    /// Indices of the remaining velocities.
    velocities: Vec<usize>,
    ignored: Vec<usize>,
}

impl Renumbering {
    pub(super) fn new(whole: &Model, reduction: &Reduction) -> Renumbering {
        let indices = |all: &[Pinned]| all.iter().map(|pinned| pinned.coordinate).collect::<Vec<_>>();
        let (frozen, ignored) = (indices(&reduction.frozen), indices(&reduction.ignored));
        let is_free = |i: &usize| !frozen.contains(i) && !ignored.contains(i);
        let coordinates = (0..whole.coordinates.len()).filter(is_free).chain(ignored.iter().copied());
        let stays = |i: &usize| whole.speeds[*i].coordinate.is_none_or(|i| is_free(&i));
        let velocities = (0..whole.speeds.len()).filter(stays).collect();
        Renumbering { coordinates: coordinates.collect(), velocities, ignored }
    }

    pub(super) fn coordinate(&self, index: usize) -> usize {
        self.coordinates.iter().position(|&other| other == index).unwrap_or(index)
    }

    pub(super) fn velocity(&self, index: usize) -> usize {
        self.velocities.iter().position(|&other| other == index).unwrap_or(index)
    }

    /// Reorders a list that begins with one entry for each remaining position, in the old order.
    pub(super) fn sort<T>(&self, list: &mut Vec<T>) {
        if self.ignored.is_empty() || list.is_empty() {
            return;
        }
        let mut old = self.coordinates.clone();
        old.sort_unstable();
        let places = old.into_iter().map(|index| self.coordinate(index));
        let mut entries = places.zip(list.drain(..self.coordinates.len())).collect::<Vec<_>>();
        entries.sort_by_key(|(place, _)| *place);
        list.splice(..0, entries.into_iter().map(|(_, entry)| entry));
    }

    pub(super) fn role(&self, role: Role) -> Role {
        let velocity = |i: u32| self.velocity(i as usize) as u32;
        match role {
            Role::Coordinate(i) if self.ignored.contains(&(i as usize)) => {
                Role::State(self.coordinate(i as usize) as u32)
            }
            Role::Coordinate(i) => Role::Coordinate(self.coordinate(i as usize) as u32),
            Role::State(i) => Role::State(self.coordinate(i as usize) as u32),
            Role::Discrete(i) => Role::Discrete(self.coordinate(i as usize) as u32),
            Role::Velocity(i) => Role::Velocity(velocity(i)),
            Role::Acceleration(i) => Role::Acceleration(velocity(i)),
            other => other,
        }
    }
}
