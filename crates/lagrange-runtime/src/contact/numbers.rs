//! Modes in which steps end, as numbers.

use super::{Contact, Friction, Heading, Mode, Pace};
use crate::scalar::Scalar;

const CONTACTS: [Contact; 2] = [Contact::Open, Contact::Closed];
const FRICTIONS: [Friction; 4] =
    [Friction::Slips, Friction::SlipsForwards, Friction::SlipsBackwards, Friction::Sticks];
/// The numbers of the first mode of friction, the first mode of a second component, and smooth
/// friction.
const FIRST: usize = CONTACTS.len();
const ACROSS: usize = FIRST + FRICTIONS.len() + 1;
const SMOOTH: usize = ACROSS + FRICTIONS.len() + 1;

impl Mode {
    /// Converts the mode to its number and a heading. Steps give no pace to a slip velocity.
    pub(super) fn numbers<S: Scalar>(self) -> [S; 3] {
        let (kind, heading) = match self {
            Mode::Contact(contact) => (usize::from(contact == Contact::Closed), None),
            Mode::Friction(friction) => kind_of(friction, FIRST),
            Mode::Across(friction) => kind_of(friction, ACROSS),
            Mode::Smooth => (SMOOTH, None),
        };
        let [x, y] = heading.map_or([S::ZERO; 2], Heading::numbers);
        [S::from_f64(kind as f64), x, y]
    }

    /// Converts such numbers to the mode; other numbers give a smooth one.
    pub(super) fn of_numbers<S: Scalar>([kind, x, y]: [S; 3]) -> Self {
        let heading = Heading::new([x, y]);
        let kind = (0..SMOOTH).find(|number| kind == S::from_f64(*number as f64)).unwrap_or(SMOOTH);
        match kind {
            SMOOTH => Mode::Smooth,
            ACROSS.. => Mode::Across(friction_of(kind - ACROSS, heading)),
            FIRST.. => Mode::Friction(friction_of(kind - FIRST, heading)),
            _ => Mode::Contact(CONTACTS[kind]),
        }
    }
}

fn kind_of(friction: Friction, first: usize) -> (usize, Option<Heading>) {
    match friction {
        Friction::SlipsTowards(heading, _) => (first + FRICTIONS.len(), Some(heading)),
        _ => (first + FRICTIONS.iter().position(|other| *other == friction).unwrap_or(0), None),
    }
}

fn friction_of(kind: usize, heading: Heading) -> Friction {
    FRICTIONS.get(kind).copied().unwrap_or(Friction::SlipsTowards(heading, Pace::ZERO))
}
