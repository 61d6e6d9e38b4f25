//! Room for declared events: the length of the arrays with which a run searches for them.
//!
//! It is the next of four lengths, so that a ball with one event does not pay for hundreds. The
//! length follows from constants, and only one of the branches is compiled, except for systems that
//! are read at run time.

/// The lengths below the greatest, `MAX_LOCATED`.
pub(crate) const ROOMS: [usize; 3] = [2, 8, 64];

/// Evaluates an expression with a constant: an upper bound of the number of declared events of a
/// system.
macro_rules! with_room {
    ($system:expr, $type:ty, $room:ident => $body:expr) => {
        if const { <$type as $crate::system::OdeSystem>::MAX_EVENTS <= $crate::run::room::ROOMS[0] } {
            const $room: usize = $crate::run::room::ROOMS[0];
            $body
        } else if const { <$type as $crate::system::OdeSystem>::MAX_EVENTS <= $crate::run::room::ROOMS[1] } {
            const $room: usize = $crate::run::room::ROOMS[1];
            $body
        } else if const { <$type as $crate::system::OdeSystem>::MAX_EVENTS <= $crate::run::room::ROOMS[2] }
            || $crate::system::OdeSystem::events($system).len() <= $crate::run::room::ROOMS[2]
        {
            const $room: usize = $crate::run::room::ROOMS[2];
            $body
        } else {
            const $room: usize = $crate::system::MAX_LOCATED;
            $body
        }
    };
}

pub(crate) use with_room;
