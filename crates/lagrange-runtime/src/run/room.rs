//! Room for declared events: the size of the arrays that a run searches them with.
//!
//! Arrays are as long as the next of three lengths, so that a ball with one event does not pay for
//! hundreds. The length follows from constants, and only one of the branches is compiled, except
//! for systems that are read at run time.

/// Room for the events of most systems.
pub(crate) const FEW: usize = 8;
/// Room for many events.
pub(crate) const MANY: usize = 64;

/// Evaluates an expression with a constant: an upper bound of the number of declared events of a
/// system.
macro_rules! with_room {
    ($system:expr, $type:ty, $room:ident => $body:expr) => {
        if const { <$type as $crate::system::OdeSystem>::MAX_EVENTS <= $crate::run::room::FEW } {
            const $room: usize = $crate::run::room::FEW;
            $body
        } else if const { <$type as $crate::system::OdeSystem>::MAX_EVENTS <= $crate::run::room::MANY }
            || $crate::system::OdeSystem::events($system).len() <= $crate::run::room::MANY
        {
            const $room: usize = $crate::run::room::MANY;
            $body
        } else {
            const $room: usize = $crate::system::MAX_LOCATED;
            $body
        }
    };
}

pub(crate) use with_room;
