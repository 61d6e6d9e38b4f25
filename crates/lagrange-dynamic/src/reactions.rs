//! Reactions of contacts and friction: their names, and the room for them.
//!
//! The code of contacts is compiled for few numbers of velocities and reactions. Systems with fewer
//! are filled with zeros and with open contacts, which changes no bit of a motion. Emitted code
//! treats systems with more reactions than velocities in another way, and so do the rooms here.

use lagrange_core::emit::ModeOfReaction;
use lagrange_core::pipeline::Programs;
use lagrange_runtime::contact::{Contact, Friction, Mode};

/// Maximum number of velocities, and of reactions, of systems with contacts or friction.
pub(crate) const MAX_COUNTS: [usize; 2] = [32, 48];

/// Numbers of velocities and reactions for which code of contacts is compiled.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Room {
    /// 8 velocities, 8 reactions.
    Small,
    /// 8 velocities, 24 reactions.
    SmallRedundant,
    /// 32 velocities, 32 reactions.
    Large,
    /// 32 velocities, 48 reactions.
    LargeRedundant,
}

impl Room {
    /// Returns the room of a system; `None` if it is too large.
    pub(crate) fn of(programs: &Programs) -> Option<Room> {
        let (velocities, reactions) = (programs.layout.velocities, programs.layout.reactions);
        let fits = |[n, k]: [usize; 2]| velocities <= n && reactions <= k;
        match reactions <= velocities {
            true if fits([8, 8]) => Some(Room::Small),
            false if fits([8, 24]) => Some(Room::SmallRedundant),
            true if fits([32, 32]) => Some(Room::Large),
            false if fits([32, 48]) => Some(Room::LargeRedundant),
            _ => None,
        }
    }
}

/// Computes with the constants `$N` and `$K` of the room of a system.
macro_rules! in_room {
    ($system:expr, $N:ident, $K:ident, $body:expr) => {
        match $system.names.room {
            $crate::reactions::Room::Small => {
                const $N: usize = 8;
                const $K: usize = 8;
                $body
            }
            $crate::reactions::Room::SmallRedundant => {
                const $N: usize = 8;
                const $K: usize = 24;
                $body
            }
            $crate::reactions::Room::Large => {
                const $N: usize = 32;
                const $K: usize = 32;
                $body
            }
            $crate::reactions::Room::LargeRedundant => {
                const $N: usize = 32;
                const $K: usize = 48;
                $body
            }
        }
    };
}
pub(crate) use in_room;

/// A reaction, with static names.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NamedReaction {
    pub(crate) name: &'static str,
    pub(crate) mode: ModeOfReaction,
    pub(crate) event: Option<usize>,
    pub(crate) limit_reverses: bool,
    pub(crate) gradient_jumps: bool,
}

/// Returns the mode in which a system is created.
pub(crate) fn initial_mode(mode: ModeOfReaction) -> Mode {
    match mode {
        ModeOfReaction::Contact => Mode::Contact(Contact::Open),
        ModeOfReaction::Friction => Mode::Friction(Friction::Slips),
        ModeOfReaction::Across => Mode::Across(Friction::Slips),
        ModeOfReaction::Smooth => Mode::Smooth,
    }
}
