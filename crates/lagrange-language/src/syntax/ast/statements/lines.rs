//! Lines between the braces of events, clocks and reductions.

use super::StatementKind;
use super::enclosures::{Enclosed, Enclosure};
use super::events::{Action, Assignment, Clock, Event};

impl StatementKind {
    /// Returns its lists of assignments.
    pub fn assignments_mut(&mut self) -> Option<&mut Vec<Assignment>> {
        match self {
            StatementKind::Start(assignments) | StatementKind::History(assignments) => Some(assignments),
            StatementKind::Every(clock) => Some(&mut clock.assignments),
            StatementKind::Event(event) => match &mut event.action {
                Action::Assign(assignments) => Some(assignments),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns the enclosures of each line between its braces.
    pub fn enclosures(&self) -> Vec<&[Enclosure]> {
        let assignments = match self {
            StatementKind::Reduce(reduction) => {
                return reduction.items.iter().map(|item| &item.enclosures[..]).collect();
            }
            StatementKind::Every(Clock { assignments, .. })
            | StatementKind::Event(Event { action: Action::Assign(assignments), .. }) => assignments,
            _ => return Vec::new(),
        };
        assignments.iter().map(|assignment| &assignment.enclosures[..]).collect()
    }

    /// Returns the loops, conditions and local names around its lines.
    pub fn enclosures_mut(&mut self) -> Vec<&mut Enclosure> {
        if let StatementKind::Reduce(reduction) = self {
            return reduction.items.iter_mut().flat_map(Enclosed::enclosures_mut).collect();
        }
        self.assignments_mut().into_iter().flatten().flat_map(Enclosed::enclosures_mut).collect()
    }
}
